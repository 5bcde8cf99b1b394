#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/TriSurface.h"
#include "io/FacetSoup.h"

namespace mpsDem {

/// Triangles that share points, before they are known to be a surface.
struct FacetMesh
{
    /// One side of a triangle, its points in rising order.
    struct Side
    {
        int low, high;
        int triangle;
        bool forwards; ///< The triangle runs from low to high.
    };

    std::vector<Vector> points;
    std::vector<TriSurface::Corners> triangles;
    std::vector<int> facet; ///< Of the file, of each triangle.

    void add(TriSurface::Corners const& corners, int ofFacet);
    /// Removes the triangles that are marked.
    void erase(std::vector<char> const& marked);
    /// Over the longest side [m].
    [[nodiscard]] Real height(TriSurface::Corners const& corners) const;
    /// Sides of all triangles, those between the same points beside each other.
    [[nodiscard]] std::vector<Side> sides() const;
    /// The point opposite of a triangle's longest side, and the triangle beyond that side: -1 unless there is just one.
    [[nodiscard]] std::pair<int, int> acrossLongest(std::vector<Side> const& sides, int triangle) const;
    /// Cuts the triangle in two at a point that lies on the side which it shares with `line`; the second part takes the place of `line`.
    void split(int triangle, int line, int point);
    /// Centre of a side [m].
    [[nodiscard]] Vector middle(Side const& side) const;
};

/// Refuses triangles that do not agree within a connected piece; with `closed`, turns shells outwards. See joinFacets() for what is refused.
void orientFacets(FacetMesh& mesh, FacetSoup const& soup, bool closed, std::string const& name);

/// "(1 2.5 0)".
std::string placeText(Vector const& r);

} // namespace mpsDem
