#pragma once

#include <array>
#include <vector>

#include "core/TriSurface.h"
#include "dem/ContactSurface.h"

namespace mpsDem {

/// Uniform grid of cells over the triangles of a surface: which of them are near a point, without looking at all.
class TriangleGrid
{
public:
    TriangleGrid() = default;

    /// @param cell  Wanted size of a cell [m]; larger where the grid would have many more cells than the surface has triangles.
    TriangleGrid(TriSurface const& surface, Real cell);

    /// Numbers, rising and without doubles, of all triangles that come within `reach` of r (and some farther ones).
    void near(Vector const& r, Real reach, std::vector<int>& numbers) const;
    /// Box around the surface.
    [[nodiscard]] Box const& box() const { return box_; }

private:
    using Cell = std::array<int, 3>;
    [[nodiscard]] Cell cellOf(Vector const& r) const;
    template <class Visitor>
    void visitCells(TriSurface const& surface, TriSurface::Triangle const& triangle, Visitor&& visit) const;

    Box box_;
    Real cell_ = 1;
    Cell cells_{0, 0, 0};
    std::vector<int> first_;   ///< Begin of each cell's entries; one more than cells.
    std::vector<int> entries_; ///< Numbers of triangles.
};

} // namespace mpsDem
