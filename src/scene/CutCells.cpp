#include "scene/CutCells.h"

#include <algorithm>

namespace mpsDem {

namespace {

constexpr Real leastShare = 0.3;      ///< Free share of a cell that may get a particle.
constexpr Real mostCarried = 1;       ///< From cell to cell, in particles.
constexpr Real leastClearance = 0.35; ///< Of a particle that was pushed out of its cell, from solids, in spacings.
constexpr Real leastDistance = 0.55;  ///< Of it from others, in spacings.
constexpr int pushes = 3;

} // namespace

bool CutCells::take(Real free, bool clear, std::array<std::int64_t, 3> const& cell, Vector& r)
{
    carry_ = std::clamp(carry_ + free, -mostCarried, 1 + mostCarried);
    bool const due = clear || (free >= leastShare && carry_ >= 0.5);
    if (!due || (!clear && !pushOut(r, cell))) return false;
    carry_ -= 1;
    return true;
}

/// Moves a place away from solids until it is clear of them, within its region and not too near to others. @return whether that was possible.
bool CutCells::pushOut(Vector& r, std::array<std::int64_t, 3> const& cell)
{
    Real const l0 = cells_.spacing, step = 0.05 * l0;
    Vector moved = r;
    for (int round = 0; round < pushes; ++round)
    {
        Vector slope = Vector::Zero();
        for (int d = 0; d < cells_.dimensions; ++d)
            slope[d] = obstacles_.distance(moved + step * Vector::Unit(d)) - obstacles_.distance(moved - step * Vector::Unit(d));
        if (slope.norm() < step) return false; // between two solids
        moved += std::max(Real(0), clearance * l0 - obstacles_.distance(moved)) * slope.normalized();
    }
    if (obstacles_.distance(moved) < leastClearance * l0 || lastRegion(regions_, moved) < 0 || crowded(moved, cell)) return false;
    pushed_.add(moved, 0);
    r = moved;
    return true;
}

/// Whether a place is near to one that was pushed before it, or to the middle of another cell that is clear of solids.
bool CutCells::crowded(Vector const& r, std::array<std::int64_t, 3> const& cell) const
{
    Real const least = leastDistance * cells_.spacing;
    if (pushed_.near(r, least)) return true;
    int const layers = cells_.dimensions == 2 ? 1 : 3;
    for (int n = 0; n < 9 * layers; ++n)
    {
        std::int64_t const k = cell[2] + (layers == 3 ? n / 9 - 1 : 0);
        Vector const middle = cells_.middle(cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, k);
        bool const near = (middle - r).norm() < least;
        if (near && obstacles_.distance(middle) >= clearance * cells_.spacing && lastRegion(regions_, middle) >= 0) return true;
    }
    return false;
}

} // namespace mpsDem
