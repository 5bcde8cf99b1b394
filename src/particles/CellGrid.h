#pragma once

#include <array>
#include <span>

#include "core/Types.h"

namespace mpsDem {

/// Uniform grid of cells with the particles of each cell side by side, built by one counting sort.
///
/// Cells are numbered x fastest. Within a cell particles keep the order of their numbers, so every sum over neighbours has one order.
class CellGrid
{
public:
    /// Sorts positions into cells.
    /// @param positions  N points [m].
    /// @param cellSize   Edge of a cell [m]; made larger where a few far particles would ask for more than 8 N + 1000 cells.
    /// @param dimensions 2 or 3.
    /// @throw CaseError NotFinite for a position or a cell size that is no number, and for points further apart than a number can tell;
    ///        Memory for more points than cells can be counted for.
    void build(std::span<Vector const> positions, Real cellSize, int dimensions);

    /// Numbers of the particles, cell by cell.
    [[nodiscard]] Field<int> const& order() const { return order_; }

    /// Cell of a position; positions outside are moved to the border cells.
    [[nodiscard]] int cellOf(Vector const& r) const;
    [[nodiscard]] int cellCount() const { return count_[0] * count_[1] * count_[2]; }
    /// Number of cells that so many points may ever ask for.
    [[nodiscard]] std::size_t mostCells() const { return start_.capacity(); }

    /// Positions in the order of `order()`.
    [[nodiscard]] Field<Vector> const& sortedPositions() const { return sorted_; }

    /// Cell of point i.
    [[nodiscard]] int cellOfPoint(int i) const { return cell_[static_cast<std::size_t>(i)]; }

    /// Calls visit(first, last) for each run of consecutive slots in `order()` that may hold points within `reach` of r.
    template <class Visit>
    void forEachRun(Vector const& r, Real reach, Visit visit) const
    {
        forEachCellRun(r, reach, [&](int first, int last) { visit(start_[first], start_[last]); });
    }

    /// Calls visit(first, last) for each run of consecutive cells that may hold points within `reach` of r.
    template <class Visit>
    void forEachCellRun(Vector const& r, Real reach, Visit visit) const
    {
        std::array<int, 3> low{}, high{};
        for (int d = 0; d < 3; ++d)
        {
            low[d] = coordinate(r[d] - reach, d);
            high[d] = coordinate(r[d] + reach, d);
        }
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
            {
                int const row = (k * count_[1] + j) * count_[0];
                visit(row + low[0], row + high[0] + 1);
            }
    }

    /// Calls visit(number, rij, r2) for each point within `reach` of r, in cell order; rij = its position - r.
    template <class Visit>
    void forEachWithin(Vector const& r, Real reach, Visit visit) const
    {
        Real const reach2 = reach * reach;
        forEachRun(r, reach, [&](int first, int last) {
            for (int slot = first; slot < last; ++slot)
            {
                Vector const rij = sorted_[slot] - r;
                Real const r2 = rij.squaredNorm();
                if (r2 < reach2) visit(order_[slot], rij, r2);
            }
        });
    }

private:
    [[nodiscard]] int coordinate(Real x, int d) const
    {
        Real const c = (x - origin_[d]) * inverseSize_;
        if (!(c > 0)) return 0; // no number: as good as any other cell
        return c >= count_[d] - 1 ? count_[d] - 1 : static_cast<int>(c);
    }

    Vector origin_ = Vector::Zero();
    Real inverseSize_ = 0;
    std::array<int, 3> count_{1, 1, 1};
    Field<int> start_, order_, cell_;
    Field<Vector> sorted_;
};

} // namespace mpsDem
