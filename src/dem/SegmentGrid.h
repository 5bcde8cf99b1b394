#pragma once

#include <vector>

#include "dem/ContactSurface.h"
#include "dem/Facets.h"

namespace mpsDem {

/// Uniform grid of cells over the sides of a polyline: which of them are near a point, without looking at all.
class SegmentGrid
{
public:
    SegmentGrid() = default;

    /// @param cell  Wanted size of a cell [m]; larger where the grid would have more than about a million cells.
    SegmentGrid(std::vector<Facet> const& facets, Real cell);

    /// Indices, rising and without doubles, of all sides that come within `reach` of r (and some farther ones).
    void near(Vector const& r, Real reach, std::vector<int>& indices) const;

private:
    [[nodiscard]] int column(Real x) const;
    [[nodiscard]] int row(Real y) const;
    template <class Visitor>
    void visitCells(Facet const& facet, Visitor&& visit) const;

    Box box_;
    Real cell_ = 1;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<int> first_;   ///< Begin of each cell's entries; one more than cells.
    std::vector<int> entries_; ///< Indices of sides.
};

} // namespace mpsDem
