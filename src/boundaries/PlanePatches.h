#pragma once

#include <vector>

#include "boundaries/JoinedSurfaces.h"
#include "core/Types.h"

namespace mpsDem {

/// Plane piece of a surface with the feet of its particles: lines along its longest side.
struct PlanePatch
{
    struct Foot
    {
        Vector point; ///< In the plane [m].
        int beyond;   ///< 0 within the patch; n: the nth particle past its border.
    };

    int face;      ///< One of its faces.
    Vector normal; ///< Unit vector into the fluid.
    std::vector<Foot> feet;
};

/// Plane patches worth lines of particles: those with sharp borders or rims all round, if their sides are not much shorter than l0, and
/// those that are 5 l0 wide at least.
struct PlanePatches
{
    std::vector<PlanePatch> patches;
    std::vector<char> covers; ///< For each face of the surfaces: 1 where a patch holds it.
};

/// Sharp are edges whose faces bend by more than 20 degrees.
bool isSharp(JoinedSurfaces const& surfaces, JoinedSurfaces::Edge const& edge);

/// @param beyond  For each surface the number of particles past a border of its patches; past a rim there is one more.
PlanePatches planePatches(JoinedSurfaces const& surfaces, Real spacing, std::vector<int> const& beyond);

} // namespace mpsDem
