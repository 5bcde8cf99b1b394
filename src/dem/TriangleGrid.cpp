#include "dem/TriangleGrid.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

namespace {

constexpr Real fewestCells = 32768; ///< So many cells any grid may have.
constexpr Real mostCells = 2e6;

Real cellCount(Vector const& size, Real cell) { return ((size / cell).array().floor() + 1).prod(); }

} // namespace

TriangleGrid::TriangleGrid(TriSurface const& surface, Real cell) : cell_(cell)
{
    for (Vector const& r : surface.points()) box_.add(r);
    Vector const size = box_.high - box_.low;
    Real const most = std::clamp(8.0 * static_cast<Real>(surface.triangles().size()), fewestCells, mostCells);
    while (cellCount(size, cell_) > most) cell_ *= 1.1;
    for (int axis = 0; axis < 3; ++axis) cells_[static_cast<std::size_t>(axis)] = 1 + static_cast<int>(size[axis] / cell_);

    std::size_t const count =
        static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(cells_[2]);
    first_.assign(count + 1, 0);
    for (auto const& t : surface.triangles()) visitCells(surface, t, [&](std::size_t c) { ++first_[c + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    entries_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<int> fill(first_.begin(), first_.end() - 1);
    int number = 0;
    for (auto const& t : surface.triangles())
    {
        visitCells(surface, t, [&](std::size_t c) { entries_[static_cast<std::size_t>(fill[c]++)] = number; });
        ++number;
    }
}

TriangleGrid::Cell TriangleGrid::cellOf(Vector const& r) const
{
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis)
        cell[static_cast<std::size_t>(axis)] = static_cast<int>(
            std::clamp(std::floor((r[axis] - box_.low[axis]) / cell_), Real(0), Real(cells_[static_cast<std::size_t>(axis)] - 1)));
    return cell;
}

template <class Visitor>
void TriangleGrid::visitCells(TriSurface const& surface, TriSurface::Triangle const& triangle, Visitor&& visit) const
{
    // Cells of the triangle's box, a little wider, that neither its plane nor the planes through its sides keep apart from it.
    Vector const margin = Vector::Constant(1e-3 * cell_);
    Box box;
    for (int k = 0; k < 3; ++k) box.add(surface.point(triangle, k));
    Cell const low = cellOf(box.low - margin);
    Cell const high = cellOf(box.high + margin);
    std::array<Vector, 5> axes{triangle.normal, -triangle.normal};
    std::array<Vector, 5> from{surface.point(triangle, 0), surface.point(triangle, 0)};
    std::array<Real, 5> halfWidth{};
    for (int k = 0; k < 3; ++k)
    {
        from[k + 2] = surface.point(triangle, k);
        axes[k + 2] = (surface.point(triangle, (k + 1) % 3) - from[k + 2]).cross(triangle.normal).normalized();
    }
    for (std::size_t n = 0; n < axes.size(); ++n) halfWidth[n] = 0.502 * cell_ * axes[n].cwiseAbs().sum();
    auto const apart = [&](Vector const& middle) {
        for (std::size_t n = 0; n < axes.size(); ++n)
            if ((middle - from[n]).dot(axes[n]) > halfWidth[n]) return true;
        return false;
    };
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
            for (int i = low[0]; i <= high[0]; ++i)
            {
                Vector const middle = box_.low + cell_ * Vector(i + 0.5, j + 0.5, k + 0.5);
                if (apart(middle)) continue;
                visit((static_cast<std::size_t>(k) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(j)) *
                          static_cast<std::size_t>(cells_[0]) +
                      static_cast<std::size_t>(i));
            }
}

void TriangleGrid::near(Vector const& r, Real reach, std::vector<int>& numbers) const
{
    numbers.clear();
    if (box_.distance(r) > reach) return;
    Cell const low = cellOf(r - Vector::Constant(reach));
    Cell const high = cellOf(r + Vector::Constant(reach));
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
        {
            // Cells of one row lie side by side, and so do their entries.
            std::size_t const row = (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(j)) *
                                    static_cast<std::size_t>(cells_[0]);
            numbers.insert(numbers.end(), entries_.begin() + first_[row + static_cast<std::size_t>(low[0])],
                           entries_.begin() + first_[row + static_cast<std::size_t>(high[0]) + 1]);
        }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace mpsDem
