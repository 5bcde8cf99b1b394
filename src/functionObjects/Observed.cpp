#include "functionObjects/Observed.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

bool isPlain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '+' || c == '-' || c == '.';
}

} // namespace

std::string startTimeName(Real startTime) { return shortNumber(startTime); }

void requireFileName(std::string const& name, Location const& where)
{
    bool const plain = !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), isPlain);
    require(plain, where, "\"" + name + "\" cannot be the name of a file", "letters, digits and _ + - . are allowed, not . in front");
}

TableFile makeTable(RunContext const& context, std::string const& object, std::string const& file, std::vector<std::string> columns,
                    std::vector<std::string> header)
{
    TableFile::Options options;
    options.header = std::move(header);
    return {context.caseRoot, object, startTimeName(context.startTime), file, std::move(columns), std::move(options)};
}

void requireFluid(RunContext const& context, Dictionary const& dict)
{
    require(context.particles.fluid().size() > 0, dict.where(), "this function object watches fluid, but the case has none",
            "remove it, or give the case constant/transportProperties and a region of fluid");
}

std::vector<int> readBodies(RunContext const& context, Dictionary const& dict)
{
    require(!context.bodies.empty(), dict.where(), "this function object watches rigid bodies, but the case has none",
            "remove it, or give the case constant/rigidBodyProperties");
    std::vector<std::string> known;
    for (auto const& body : context.bodies) known.push_back(body->name());
    std::vector<int> numbers;
    for (std::string const& name : dict.getOr<std::vector<std::string>>("bodies", known))
    {
        auto const found = std::find(known.begin(), known.end(), name);
        require(found != known.end(), dict.where("bodies"), "there is no body \"" + name + "\"", knownWords("bodies", name, known));
        numbers.push_back(static_cast<int>(found - known.begin()));
    }
    require(!numbers.empty(), dict.where("bodies"), "bodies is an empty list", "at least one of the case's bodies, or no such entry");
    return numbers;
}

Vector readUp(RunContext const& context, Dictionary const& dict)
{
    Vector const direction = dict.getOr<Vector>("direction", -context.gravity);
    require(direction.allFinite() && direction.norm() > 0, dict.where("direction"), "the direction of elevation is zero",
            "the key direction, where there is no gravity");
    bool const planar = context.particles.lattice().dimensions == 2;
    require(!planar || std::abs(direction.z()) < 1e-12 * direction.norm(), dict.where("direction"),
            "the direction of elevation leaves the x-y plane of a 2-D case", "a direction with z = 0");
    return direction.normalized();
}

void addVectorColumns(std::vector<std::string>& columns, std::string const& name)
{
    for (char const axis : {'x', 'y', 'z'}) columns.push_back(name + axis);
}

void addVector(std::vector<Real>& values, Vector const& vector) { values.insert(values.end(), vector.data(), vector.data() + 3); }

std::string text(Vector const& vector)
{
    return "(" + shortNumber(vector.x()) + " " + shortNumber(vector.y()) + " " + shortNumber(vector.z()) + ")";
}

Real fluidMass(RunContext const& context)
{
    return context.density * context.particles.lattice().particleVolume() * sumOverRanks(context.particles.fluid().size());
}

} // namespace mpsDem
