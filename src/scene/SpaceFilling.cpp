#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "scene/CoarseSolids.h"
#include "scene/CutCells.h"
#include "scene/FillingCells.h"

namespace mpsDem {

namespace {

constexpr int samples = 100; ///< In a cell that a surface cuts.
constexpr Real halfDiagonal = std::numbers::sqrt3 / 2;

/// Points of the unit cube: multiples of powers of the root of x^4 = x + 1, which leave no plane empty.
std::array<Vector, samples> evenPoints()
{
    std::array<Vector, samples> points;
    Real const g = 1.2207440846057596;
    Vector const step(1 / g, 1 / (g * g), 1 / (g * g * g));
    for (std::size_t k = 0; k < samples; ++k)
        for (int d = 0; d < 3; ++d)
        {
            Real const x = 0.5 + static_cast<Real>(k + 1) * step[d];
            points[k][d] = x - std::floor(x);
        }
    return points;
}

/// A number known at the corners of the unit cube, linear along each axis between them, and at its middle: what is missing there is added as a
/// bubble that vanishes at the sides.
Real between(std::array<Real, 8> const& value, Real atMiddle, Vector const& x)
{
    Real mean = 0;
    for (Real const v : value) mean += v / 8;
    Real const bubble = 64 * (x.array() * (1 - x.array())).prod();
    Real const a = value[0] + x.x() * (value[1] - value[0]), b = value[2] + x.x() * (value[3] - value[2]);
    Real const c = value[4] + x.x() * (value[5] - value[4]), d = value[6] + x.x() * (value[7] - value[6]);
    Real const low = a + x.y() * (b - a), high = c + x.y() * (d - c);
    return low + x.z() * (high - low) + (atMiddle - mean) * bubble;
}

/// What is known at the corners of the cells of one layer, asked for when it is needed.
class Nodes
{
public:
    static constexpr Real unknown = std::numeric_limits<Real>::infinity();

    explicit Nodes(FillingCells const& cells)
        : cells_(cells),
          size_(cells.high[0] - cells.low[0] + 1),
          value_{Field<Real>(static_cast<std::size_t>(size_ * (cells.high[1] - cells.low[1] + 1)), unknown), {}}
    {
        value_[1] = value_[0];
    }

    /// Goes to the layer above.
    void rise()
    {
        std::swap(value_[0], value_[1]);
        std::fill(value_[1].begin(), value_[1].end(), unknown);
    }

    /// Of the corners of a cell of the layer k. @param ask  Gives the value at a place.
    template <class Ask>
    std::array<Real, 8> corners(std::int64_t i, std::int64_t j, std::int64_t k, Ask ask)
    {
        std::array<Real, 8> values;
        for (int c = 0; c < 8; ++c)
        {
            std::int64_t const x = i + (c & 1), y = j + (c >> 1 & 1), z = c >> 2;
            Real& value = value_[static_cast<std::size_t>(z)][static_cast<std::size_t>((y - cells_.low[1]) * size_ + x - cells_.low[0])];
            if (value == unknown) value = ask(cells_.corner(x, y, k + z));
            values[static_cast<std::size_t>(c)] = value;
        }
        return values;
    }

private:
    FillingCells const& cells_;
    std::int64_t size_;
    std::array<Field<Real>, 2> value_; ///< Below and above the layer.
};

/// One kind of solids: by blocks, and at the corners of cells that they may cut.
struct Solids
{
    Solids(SolidDistance const& of, FillingCells const& cells, RegionBoxes const& boxes) : exact(of), coarse(of, cells, boxes), nodes(cells)
    {}
    SolidDistance exact;
    CoarseSolids coarse;
    Nodes nodes;
};

class SpaceFilling
{
public:
    SpaceFilling(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                 Obstacles const& obstacles)
        : regions_(regions),
          placement_(placement),
          obstacles_(obstacles),
          cells_(regions, placement, lattice),
          boxes_(regions, 0.5 * lattice.spacing),
          walls_(obstacles.walls, cells_, boxes_),
          bodies_(obstacles.bodies, cells_, boxes_),
          regionNodes_(cells_),
          jitter_(placement.seed),
          cutCells_(regions, obstacles, cells_)
    {
        fluid_.count.assign(regions.size(), 0);
    }

