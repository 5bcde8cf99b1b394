#include "scene/FluidFilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/Errors.h"
#include "scene/EntryText.h"

namespace mpsDem {

namespace {

constexpr Real clearance = 0.45;         ///< Of fluid on the lattice from solids, in spacings.
constexpr Real jitteredClearance = 0.25; ///< Of jittered fluid, in spacings.
constexpr int samples = 610;             ///< In a cell that a surface cuts: a Fibonacci lattice, in line with no wall.
constexpr int turn = 377;                ///< Fibonacci number before it.
constexpr Real mostCells = 2e8;

/// Uniform numbers in [-1, 1) from the 53 leading bits of a Mersenne twister: the same on every machine.
class Jitter
{
public:
    explicit Jitter(std::uint64_t seed) : generator_(seed) {}
    Real next() { return 2 * (static_cast<Real>(generator_() >> 11) * 0x1p-53) - 1; }

private:
    std::mt19937_64 generator_;
};

struct Cells
{
    Vector origin;
    std::int64_t lowX = 0, highX = 0, lowY = 0, highY = 0; ///< Half-open.
    Real spacing;

    [[nodiscard]] Vector middle(std::int64_t i, std::int64_t j) const
    {
        return origin + spacing * Vector(static_cast<Real>(i) + 0.5, static_cast<Real>(j) + 0.5, 0);
    }
};

Cells cellsOver(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice)
{
    Vector low = regions.front()->low(), high = regions.front()->high();
    for (auto const& region : regions)
    {
        low = low.cwiseMin(region->low());
        high = high.cwiseMax(region->high());
    }
    Cells cells{placement.origin + lattice.spacing * placement.offset, 0, 0, 0, 0, lattice.spacing};
    Vector const first = (low - cells.origin) / lattice.spacing, last = (high - cells.origin) / lattice.spacing;
    Real const count = (last.x() - first.x() + 2) * (last.y() - first.y() + 2);
    require(count < mostCells, regions.front()->where,
            "the regions cover " + std::to_string(static_cast<std::int64_t>(count)) + " cells of the lattice",
            "fewer than 200 million: a larger spacing or smaller regions");
    cells.lowX = static_cast<std::int64_t>(std::floor(first.x()));
    cells.lowY = static_cast<std::int64_t>(std::floor(first.y()));
    cells.highX = static_cast<std::int64_t>(std::ceil(last.x()));
    cells.highY = static_cast<std::int64_t>(std::ceil(last.y()));
    return cells;
}

int lastRegion(std::vector<std::unique_ptr<Region>> const& regions, Vector const& r)
{
    for (std::size_t k = regions.size(); k-- > 0;)
        if (regions[k]->contains(r)) return static_cast<int>(k);
    return -1;
}

/// Share of a cell that is in a region and in no solid.
class CellShare
{
public:
    CellShare(std::vector<std::unique_ptr<Region>> const& regions, Obstacles const& obstacles, Real spacing)
        : regions_(regions),
          obstacles_(obstacles),
          spacing_(spacing)
    {}

    /// @param distance  Of the middle from the nearest solid.
    [[nodiscard]] Real of(Vector const& middle, Real distance) const
    {
        bool const solidNear = std::abs(distance) < 0.75 * spacing_;
        bool const inMiddle = inRegion(middle);
        bool uniform = !solidNear;
        for (Real const x : {-0.5, 0.5})
            for (Real const y : {-0.5, 0.5}) uniform = uniform && inRegion(middle + spacing_ * (1 - 1e-9) * Vector(x, y, 0)) == inMiddle;
        if (uniform) return inMiddle && distance > 0 ? 1 : 0;
        int inside = 0;
        for (int k = 0; k < samples; ++k)
        {
            Real const x = (k + 0.5) / samples, y = (k * turn % samples + 0.31) / samples;
            Vector const r = middle + spacing_ * Vector(x - 0.5, y - 0.5, 0);
            bool const free = !solidNear ? distance > 0 : obstacles_.walls.distance(r) > 0 && obstacles_.bodies.distance(r) > 0;
            if (inRegion(r) && free) ++inside;
        }
        return static_cast<Real>(inside) / samples;
    }

private:
    [[nodiscard]] bool inRegion(Vector const& r) const { return lastRegion(regions_, r) >= 0; }

    std::vector<std::unique_ptr<Region>> const& regions_;
    Obstacles const& obstacles_;
    Real spacing_;
};

} // namespace

LatticePlacement LatticePlacement::read(Dictionary const& setParticlesDict)
{
    LatticePlacement placement;
    Dictionary const dict = setParticlesDict.subDictOrEmpty("lattice");
    if (dict.found("origin")) placement.origin = readPoint(dict, "origin");
    if (dict.found("offset")) placement.offset = readPoint(dict, "offset");
    require(placement.offset.cwiseAbs().maxCoeff() <= 1, dict.where("offset"), "offset is more than a spacing", "fractions from -1 to 1");
    placement.jitter = dict.getInRangeOr("jitter", 0, 0, 0.49);
    placement.seed = static_cast<std::uint64_t>(dict.getInRangeOr("seed", 1, 0, 9e15));
    return placement;
}

FluidFilling fillRegions(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                         Obstacles const& obstacles)
{
    FluidFilling fluid;
    fluid.count.assign(regions.size(), 0);
    if (regions.empty()) return fluid;
    Real const spacing = lattice.spacing;
    Cells const cells = cellsOver(regions, placement, lattice);
    CellShare const share(regions, obstacles, spacing);
    auto const distance = [&](Vector const& r) { return std::min(obstacles.walls.distance(r), obstacles.bodies.distance(r)); };
    Jitter jitter(placement.seed);

    for (std::int64_t j = cells.lowY; j < cells.highY; ++j)
        for (std::int64_t i = cells.lowX; i < cells.highX; ++i)
        {
            Vector r = cells.middle(i, j);
            Real const toSolid = distance(r);
            fluid.volume += share.of(r, toSolid) * lattice.particleVolume();
            int const region = lastRegion(regions, r);
            if (region < 0) continue;
            ++fluid.count[static_cast<std::size_t>(region)];
            if (toSolid < (clearance - 1e-9) * spacing) continue;
            if (placement.jitter > 0)
            {
                Real const x = jitter.next(), y = jitter.next();
                Vector const moved = r + placement.jitter * spacing * Vector(x, y, 0);
                if (distance(moved) >= jitteredClearance * spacing) r = moved;
            }
            fluid.position.push_back(r);
            fluid.region.push_back(region);
        }
    return fluid;
}

Real depthInRegions(std::vector<std::unique_ptr<Region>> const& regions, Vector const& r, Vector const& up, Real spacing)
{
    Real depth = -1;
    Vector place = r;
    for (std::size_t step = 0; step <= regions.size(); ++step)
    {
        Real farthest = -1;
        for (auto const& region : regions)
            if (region->contains(place)) farthest = std::max(farthest, region->exitDistance(place, up));
        if (farthest < 0) break;
        depth = (place - r).dot(up) + farthest;
        place = r + (depth + 1e-6 * spacing) * up;
    }
    return depth;
}

} // namespace mpsDem
