#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/Dictionary.h"
#include "core/Types.h"
#include "particles/Lattice.h"
#include "particles/NeighbourList.h"
#include "particles/PeriodicImages.h"

namespace mpsDem {

/// Folder of a case and its dictionaries.
class CaseFolder
{
public:
    /// @throw CaseError BadInput where the folder is missing or has no system/controlDict.
    explicit CaseFolder(std::filesystem::path root);

    [[nodiscard]] std::filesystem::path const& root() const { return root_; }

    /// A dictionary that the case must have, header checked. @param file  Relative to the case, or absolute.
    [[nodiscard]] Dictionary read(std::filesystem::path const& file, std::string const& headerClass = "dictionary") const;

    /// One that may be absent: the effect is absent then.
    [[nodiscard]] std::optional<Dictionary> readIfPresent(std::filesystem::path const& file,
                                                          std::string const& headerClass = "dictionary") const;

private:
    std::filesystem::path root_;
};

/// Reads constant/particleProperties.
///
/// | key        | meaning                            | unit | default | range |
/// |------------|------------------------------------|------|---------|-------|
/// | dimensions | 2: x-y plane; or 3                 | -    | 2       | 2, 3  |
/// | spacing    | distance of particles at the start | m    | none    | > 0   |
/// | thickness  | width in z that 2-D stands for     | m    | 1       | > 0   |
Lattice readLattice(Dictionary const& particleProperties);

/// Gravity [m/s2] of constant/g (`dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);`); zero where the file is absent.
/// @param dimensions  2: it must lie in the x-y plane.
Vector readGravity(CaseFolder const& caseFolder, int dimensions);

/// Density of the fluid [kg/m3], `rho` of constant/transportProperties.
Real readFluidDensity(Dictionary const& transportProperties);

/// Effective radii [m] of `kernel` in system/mpsSchemes: gradient 2.1, laplacian 2.1 (4.01 in the set `paper`), in spacings.
Radii readRadii(Dictionary const& mpsSchemes, Real spacing);

/// The largest of them over the spacing; 2.1 where the file is absent.
Real largestKernelRadius(CaseFolder const& caseFolder);

/// The periodic box `cyclic { min (..); max (..); }` of system/mpsSchemes; no periodic direction without it.
PeriodicImages readPeriodicBox(Dictionary const& mpsSchemes);
PeriodicImages readPeriodicBox(CaseFolder const& caseFolder);

/// Start time of a new run [s], `startTime` of system/controlDict (default 0), and the name of its folder.
Real readStartTime(CaseFolder const& caseFolder);
std::string timeName(Real time);

} // namespace mpsDem
