#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Points placed so far, to be asked which ones are near: cells in a hash table, only looked up, never iterated.
class PlacedPoints
{
public:
    /// @param cellSize  About one and a half times the distance that is asked for [m].
    explicit PlacedPoints(Real cellSize) : inverseSize_(1 / cellSize), first_(1024, -1) {}

    /// Calls visit(position, tag) for the points of the cells within `reach` of r, until it returns true; says whether it did.
    template <class Visit>
    bool anyNear(Vector const& r, Real reach, Visit visit) const
    {
        Cell const low = cell(r - Vector::Constant(reach)), high = cell(r + Vector::Constant(reach));
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t i = low[0]; i <= high[0]; ++i)
                    for (int p = first_[slot({i, j, k})]; p >= 0; p = points_[static_cast<std::size_t>(p)].next)
                    {
                        Point const& point = points_[static_cast<std::size_t>(p)];
                        if (point.cell == Cell{i, j, k} && visit(point.position, point.tag)) return true;
                    }
        return false;
    }

    [[nodiscard]] bool near(Vector const& r, Real distance) const
    {
        return anyNear(r, distance, [&](Vector const& q, int) { return (q - r).squaredNorm() < distance * distance; });
    }

    void add(Vector const& r, int tag)
    {
        if (points_.size() >= first_.size()) grow();
        Cell const own = cell(r);
        int& first = first_[slot(own)];
        points_.push_back({r, own, tag, first});
        first = static_cast<int>(points_.size()) - 1;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    struct Point
    {
        Vector position;
        Cell cell;
        int tag;
        int next;
    };

    [[nodiscard]] Cell cell(Vector const& r) const
    {
        Cell c{};
        for (int d = 0; d < 3; ++d) c[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(std::floor(r[d] * inverseSize_));
        return c;
    }

    [[nodiscard]] std::size_t slot(Cell const& c) const
    {
        std::uint64_t h = static_cast<std::uint64_t>(c[0]) * 0x9E3779B97F4A7C15u;
        h = (h ^ static_cast<std::uint64_t>(c[1])) * 0xC2B2AE3D27D4EB4Fu;
        h = (h ^ static_cast<std::uint64_t>(c[2])) * 0x165667B19E3779F9u;
        return static_cast<std::size_t>(h >> 20) & (first_.size() - 1);
    }

    void grow()
    {
        first_.assign(4 * first_.size(), -1);
        for (std::size_t p = 0; p < points_.size(); ++p)
        {
            int& first = first_[slot(points_[p].cell)];
            points_[p].next = first;
            first = static_cast<int>(p);
        }
    }

    Real inverseSize_;
    std::vector<int> first_;
    std::vector<Point> points_;
};

} // namespace mpsDem
