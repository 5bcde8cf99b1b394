#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "boundaries/JoinedSurfaces.h"
#include "core/Types.h"

namespace mpsDem {

/// Edges go on as one chain where they bend by less than 20 degrees.
inline Real const straightCosine = std::cos(20.0 * std::numbers::pi / 180);

/// Rows of a corner exist where the bisector is no longer: fluid angles above 60 degrees.
inline constexpr Real longestBisector = 2.0;

/// Of two faces with the unit normals n and m: (n + m) / (1 + n . m), which is as far from both planes as a unit vector along its normal.
inline Vector bisectorOf(Vector const& n, Vector const& m) { return (n + m) / std::max(1 + n.dot(m), Real(1e-3)); }

/// Edges in a row that bend by less than 20 degrees from one to the next: a valley or a ridge of the solid, or a rim.
struct EdgeChain
{
    enum class Kind
    {
        Valley, ///< The fluid has less than 160 degrees.
        Ridge,  ///< The solid has less than 160 degrees.
        Rim
    };

    /// A piece of the chain.
    struct Piece
    {
        Vector a, b;     ///< [m]
        Vector depth;    ///< Row k: -(k + 1/2) l0 depth. The bisector, of length 1 / sin(half the angle); at a rim the normal.
        Vector outwards; ///< At a rim: unit vector in the surface, away from it.
        int face;        ///< One of the faces that meet there.
        int edge = -1;   ///< Number of the edge; -1 where surfaces cut through each other.
    };

    /// A particle on it.
    struct Place
    {
        Vector point; ///< [m]
        Vector outwards;
        Vector normal;
        int face;
        int edge;
    };

    Kind kind;
    bool loop = false;
    std::vector<Piece> pieces;

    /// Middles of round(L / spacing) equal parts of the parallel at `depth`.
    [[nodiscard]] std::vector<Place> places(Real depth, Real spacing) const;
};

std::vector<EdgeChain> edgeChains(JoinedSurfaces const& surfaces);

} // namespace mpsDem
