#include "pressure/PressureGroups.h"

#include <algorithm>
#include <limits>

namespace mpsDem {

namespace {

constexpr int unseen = -2, reached = -1;
constexpr std::size_t usualGroups = 64; ///< Room from the start; more allocate.

} // namespace

void PressureGroups::flood(SparseMatrix const& matrix, int seed, int label)
{
    group_[seed] = label;
    stack_.push_back(seed);
    while (!stack_.empty())
    {
        int const row = stack_.back();
        stack_.pop_back();
        for (int k = matrix.rowStart[row]; k < matrix.rowStart[row + 1]; ++k)
        {
            int const column = matrix.column[k];
            if (group_[column] != unseen) continue;
            group_[column] = label;
            stack_.push_back(column);
        }
    }
}

void PressureGroups::find(SparseMatrix const& matrix, Field<std::uint8_t> const& pinned)
{
    group_.reserve(matrix.rowStart.capacity()); // the number of rows changes from step to step
    stack_.reserve(matrix.rowStart.capacity());
    size_.reserve(usualGroups);
    group_.assign(static_cast<std::size_t>(matrix.rows), unseen);
    size_.clear();
    for (int row = 0; row < matrix.rows; ++row)
        if (pinned[row] && group_[row] == unseen) flood(matrix, row, reached);
    for (int row = 0; row < matrix.rows; ++row)
    {
        if (group_[row] != unseen) continue;
        flood(matrix, row, count());
        size_.push_back(0);
    }
    if (size_.empty()) return;
    for (int const g : group_)
        if (g >= 0) ++size_[g];
}

void PressureGroups::makeCompatible(std::span<Real> right)
{
    if (size_.empty()) return;
    mean_.reserve(size_.capacity());
    mean_.assign(size_.size(), 0);
    for (std::size_t row = 0; row < right.size(); ++row)
        if (group_[row] >= 0) mean_[group_[row]] += right[row] / size_[group_[row]];
    for (std::size_t row = 0; row < right.size(); ++row)
        if (group_[row] >= 0) right[row] = size_[group_[row]] <= smallGroup ? 0 : right[row] - mean_[group_[row]];
}

void PressureGroups::shift(std::span<Real> solution)
{
    if (size_.empty()) return;
    lowest_.reserve(size_.capacity());
    lowest_.assign(size_.size(), std::numeric_limits<Real>::infinity());
    for (std::size_t row = 0; row < solution.size(); ++row)
        if (group_[row] >= 0) lowest_[group_[row]] = std::min(lowest_[group_[row]], solution[row]);
    for (std::size_t row = 0; row < solution.size(); ++row)
        if (group_[row] >= 0) solution[row] = size_[group_[row]] <= smallGroup ? 0 : solution[row] - lowest_[group_[row]];
}

} // namespace mpsDem
