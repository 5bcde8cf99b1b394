#pragma once

#include <span>
#include <vector>

#include "core/Polyline.h"
#include "core/Types.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Wall and ghost particles of a set of surfaces, equal lengths.
struct BoundaryRows
{
    Field<Vector> position;   ///< [m]
    Field<Vector> normal;     ///< Unit normal of the surface into the fluid.
    Field<ParticleType> type; ///< Wall or Ghost.
    Field<int> chain;         ///< Number of the surface it belongs to.
};

/// Number of ghost rows behind the wall row: ceil(r_e / l0 - 1/2), so that no kernel reaches behind the last row.
/// @param radius  Largest effective radius over the spacing, r_e / l0.
int ghostRowsFor(Real radius);

/// Rows of particles behind surfaces.
///
/// Row k lies (k + 1/2) l0 behind the surface, on its solid side, evenly spaced by nearly l0 (M = round(L / l0) particles). A row runs
/// smoothly through bends of up to 20 degrees: a straight surface cut into many pieces and a polygon that stands for a circle get the
/// particles of the line and of the circle. At sharper corners each side has its own row, and
/// - in a corner of the fluid the rows are completed by a particle on the bisector and continued past the corner, so that the kernel of a
///   particle in the corner is full;
/// - at an edge of the solid the rows are shortened: a particle that is nearer to another segment than its own depth (less 0.02 l0)
///   belongs to a nearer row and is dropped; only in tips sharper than 90 degrees the wall row may come to 0.2 l0 of the other side;
/// - no particle lies on the fluid side or within 0.7 l0 of one already placed;
/// - beyond an open end that meets no other surface the rows go on as ghosts, ghostRows + 2 particles.
/// Row 0 is Wall, others are Ghost; continued particles are Wall only where they lie within 0.75 l0 of a surface.
/// Surfaces know of each other: a ramp and a floor given as two polylines join as one would.
///
/// @param chains     Fixed walls together, or the outline of one body.
/// @param ghostRows  For each chain the number of rows behind the wall row, >= 0.
/// @param spacing    l0 [m].
BoundaryRows boundaryRows(std::span<Polyline const> chains, std::span<int const> ghostRows, Real spacing);

} // namespace mpsDem
