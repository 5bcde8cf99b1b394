#include "scene/CoarseSolids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mpsDem {

static_assert(CoarseSolids::reach > 0.49 * std::numbers::sqrt3 + jitteredClearance);

RegionBoxes::RegionBoxes(std::vector<std::unique_ptr<Region>> const& regions, Real margin)
{
    for (auto const& region : regions)
    {
        low_.push_back(region->low().array() - margin);
        high_.push_back(region->high().array() + margin);
    }
}

bool RegionBoxes::touch(Vector const& low, Vector const& high) const
{
    for (std::size_t k = 0; k < low_.size(); ++k)
        if ((high.array() >= low_[k].array()).all() && (low.array() <= high_[k].array()).all()) return true;
    return false;
}

CoarseSolids::CoarseSolids(SolidDistance const& solids, FillingCells const& cells, RegionBoxes const& regions)
    : solids_(solids),
      cells_(cells),
      regions_(regions),
      size_{cells.high[0] - cells.low[0], cells.high[1] - cells.low[1]}
{}

void CoarseSolids::look(std::int64_t first, std::int64_t last)
{
    first_ = first;
    side_.assign(static_cast<std::size_t>(size_[0] * size_[1] * (last - first)), Side::Unknown);
    for (std::int64_t j = cells_.low[1]; j < cells_.high[1]; j += blockSize)
        for (std::int64_t i = cells_.low[0]; i < cells_.high[0]; i += blockSize)
            settle({i, j, first}, {cells_.high[0], cells_.high[1], last}, blockSize);
}

/// One block that begins with the cell `begin`, as far as cells go; or its eighths where solids are near.
void CoarseSolids::settle(Numbers const& begin, Numbers const& end, int size)
{
    for (std::size_t d = 0; d < 3; ++d)
        if (begin[d] >= end[d]) return;
    Vector const corner = cells_.corner(begin[0], begin[1], begin[2]);
    if (!regions_.touch(corner, corner.array() + size * cells_.spacing)) return;
    Side const found = size > 1 ? sideOfBlock(corner, size) : Side::Near;
    if (found == Side::Near && size > 1)
    {
        int const part = size / 2;
        for (int k = 0; k < 8; ++k)
            settle({begin[0] + (k & 1) * part, begin[1] + (k >> 1 & 1) * part, begin[2] + (k >> 2) * part}, end, part);
        return;
    }
    for (std::int64_t k = begin[2]; k < std::min(begin[2] + size, end[2]); ++k)
        for (std::int64_t j = begin[1]; j < std::min(begin[1] + size, end[1]); ++j)
            for (std::int64_t i = begin[0]; i < std::min(begin[0] + size, end[0]); ++i) side_[index(i, j, k)] = found;
}

/// Clear or Solid where no point of the block's cells lies within `reach` of solids; the corners of larger blocks have to agree, for beyond the
/// rim of an open wall sides change far from it.
CoarseSolids::Side CoarseSolids::sideOfBlock(Vector const& corner, int size) const
{
    Real const width = size * cells_.spacing;
    Real const distance = solids_.distance(corner.array() + width / 2);
    if (!(std::abs(distance) > std::numbers::sqrt3 / 2 * width + reach * cells_.spacing)) return Side::Near;
    for (int k = 0; k < 8 && size > 2; ++k)
        if ((solids_.distance(corner + width * Vector(k & 1, k >> 1 & 1, k >> 2)) > 0) != (distance > 0)) return Side::Near;
    return distance > 0 ? Side::Clear : Side::Solid;
}

} // namespace mpsDem
