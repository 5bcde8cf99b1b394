#include "scene/CaseConstants.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/Errors.h"
#include "particles/SchemeSet.h"
#include "scene/EntryText.h"

namespace mpsDem {

namespace {

Real constexpr largest = 1e30;

/// Effective radii over the spacing where mpsSchemes doesn't give them.
Real constexpr defaultRadius = 2.1;
Real constexpr paperLaplacianRadius = 4.01;

} // namespace

CaseFolder::CaseFolder(std::filesystem::path root) : root_(std::move(root))
{
    require(std::filesystem::is_directory(root_), Location{}, "the case folder \"" + root_.string() + "\" does not exist");
    require(std::filesystem::exists(root_ / "system" / "controlDict"), Location{},
            "\"" + root_.string() + "\" is no case: it has no system/controlDict", "run in the folder of a case, or name it: -case <dir>");
}

Dictionary CaseFolder::read(std::filesystem::path const& file, std::string const& headerClass) const
{
    auto found = readIfPresent(file, headerClass);
    require(found.has_value(), Location{file.string(), 0, {}}, "the file is missing",
            "a dictionary with a FoamFile header; see etc/caseDicts");
    return std::move(*found);
}

std::optional<Dictionary> CaseFolder::readIfPresent(std::filesystem::path const& file, std::string const& headerClass) const
{
    std::filesystem::path const path = file.is_absolute() ? file : root_ / file;
    if (!std::filesystem::exists(path)) return std::nullopt;
    Dictionary dict = Dictionary::fromFile(path, root_);
    dict.requireHeader(headerClass);
    return dict;
}

Lattice readLattice(Dictionary const& particleProperties)
{
    Lattice lattice;
    lattice.dimensions = particleProperties.getOr<int>("dimensions", 2);
    require(lattice.dimensions == 2 || lattice.dimensions == 3, particleProperties.where("dimensions"),
            "dimensions " + std::to_string(lattice.dimensions) + " is not supported", "2 (the x-y plane) or 3");
    lattice.spacing = readPositive(particleProperties, "spacing");
    require(lattice.dimensions == 2 || !particleProperties.found("thickness"), particleProperties.where("thickness"),
            "thickness is the width of a 2-D case", "leave it out in 3-D; or dimensions 2");
    if (particleProperties.found("thickness")) lattice.thickness = readPositive(particleProperties, "thickness");
    particleProperties.requireAllRead();
    return lattice;
}

Vector readGravity(CaseFolder const& caseFolder, int dimensions)
{
    auto const dict = caseFolder.readIfPresent("constant/g", "uniformDimensionedVectorField");
    if (!dict) return Vector::Zero();
    std::vector<std::string> const expected{"[", "0", "1", "-2", "0", "0", "0", "0", "]"};
    if (dict->found("dimensions"))
        require(dict->entryTokens("dimensions") == expected, dict->where("dimensions"), "gravity has other dimensions than m/s2",
                "dimensions [0 1 -2 0 0 0 0];");
    Vector const g = dict->getDimensionedVector("value", {0, 1, -2, 0, 0, 0, 0});
    require(g.allFinite(), dict->where("value"), "gravity is not finite");
    require(dimensions == 3 || g.z() == 0, dict->where("value"), "gravity leaves the x-y plane", "a 2-D case lies in the plane z = 0");
    dict->requireAllRead();
    return g;
}

Real readFluidDensity(Dictionary const& transportProperties)
{
    Real const rho = transportProperties.getDimensioned("rho", {1, -3, 0, 0, 0, 0, 0});
    require(std::isfinite(rho) && rho > 0, transportProperties.where("rho"), "rho is not positive", "a density above 0 kg/m3");
    return rho;
}

Radii readRadii(Dictionary const& mpsSchemes, Real spacing)
{
    Dictionary const kernel = mpsSchemes.subDictOrEmpty("kernel");
    static_cast<void>(kernel.getWordOr("type", "zhang", {"zhang"}, "kernels"));
    Real const laplacian = readSchemeSet(mpsSchemes) == SchemeSet::Paper ? paperLaplacianRadius : defaultRadius;
    return {spacing * kernel.getInRangeOr("gradient", defaultRadius, 1.2, 6),
            spacing * kernel.getInRangeOr("laplacian", laplacian, 1.2, 6)};
}

Real largestKernelRadius(CaseFolder const& caseFolder)
{
    auto const schemes = caseFolder.readIfPresent("system/mpsSchemes");
    return schemes ? readRadii(*schemes, 1).largest() : defaultRadius;
}

PeriodicImages readPeriodicBox(Dictionary const& mpsSchemes)
{
    Dictionary const cyclic = mpsSchemes.subDictOrEmpty("cyclic");
    Vector const none = Vector::Zero();
    return {cyclic.getOr<Vector>("min", none), cyclic.getOr<Vector>("max", none)};
}

PeriodicImages readPeriodicBox(CaseFolder const& caseFolder)
{
    return readPeriodicBox(caseFolder.readIfPresent("system/mpsSchemes").value_or(Dictionary()));
}

Real readStartTime(CaseFolder const& caseFolder)
{
    return caseFolder.read("system/controlDict").getInRangeOr("startTime", 0, -largest, largest);
}

std::string timeName(Real time)
{
    std::ostringstream text;
    text << time;
    return text.str();
}

} // namespace mpsDem
