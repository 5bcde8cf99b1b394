#include "particles/CellGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// Cells allowed: enough for clouds with holes, and few enough to be counted.
constexpr Real cellsPerPoint = 8;
constexpr Real fewestCells = 1000;

/// Lower and upper corner of the points; zeros where there is none.
struct Extent
{
    Vector low = Vector::Zero(), high = Vector::Zero();
};

/// @throw CaseError NotFinite, naming the first point that is no number, or where the extent is none.
Extent extentOf(std::span<Vector const> positions)
{
    Extent extent;
    if (!positions.empty()) extent.low = extent.high = positions.front();
    Real sum = 0; // stays finite only if all are: a comparison with what is no number is just false
    for (Vector const& r : positions)
    {
        extent.low = extent.low.cwiseMin(r);
        extent.high = extent.high.cwiseMax(r);
        sum += r.sum();
    }
    if (std::isfinite(sum) && (extent.high - extent.low).allFinite()) return extent;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        if (positions[i].allFinite()) continue;
        std::ostringstream text;
        text << "position of point " << i << " of " << positions.size() << " is not a finite number: (" << positions[i].transpose()
             << ") m";
        throw CaseError(ExitCode::NotFinite, text.str(), "the last checkpoint is whole; a smaller maxCo or maxDeltaT may help");
    }
    if ((extent.high - extent.low).allFinite()) return extent;
    std::ostringstream text;
    text << "points from (" << extent.low.transpose() << ") m to (" << extent.high.transpose()
         << ") m: their distance is not a finite number";
    throw CaseError(ExitCode::NotFinite, text.str(), "the last checkpoint is whole; a smaller maxCo or maxDeltaT may help");
}

} // namespace

int CellGrid::cellOf(Vector const& r) const
{
    return (coordinate(r.z(), 2) * count_[1] + coordinate(r.y(), 1)) * count_[0] + coordinate(r.x(), 0);
}

void CellGrid::build(std::span<Vector const> positions, Real cellSize, int dimensions)
{
    if (!(cellSize > 0) || !std::isfinite(cellSize))
        throw CaseError(ExitCode::NotFinite, "cell size of a grid is " + shortNumber(cellSize) + " m", "a positive number");
    auto const [low, high] = extentOf(positions);
    Real const most = cellsPerPoint * static_cast<Real>(positions.size()) + fewestCells;
    if (most > std::numeric_limits<int>::max())
        throw CaseError(ExitCode::Memory, std::to_string(positions.size()) + " points are more than one grid of cells can number",
                        "at most 2.6e8 on one rank");
    origin_ = low;
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
