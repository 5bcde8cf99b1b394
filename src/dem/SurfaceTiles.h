#pragma once

#include <vector>

#include "core/TriSurface.h"

namespace mpsDem {

/// Piece of a surface: what of it lies in one cell.
struct SurfaceTile
{
    Real area;     ///< [m2].
    Vector centre; ///< Centre of its area; beside the surface where that is bent [m].
};

/// Cuts triangles into tiles of about `spacing` times `spacing`; their areas sum to that of the triangles and so do first moments.
///
/// A plane piece is cut by a grid along its longest rim with a whole number of cells in both directions, so that tiles of a rectangle are
/// equal; a bent one by cubes. Tiles of less than a third of spacing^2 are joined to the nearest one.
/// @param triangles  Numbers of triangles of one piece. @param plane  They lie in one plane.
std::vector<SurfaceTile> cutIntoTiles(TriSurface const& surface, std::vector<int> const& triangles, bool plane, Real spacing);

} // namespace mpsDem
