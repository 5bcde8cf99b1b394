#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/Errors.h"
#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// Facets as a file lists them: each with three corners of its own, nothing said about neighbours.
struct FacetSoup
{
    using Facet = std::array<Vector, 3>;

    Location file;             ///< Named in messages.
    std::vector<Facet> facets; ///< [m], counter-clockwise as seen from the fluid.
    std::vector<int> lines;    ///< Where each begins; empty for a binary file.
    int solids = 1;            ///< Blocks solid ... endsolid that the file lists them in.

    /// "facet 12 at constant/triSurface/slide.stl:85"-like place of a facet, counted from 1 as users do.
    [[nodiscard]] Location place(std::size_t facet) const;
};

/// What a surface that is made of facets has to be.
enum class Skin
{
    Open,   ///< A wall: rims are fine, normals stay on the side on which the facets have them.
    Closed, ///< Of a region: no rim; normals of each shell outwards; what lies in two shells counts once.
    Body    ///< The same for a body, whose volume is that of all shells: it must not cut through itself.
};

/// Joins facets to a surface.
///
/// - Corners nearer to each other than 1e-9 of the extent become one point.
/// - Facets with two equal corners or given twice are left out. One whose corners lie in a line (within 1e-7 of the extent, the digits of
///   a file of floats) is joined to its neighbour, so that no crack remains. Notes in the log say how many and name the first.
/// - Of Skin::Closed and Skin::Body, shells that are inside out are turned, with a note; several shells count as one solid; none may lie within
///   another.
/// @throw CaseError BadInput with the number of the facet, counted from 1: a corner that is not finite or beyond 1e9 m, an edge of more than
///        two facets, two facets back to back, facets that wind the other way than most of their connected piece, a piece that has no two
///        sides (Moebius), of Skin::Closed and Skin::Body rims (how many, where), shells without volume, shells within others, and of
///        Skin::Body facets that cut through each other.
TriSurface joinFacets(FacetSoup const& soup, std::string const& name, Skin skin);

} // namespace mpsDem
