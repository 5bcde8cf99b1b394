#include "scene/FluidFilling.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "scene/CutCells.h"
#include "scene/EntryText.h"
#include "scene/FillingCells.h"

namespace mpsDem {

namespace {

constexpr int samples = 610; ///< In a cell that a surface cuts: a Fibonacci lattice, in line with no wall.
constexpr int turn = 377;    ///< Fibonacci number before it.
constexpr Real mostCells = 2e8;
constexpr Real halfDiagonal = 0.7072; ///< Of a cell, in spacings.

/// Share of a cell of a plane lattice that is in a region and in no solid.
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

FillingCells::FillingCells(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice)
    : dimensions(lattice.dimensions),
      origin(placement.origin + lattice.spacing * placement.offset),
      spacing(lattice.spacing)
{
    Vector lowest = regions.front()->low(), highest = regions.front()->high();
    for (auto const& region : regions)
    {
        lowest = lowest.cwiseMin(region->low());
        highest = highest.cwiseMax(region->high());
    }
    Vector const first = (lowest - origin) / spacing, last = (highest - origin) / spacing;
    Real count = 1;
    for (int d = 0; d < dimensions; ++d) count *= last[d] - first[d] + 2;
    require(count < mostCells, regions.front()->where,
            "the regions cover " + std::to_string(static_cast<std::int64_t>(std::min(count, Real(1e18)))) + " cells of the lattice",
            "fewer than 200 million: a larger spacing or smaller regions");
    high[2] = 1;
    for (int d = 0; d < dimensions; ++d)
    {
        low[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(std::floor(first[d]));
        high[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(std::ceil(last[d]));
    }
}

int lastRegion(std::vector<std::unique_ptr<Region>> const& regions, Vector const& r)
{
    for (std::size_t k = regions.size(); k-- > 0;)
        if (regions[k]->contains(r)) return static_cast<int>(k);
    return -1;
}

LatticePlacement LatticePlacement::read(Dictionary const& setParticlesDict, int dimensions)
{
    LatticePlacement placement;
    Dictionary const dict = setParticlesDict.subDictOrEmpty("lattice");
    auto const vector = [&](std::string const& key) {
        if (dimensions == 2) return readPoint(dict, key);
        Vector const v = dict.get<Vector>(key);
        require(v.allFinite(), dict.where(key), key + " is not finite", "three numbers");
        return v;
    };
    if (dict.found("origin")) placement.origin = vector("origin");
    if (dict.found("offset")) placement.offset = vector("offset");
    require(placement.offset.cwiseAbs().maxCoeff() <= 1, dict.where("offset"), "offset is more than a spacing", "fractions from -1 to 1");
    placement.fillCutCells =
        dict.getWordOr("cutCells", dimensions == 3 ? "fill" : "leave", {"fill", "leave"}, "ways with cut cells") == "fill";
    placement.jitter = dict.getInRangeOr("jitter", 0, 0, 0.49);
    placement.seed = static_cast<std::uint64_t>(dict.getInRangeOr("seed", 1, 0, 9e15));
    return placement;
}

FluidFilling fillRegions(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                         Obstacles const& obstacles)
{
    if (lattice.dimensions == 3 && !regions.empty()) return fillSpace(regions, placement, lattice, obstacles);
    FluidFilling fluid;
    fluid.count.assign(regions.size(), 0);
    if (regions.empty()) return fluid;
    Real const spacing = lattice.spacing;
    FillingCells const cells(regions, placement, lattice);
    CellShare const share(regions, obstacles, spacing);
    Jitter jitter(placement.seed);
    CutCells cutCells(regions, obstacles, cells);

    for (std::int64_t j = cells.low[1]; j < cells.high[1]; ++j)
        for (std::int64_t i = cells.low[0]; i < cells.high[0]; ++i)
        {
            Vector r = cells.middle(i, j);
            Real const toSolid = obstacles.distance(r);
            Real const free = share.of(r, toSolid);
            fluid.volume += free * lattice.particleVolume();
            int const region = lastRegion(regions, r);
            if (region >= 0) ++fluid.count[static_cast<std::size_t>(region)];
            if (region < 0 && (!placement.fillCutCells || toSolid > halfDiagonal * spacing)) continue;
            bool const clear = region >= 0 && toSolid >= (clearance - 1e-9) * spacing;
            if (placement.fillCutCells ? !cutCells.take(free, clear, {i, j, 0}, r) : !clear) continue;
            if (placement.jitter > 0 && clear)
            {
                Real const x = jitter.next(), y = jitter.next();
                Vector const moved = r + placement.jitter * spacing * Vector(x, y, 0);
                if (obstacles.distance(moved) >= jitteredClearance * spacing) r = moved;
            }
            fluid.position.push_back(r);
            fluid.region.push_back(lastRegion(regions, r));
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
