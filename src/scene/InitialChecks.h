#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/Surface.h"
#include "core/Types.h"
#include "scene/InitialState.h"

namespace mpsDem {

/// Least signed distance of one body from walls or from another body: negative where they overlap.
struct Gap
{
    Real distance = 0; ///< [m]
    Vector place = Vector::Zero();
    Vector normal = Vector::Zero(); ///< Of the wall or body there.
    int other = -1;                 ///< Number of the wall or body.
};

/// Nearest approach of an outline to surfaces: corners and points of its segments at most a quarter of a spacing apart (of its triangles
/// half a spacing) against the surfaces, and corners of the surfaces against the outline. Beside the end of an open surface nothing
/// overlaps. `other` is -1 where there are no surfaces.
/// @param up  Of places that are equally near within 1e-6 spacings the one whose surface faces most along `up` counts (a slide between side
///            walls stands on the ramp); zero: the first one.
Gap gapTo(Surface const& outline, std::vector<Surface> const& surfaces, Real spacing, Vector const& up = Vector::Zero());

/// Distance of the boxes along the axes that hold two surfaces [m]: no more than that of the surfaces; 0 where they overlap.
Real boxDistance(Surface const& a, Surface const& b);

/// Refuses bodies that reach more than half a spacing into a wall or more than 0.05 spacings into each other.
void checkPlacement(SceneDefinition const& definition, std::vector<Surface> const& surfaces, std::vector<Surface> const& bodies);

/// Refuses a region without a lattice point and fluid of which nothing is left beside the solids.
void checkFilling(SceneDefinition const& definition, FluidFilling const& fluid);

/// Distance of each of some points from its nearest neighbour [m]; infinite beyond `reach`. @param points  Where neighbours are looked for.
/// @param of  The points among them that the result is for.
std::vector<Real> nearestDistances(std::span<Vector const> points, Range const& of, Real reach, int dimensions);

} // namespace mpsDem
