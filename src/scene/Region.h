#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Registry.h"
#include "core/Types.h"
#include "particles/Lattice.h"
#include "scene/EntryText.h"

namespace mpsDem {

/// A part of space that setParticles fills with fluid: an entry of `regions`. Names and keys as OpenFOAM's topoSetSources.
///
/// | region               | key               | meaning                                                     | unit |
/// |----------------------|-------------------|-------------------------------------------------------------|------|
/// | boxToParticle        | box (..) (..)     | two opposite corners; or min and max                        | m    |
/// | rotatedBoxToParticle | origin            | one corner                                                  | m    |
/// |                      | i, j, (k)         | edges from it (k is not used in 2-D)                        | m    |
/// | cylinderToParticle   | p1 p2 radius      | ends of the axis (2-D: along z), radius                     | m    |
/// | sphereToParticle     | origin radius     | centre, radius (2-D: a disc)                                | m    |
/// | surfaceToParticle    | file, scale ...   | closed surface (3-D only), see readSurfaceFile()            |      |
/// | all                  | fieldValues       | values that its particles get, see FieldValues              | SI   |
///
/// 2-D regions are taken in the plane z = 0. Sides with low coordinates belong to a box, those with high ones do not, so that a lattice with
/// points on two opposite sides fills it with the right number of particles; the ends of a cylinder likewise.
class Region
{
public:
    virtual ~Region() = default;

    /// Whether the point [m] lies within or on the border.
    [[nodiscard]] virtual bool contains(Vector const& r) const = 0;
    /// Corners of a box that holds the region.
    [[nodiscard]] virtual Vector low() const = 0;
    [[nodiscard]] virtual Vector high() const = 0;
    /// Distance [m] that a point of the region has to go along the unit vector `up` to leave it for the first time.
    [[nodiscard]] virtual Real exitDistance(Vector const& r, Vector const& up) const = 0;

    std::string type;   ///< Word of the dictionary.
    Location where;     ///< Place in it.
    FieldValues values; ///< Of `fieldValues`.
};

/// What regions need to know of the case.
struct RegionCase
{
    Lattice lattice;
    std::filesystem::path folder; ///< Of the case.
};

using RegionRegistry = Registry<Region, Dictionary const&, RegionCase const&>;

/// All regions known; add own ones here before a case is read.
RegionRegistry& regionRegistry();

/// Reads the list `regions`; empty where it is absent.
/// @param caseFolder  Where files of surfaces are looked for.
/// @throw CaseError for an unknown region (with the nearest), an empty one or a bad entry.
std::vector<std::unique_ptr<Region>> readRegions(Dictionary const& setParticlesDict, Lattice const& lattice,
                                                 std::filesystem::path const& caseFolder = {});

} // namespace mpsDem
