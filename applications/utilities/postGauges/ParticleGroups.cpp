#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "postGauges/FreeSurface.h"

namespace mpsDem::postGauges {

namespace {

using Cell = std::array<std::int64_t, 3>;

struct InCell
{
    Cell cell;
    int index;
};

bool lessCell(InCell const& a, InCell const& b) { return a.cell != b.cell ? a.cell < b.cell : a.index < b.index; }

/// Groups by their smallest member.
class Groups
{
public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    int root(int i)
    {
        while (parent_[static_cast<std::size_t>(i)] != i)
        {
            int& parent = parent_[static_cast<std::size_t>(i)];
            parent = parent_[static_cast<std::size_t>(parent)];
            i = parent;
        }
        return i;
    }

    void join(int a, int b)
    {
        int const first = root(a), second = root(b);
        parent_[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
    }

private:
    std::vector<int> parent_;
};

/// Joins the particle with those of one cell, from an index on, that are within reach.
void joinCell(std::vector<Vector> const& positions, Real reach, std::vector<InCell> const& sorted, InCell const& from, Cell const& cell,
              int first, Groups& groups)
{
    auto other = std::lower_bound(sorted.begin(), sorted.end(), InCell{cell, first}, lessCell);
    for (; other != sorted.end() && other->cell == cell; ++other)
    {
        Vector const apart = positions[static_cast<std::size_t>(other->index)] - positions[static_cast<std::size_t>(from.index)];
        if (apart.squaredNorm() <= reach * reach) groups.join(from.index, other->index);
    }
}

} // namespace

std::vector<int> groupSizes(std::vector<Vector> const& positions, Real reach)
{
    std::vector<InCell> sorted(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
            sorted[i].cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(positions[i][k] / reach));
        sorted[i].index = static_cast<int>(i);
    }
    std::sort(sorted.begin(), sorted.end(), lessCell);
    Groups groups(positions.size());
    bool const flat = std::all_of(sorted.begin(), sorted.end(), [&](InCell const& a) { return a.cell[2] == sorted.front().cell[2]; });
    for (InCell const& from : sorted)
    {
        // The cell itself and those after it: the others have looked at this one.
        for (int k = 13; k < 27; ++k)
        {
            if (flat && k % 3 != 1) continue;
            Cell const cell = {from.cell[0] + k / 9 - 1, from.cell[1] + k / 3 % 3 - 1, from.cell[2] + k % 3 - 1};
            joinCell(positions, reach, sorted, from, cell, k == 13 ? from.index + 1 : 0, groups);
        }
    }
    std::vector<int> members(positions.size(), 0), sizes(positions.size(), 0);
    for (std::size_t i = 0; i < positions.size(); ++i) ++members[static_cast<std::size_t>(groups.root(static_cast<int>(i)))];
    for (std::size_t i = 0; i < positions.size(); ++i) sizes[i] = members[static_cast<std::size_t>(groups.root(static_cast<int>(i)))];
    return sizes;
}

} // namespace mpsDem::postGauges