    FluidFilling run()
    {
        for (std::int64_t k = cells_.low[2]; k < cells_.high[2]; ++k)
        {
            if ((k - cells_.low[2]) % CoarseSolids::blockSize == 0)
                for (Solids* solids : {&walls_, &bodies_}) solids->coarse.look(k, std::min(k + CoarseSolids::blockSize, cells_.high[2]));
            for (std::int64_t j = cells_.low[1]; j < cells_.high[1]; ++j)
                for (std::int64_t i = cells_.low[0]; i < cells_.high[0]; ++i) fillCell(i, j, k);
            for (Nodes* nodes : {&walls_.nodes, &bodies_.nodes, &regionNodes_}) nodes->rise();
        }
        fluid_.volume *= cells_.spacing * cells_.spacing * cells_.spacing;
        return std::move(fluid_);
    }

private:
    void fillCell(std::int64_t i, std::int64_t j, std::int64_t k)
    {
        Vector r = cells_.middle(i, j, k);
        if (!boxes_.touch(r, r)) return;
        int const region = lastRegion(regions_, r);
        auto const corners = regionNodes_.corners(i, j, k, [&](Vector const& corner) { return inRegion(corner) ? 1 : 0; });
        bool const uniform = std::all_of(corners.begin(), corners.end(), [&](Real value) { return (value > 0) == (region >= 0); });
        if (uniform && region < 0) return;
        Real const toWall = walls_.coarse.distance(i, j, k, r), toBody = bodies_.coarse.distance(i, j, k, r);
        Real const toSolid = std::min(toWall, toBody);
        Real const free = share({i, j, k}, toWall, toBody, uniform);
        fluid_.volume += free;
        if (region >= 0) ++fluid_.count[static_cast<std::size_t>(region)];
        if (region < 0 && toSolid > halfDiagonal * cells_.spacing) return; // cut by the border of the region alone
        bool const clear = region >= 0 && toSolid >= (clearance - 1e-9) * cells_.spacing;
        if (placement_.fillCutCells ? !cutCells_.take(free, clear, {i, j, k}, r) : !clear) return;
        if (placement_.jitter > 0 && clear)
        {
            Real const x = jitter_.next(), y = jitter_.next(), z = jitter_.next();
            Vector const moved = r + placement_.jitter * cells_.spacing * Vector(x, y, z);
            Real const least = jitteredClearance * cells_.spacing;
            if (toSolid - (moved - r).norm() >= least || obstacles_.distance(moved) >= least) r = moved;
        }
        fluid_.position.push_back(r);
        fluid_.region.push_back(lastRegion(regions_, r));
    }

    /// Share of a cell that is in a region and in no solid. Solids are taken as the distances at its corners have them, linear in between.
    /// @param uniform  All of it is in a region.
    [[nodiscard]] Real share(std::array<std::int64_t, 3> const& cell, Real toWall, Real toBody, bool uniform)
    {
        Real const toSolid = std::min(toWall, toBody);
        if (toSolid <= -halfDiagonal * cells_.spacing) return 0;
        std::array<Real, 8> wall, body;
        bool const wallCuts = cuts(walls_, cell, toWall, wall), bodyCuts = cuts(bodies_, cell, toBody, body);
        if (uniform && !wallCuts && !bodyCuts) return toSolid > 0 ? 1 : 0;
        Vector const corner = cells_.corner(cell[0], cell[1], cell[2]);
        int count = 0;
        for (Vector const& x : points_)
        {
            bool const free = between(wall, toWall, x) > 0 && between(body, toBody, x) > 0;
            if (free && (uniform || inRegion(corner + cells_.spacing * x))) ++count;
        }
        return static_cast<Real>(count) / samples;
    }

    /// Distances at the corners of a cell, or no more than their sign where solids are too far to cut it. @return whether they cut it.
    [[nodiscard]] bool cuts(Solids& solids, std::array<std::int64_t, 3> const& cell, Real distance, std::array<Real, 8>& corners) const
    {
        corners.fill(distance > 0 ? cells_.spacing : -cells_.spacing);
        if (std::abs(distance) >= halfDiagonal * cells_.spacing) return false;
        corners = solids.nodes.corners(cell[0], cell[1], cell[2], [&](Vector const& r) { return solids.exact.distance(r); });
        auto const [least, most] = std::minmax_element(corners.begin(), corners.end());
        Real const none = 1e-9 * cells_.spacing; // a wall along the cell's side
        return *least<-none&& * most> none;
    }

    [[nodiscard]] bool inRegion(Vector const& r) const { return lastRegion(regions_, r) >= 0; }

    std::vector<std::unique_ptr<Region>> const& regions_;
    LatticePlacement const& placement_;
    Obstacles const& obstacles_;
    FillingCells cells_;
    RegionBoxes boxes_; ///< Half a spacing wider: what cells reach into.
    Solids walls_, bodies_;
    Nodes regionNodes_; ///< 1 in a region, 0 outside.
    Jitter jitter_;
    CutCells cutCells_;
    std::array<Vector, samples> const points_ = evenPoints();
    FluidFilling fluid_;
};

} // namespace

FluidFilling fillSpace(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                       Obstacles const& obstacles)
{
    return SpaceFilling(regions, placement, lattice, obstacles).run();
}

} // namespace mpsDem
