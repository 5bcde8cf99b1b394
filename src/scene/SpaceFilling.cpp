#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/FillingCells.h"

namespace mpsDem {

namespace {

constexpr int blockSize = 8; ///< Cells along a side of the largest blocks.
constexpr int samples = 200; ///< In a cell that a surface cuts.
constexpr Real reach = 1.2;  ///< Cells farther from solids than this [spacings] are clear or solid: a cell's half diagonal and any jitter.
constexpr Real halfDiagonal = 0.8660254037844387;
static_assert(reach > halfDiagonal && reach > 0.49 * 2 * halfDiagonal + jitteredClearance);

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Points of the unit cube: multiples of powers of the root of x^4 = x + 1, which leave no plane empty.
std::array<Vector, samples> evenPoints()
{
    std::array<Vector, samples> points;
    Real const g = 1.2207440846057596;
    Vector const step(1 / g, 1 / (g * g), 1 / (g * g * g));
    for (int k = 0; k < samples; ++k)
        for (int d = 0; d < 3; ++d)
        {
            Real const x = 0.5 + (k + 1) * step[d];
            points[at(k)][d] = x - std::floor(x);
        }
    return points;
}

Vector cubeCorner(int number) { return {(number & 1) != 0 ? 1.0 : 0.0, (number & 2) != 0 ? 1.0 : 0.0, (number & 4) != 0 ? 1.0 : 0.0}; }

/// A number known at the corners of the unit cube, linear along each axis between them.
Real between(std::array<Real, 8> const& value, Vector const& x)
{
    Real const a = value[0] + x.x() * (value[1] - value[0]), b = value[2] + x.x() * (value[3] - value[2]);
    Real const c = value[4] + x.x() * (value[5] - value[4]), d = value[6] + x.x() * (value[7] - value[6]);
    Real const low = a + x.y() * (b - a), high = c + x.y() * (d - c);
    return low + x.z() * (high - low);
}

/// What is known of cells before any of them is looked at.
enum class Solidity : char
{
    Unknown,
    Clear, ///< Farther than `reach` from solids, outside of them.
    Solid, ///< The same, inside.
    Near   ///< To be looked at.
};

class SpaceFilling
{
public:
    SpaceFilling(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                 Obstacles const& obstacles)
        : regions_(regions),
          placement_(placement),
          lattice_(lattice),
          obstacles_(obstacles),
          cells_(regions, placement, lattice),
          jitter_(placement.seed)
    {
        for (auto const& region : regions)
        {
            low_.push_back(region->low().array() - 0.5 * lattice.spacing);
            high_.push_back(region->high().array() + 0.5 * lattice.spacing);
        }
        fluid_.count.assign(regions.size(), 0);
    }

    FluidFilling run()
    {
        size_ = {cells_.high[0] - cells_.low[0], cells_.high[1] - cells_.low[1]};
        for (std::int64_t k = cells_.low[2]; k < cells_.high[2]; k += blockSize) fillLayers(k, std::min(k + blockSize, cells_.high[2]));
        fluid_.volume *= lattice_.particleVolume();
        return std::move(fluid_);
    }

private:
    /// Whether a box reaches into the cells of a region.
    [[nodiscard]] bool touchesRegion(Vector const& low, Vector const& high) const
    {
        for (std::size_t k = 0; k < low_.size(); ++k)
            if ((high.array() >= low_[k].array()).all() && (low.array() <= high_[k].array()).all()) return true;
        return false;
    }

    void fillLayers(std::int64_t first, std::int64_t last)
    {
        base_ = first;
        solidity_.assign(at(size_[0] * size_[1] * (last - first)), Solidity::Unknown);
        for (std::int64_t j = 0; j < size_[1]; j += blockSize)
            for (std::int64_t i = 0; i < size_[0]; i += blockSize) classify({i, j, 0}, {size_[0], size_[1], last - first}, blockSize);
        for (std::int64_t k = first; k < last; ++k)
            for (std::int64_t j = 0; j < size_[1]; ++j)
                for (std::int64_t i = 0; i < size_[0]; ++i)
                    fillCell(cells_.middle(cells_.low[0] + i, cells_.low[1] + j, k), solidityOf(i, j, k - first));
    }

    [[nodiscard]] Solidity& solidityOf(std::int64_t i, std::int64_t j, std::int64_t k)
    {
        return solidity_[at((k * size_[1] + j) * size_[0] + i)];
    }

    /// Settles a block of cells, or its eighths where solids are near.
    void classify(std::array<std::int64_t, 3> const& begin, std::array<std::int64_t, 3> const& end, int size)
    {
        if (begin[0] >= end[0] || begin[1] >= end[1] || begin[2] >= end[2]) return;
        Real const half = 0.5 * size * lattice_.spacing;
        Vector const corner =
            cells_.middle(cells_.low[0] + begin[0], cells_.low[1] + begin[1], base_ + begin[2]).array() - 0.5 * lattice_.spacing;
        Vector const middle = corner.array() + half;
        if (!touchesRegion(corner, corner.array() + 2 * half)) return; // stays unknown, is not asked for
        Solidity const found = size > 1 ? solidityOfBlock(middle, half) : Solidity::Near;
        if (found == Solidity::Near && size > 1)
        {
            int const part = size / 2;
            for (int k = 0; k < 8; ++k)
                classify({begin[0] + ((k & 1) != 0 ? part : 0), begin[1] + ((k & 2) != 0 ? part : 0), begin[2] + ((k & 4) != 0 ? part : 0)},
                         end, part);
            return;
        }
        for (std::int64_t k = begin[2]; k < std::min(begin[2] + size, end[2]); ++k)
            for (std::int64_t j = begin[1]; j < std::min(begin[1] + size, end[1]); ++j)
                for (std::int64_t i = begin[0]; i < std::min(begin[0] + size, end[0]); ++i) solidityOf(i, j, k) = found;
    }

