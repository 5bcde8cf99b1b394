#pragma once

#include <span>

#include "boundaries/BoundaryRows.h"
#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// Rows of particles behind triangle surfaces, by the rules of the rows behind polylines (BoundaryRows.h).
///
/// Row k lies (k + 1/2) l0 behind the surface, on its solid side, about one particle on l0 x l0 of the row.
/// - Plane pieces have lines of particles along their longest side: M = round(L / l0) lines, each of round(L / l0) particles, so that a
///   tank whose sides are multiples of l0 continues the cubic lattice of its fluid.
/// - Bent pieces (spheres, cylinders, bathymetries, rocks) and plane ones of few spacings with a ragged outline have particles spread
///   evenly: darts no nearer than about 0.8 l0, then some steps of mutual repulsion along the row (fixed seed: the same bytes every time).
/// - Along edges where the fluid has less than 160 degrees the rows are completed by particles on the bisector, and lines go on past
///   the edge by ghostRows + 1 particles, so that the kernel of a particle in the corner is full.
/// - At edges of the solid a particle that is nearer to another face than its own depth (less 0.02 l0) is dropped; only in tips sharper
///   than 90 degrees the wall row may come to 0.2 l0 of the other side.
/// - Beyond rims that no other surface touches the rows go on as ghosts, ghostRows + 2 particles.
/// - No particle lies on the fluid side or within 0.7 l0 of another; what remains of holes along edges is filled.
/// - Parts of a surface that lie behind another one have particles only near the line where the two meet.
/// Row 0 is Wall, others are Ghost; particles past an edge are Wall only where they lie within 0.75 l0 of a surface.
///
/// @param surfaces   Fixed walls together, or the skin of one body.
/// @param ghostRows  For each surface the number of rows behind the wall row, >= 0.
/// @param spacing    l0 [m].
BoundaryRows boundaryRows(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real spacing);

} // namespace mpsDem
