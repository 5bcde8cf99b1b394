#include "particles/CellGrid.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

int CellGrid::cellOf(Vector const& r) const
{
    return (coordinate(r.z(), 2) * count_[1] + coordinate(r.y(), 1)) * count_[0] + coordinate(r.x(), 0);
}

void CellGrid::build(std::span<Vector const> positions, Real cellSize, int dimensions)
{
    Vector low = Vector::Zero(), high = Vector::Zero();
    if (!positions.empty()) low = high = positions.front();
    for (Vector const& r : positions)
    {
        low = low.cwiseMin(r);
        high = high.cwiseMax(r);
    }
    origin_ = low;
    Real const most = 8.0 * static_cast<Real>(positions.size()) + 1000;
    Real size = cellSize;
    for (;; size *= 1.25)
    {
        Real cells = 1;
        for (int d = 0; d < dimensions; ++d) cells *= std::floor((high[d] - low[d]) / size) + 1;
        if (cells <= most) break;
    }
    inverseSize_ = 1 / size;
    for (int d = 0; d < 3; ++d) count_[d] = d < dimensions ? static_cast<int>((high[d] - low[d]) * inverseSize_) + 1 : 1;

    std::size_t const n = positions.size();
    cell_.resize(n);
    order_.resize(n);
    sorted_.resize(n);
    start_.reserve(static_cast<std::size_t>(most) + 2); // for whatever the cloud becomes
    start_.assign(static_cast<std::size_t>(cellCount()) + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
    {
        cell_[i] = cellOf(positions[i]);
        ++start_[cell_[i] + 1];
    }
    for (int c = 0; c < cellCount(); ++c) start_[c + 1] += start_[c];
    for (std::size_t i = 0; i < n; ++i)
    {
        int const slot = start_[cell_[i]]++;
        order_[slot] = static_cast<int>(i);
        sorted_[slot] = positions[i];
    }
    for (int c = cellCount(); c > 0; --c) start_[c] = start_[c - 1];
    start_[0] = 0;
}

} // namespace mpsDem