    /// Clear or Solid where no cell of the block can lie within `reach` of solids and its corners agree on the side.
    [[nodiscard]] Solidity solidityOfBlock(Vector const& middle, Real half) const
    {
        Real const distance = obstacles_.distance(middle);
        if (!(std::abs(distance) > 2 * halfDiagonal * half + reach * lattice_.spacing)) return Solidity::Near;
        for (int k = 0; k < 8; ++k)
            if ((obstacles_.distance(middle + 2 * half * (cubeCorner(k).array() - 0.5).matrix()) > 0) != (distance > 0))
                return Solidity::Near;
        return distance > 0 ? Solidity::Clear : Solidity::Solid;
    }

    void fillCell(Vector r, Solidity solidity)
    {
        Real const spacing = lattice_.spacing;
        if (solidity == Solidity::Unknown || !touchesRegion(r, r)) return;
        Real const far = reach * spacing;
        Real const toWall = solidity == Solidity::Clear ? far : solidity == Solidity::Solid ? -far : obstacles_.walls.distance(r);
        Real const toBody = solidity == Solidity::Near ? obstacles_.bodies.distance(r) : toWall;
        Real const toSolid = std::min(toWall, toBody);
        int const region = lastRegion(regions_, r);
        fluid_.volume += share(r, toWall, toBody, region >= 0);
        if (region < 0) return;
        ++fluid_.count[static_cast<std::size_t>(region)];
        if (toSolid < (clearance - 1e-9) * spacing) return;
        if (placement_.jitter > 0)
        {
            Real const x = jitter_.next(), y = jitter_.next(), z = jitter_.next();
            Vector const moved = r + placement_.jitter * spacing * Vector(x, y, z);
            if (toSolid >= far || obstacles_.distance(moved) >= jitteredClearance * spacing) r = moved;
        }
        fluid_.position.push_back(r);
        fluid_.region.push_back(region);
    }

    /// Share of a cell that is in a region and in no solid.
    [[nodiscard]] Real share(Vector const& middle, Real toWall, Real toBody, bool middleInRegion) const
    {
        Real const spacing = lattice_.spacing, near = halfDiagonal * spacing;
        if (std::min(toWall, toBody) <= -near) return 0;
        bool uniform = true;
        for (int k = 0; k < 8 && uniform; ++k)
            uniform = inRegion(middle + (1 - 1e-9) * spacing * (cubeCorner(k).array() - 0.5).matrix()) == middleInRegion;
        if (uniform && !middleInRegion) return 0;
        std::array<Real, 8> wall, body;
        bool const wallCuts = atCorners(obstacles_.walls, middle, toWall, wall),
                   bodyCuts = atCorners(obstacles_.bodies, middle, toBody, body);
        if (uniform && !wallCuts && !bodyCuts) return std::min(toWall, toBody) > 0 ? 1 : 0;
        int inside = 0;
        for (Vector const& x : points_)
        {
            bool const free = between(wall, x) > 0 && between(body, x) > 0;
            if (free && (uniform || inRegion(middle + spacing * (x.array() - 0.5).matrix()))) ++inside;
        }
        return static_cast<Real>(inside) / samples;
    }

    /// Distances at the corners of a cell, or no more than their sign where solids are too far to cut it. @return whether they cut it.
    [[nodiscard]] bool atCorners(SolidDistance const& solids, Vector const& middle, Real distance, std::array<Real, 8>& corners) const
    {
        corners.fill(distance > 0 ? lattice_.spacing : -lattice_.spacing);
        if (std::abs(distance) >= halfDiagonal * lattice_.spacing) return false;
        bool free = false, solid = false;
        Real const none = 1e-9 * lattice_.spacing; // a wall along the cell's side
        for (int k = 0; k < 8; ++k)
        {
            corners[at(k)] = solids.distance(middle + lattice_.spacing * (cubeCorner(k).array() - 0.5).matrix());
            free = free || corners[at(k)] > none;
            solid = solid || corners[at(k)] < -none;
        }
        return free && solid;
    }

    [[nodiscard]] bool inRegion(Vector const& r) const { return lastRegion(regions_, r) >= 0; }

    std::vector<std::unique_ptr<Region>> const& regions_;
    LatticePlacement const& placement_;
    Lattice const& lattice_;
    Obstacles const& obstacles_;
    FillingCells cells_;
    Jitter jitter_;
    Field<Vector> low_, high_; ///< Of the regions, half a spacing wider.
    std::array<Vector, samples> const points_ = evenPoints();
    std::array<std::int64_t, 2> size_{}; ///< Cells along x and y.
    std::int64_t base_ = 0;              ///< Number of the lowest layer in `solidity_`.
    std::vector<Solidity> solidity_;
    FluidFilling fluid_;
};

} // namespace

FluidFilling fillSpace(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                       Obstacles const& obstacles)
{
    return SpaceFilling(regions, placement, lattice, obstacles).run();
}

} // namespace mpsDem
