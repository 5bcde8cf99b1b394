#include "boundaries/BoundaryRows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "boundaries/RowLayout.h"
#include "boundaries/SegmentTree.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

constexpr Real shortfall = 0.02;      ///< A row may be nearer to a surface than its depth by this, in spacings.
constexpr Real tipClearance = 0.2;    ///< Least distance of a wall particle in a sharp tip from the other side, in spacings.
constexpr Real leastDistance = 0.7;   ///< Of two boundary particles, in spacings.
constexpr Real reachOfWallRow = 0.75; ///< Greatest depth of a wall particle that continues a row, in spacings.
constexpr Real joinTolerance = 0.1;   ///< Ends of surfaces nearer than this are joined, in spacings.
constexpr Real longestBisector = 2.0; ///< Corner particles exist where the bisector is no longer (fluid angle above 60 degrees).

/// Points placed so far, to be asked whether one is near. Cells as large as the distance asked for; only looked up, never iterated.
class PlacedPoints
{
public:
    explicit PlacedPoints(Real distance) : distance_(distance) {}

    [[nodiscard]] bool near(Vector const& r) const
    {
        std::int64_t const x = cell(r.x()), y = cell(r.y());
        for (std::int64_t j = y - 1; j <= y + 1; ++j)
            for (std::int64_t i = x - 1; i <= x + 1; ++i)
            {
                auto const found = cells_.find(key(i, j));
                if (found == cells_.end()) continue;
                for (Vector const& q : found->second)
                    if ((q - r).norm() < distance_) return true;
            }
        return false;
    }

    void add(Vector const& r) { cells_[key(cell(r.x()), cell(r.y()))].push_back(r); }

private:
    [[nodiscard]] std::int64_t cell(Real x) const { return static_cast<std::int64_t>(std::floor(x / distance_)); }
    static std::uint64_t key(std::int64_t x, std::int64_t y)
    {
        return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u ^ static_cast<std::uint64_t>(y);
    }

    Real distance_;
    std::unordered_map<std::uint64_t, std::vector<Vector>> cells_;
};

/// Open ends of chains that no other surface touches.
std::vector<Vector> freeEnds(std::span<Polyline const> chains, Real tolerance)
{
    std::vector<Vector> ends;
    for (std::size_t c = 0; c < chains.size(); ++c)
    {
        if (chains[c].closed()) continue;
        for (Vector const& end : {chains[c].points().front(), chains[c].points().back()})
        {
            bool joined = false;
            for (std::size_t other = 0; other < chains.size() && !joined; ++other)
                joined = other != c && std::abs(chains[other].closest(end).distance) <= tolerance;
            if (!joined) ends.push_back(end);
        }
    }
    return ends;
}

/// Puts particles one after the other where the rules of boundaryRows allow it.
class RowBuilder
{
public:
    RowBuilder(std::span<Polyline const> chains, Real spacing)
        : spacing_(spacing),
          tree_(chains),
          placed_(leastDistance * spacing),
          freeEnds_(freeEnds(chains, joinTolerance * spacing))
    {}

    /// A particle of row k of its own segment.
    void addInRow(RowPoint const& point, int row, int chain)
    {
        auto const near = tree_.nearest(point.position);
        if (!behindSurface(near)) return;
        Real const depth = -near.distance;
        bool const sharpTip =
            row == 0 && depth >= tipClearance * spacing_ && tree_.item(near.item).segment.normal.dot(point.normal) < -0.01;
        if (depth < (row + 0.5 - shortfall) * spacing_ && !sharpTip) return;
        put(point.position, point.normal, row == 0 ? ParticleType::Wall : ParticleType::Ghost, chain);
    }

    /// A particle that completes row k at a corner or continues it.
    void addBeyond(RowPoint const& point, int row, int chain)
    {
        auto const near = tree_.nearest(point.position);
        if (!behindSurface(near) || -near.distance < (row + 0.5 - shortfall) * spacing_) return;
        bool const atFreeEnd =
            std::any_of(freeEnds_.begin(), freeEnds_.end(), [&](Vector const& end) { return (end - near.point).norm() < 1e-9 * spacing_; });
        bool const wall = row == 0 && !atFreeEnd && -near.distance <= reachOfWallRow * spacing_;
        Vector const normal = atFreeEnd ? point.normal : Vector((near.point - point.position).normalized());
        put(point.position, normal, wall ? ParticleType::Wall : ParticleType::Ghost, chain);
    }

    BoundaryRows rows;

private:
    [[nodiscard]] bool behindSurface(SegmentTree::Nearest const& near) const { return near.distance < -1e-9 * spacing_; }

    void put(Vector const& position, Vector const& normal, ParticleType type, int chain)
    {
        if (placed_.near(position)) return;
        placed_.add(position);
        rows.position.push_back(position);
        rows.normal.push_back(normal);
        rows.type.push_back(type);
        rows.chain.push_back(chain);
    }

    Real spacing_;
    SegmentTree tree_;
    PlacedPoints placed_;
    std::vector<Vector> freeEnds_;
};

} // namespace

int ghostRowsFor(Real radius) { return std::max(1, static_cast<int>(std::ceil(radius - 0.5 - 1e-9))); }

BoundaryRows boundaryRows(std::span<Polyline const> chains, std::span<int const> ghostRows, Real spacing)
{
    expect(chains.size() == ghostRows.size(), "boundaryRows: one number of rows a chain");
    if (chains.empty()) return {};
    RowBuilder builder(chains, spacing);
    std::vector<SmoothRun> const runs = smoothRuns(chains);
    std::vector<FluidCorner> const corners = fluidCorners(runs, joinTolerance * spacing);
    int const deepest = *std::max_element(ghostRows.begin(), ghostRows.end());
    auto const has = [&](int chain, int row) { return row <= ghostRows[static_cast<std::size_t>(chain)]; };

    for (int row = 0; row <= deepest; ++row)
        for (SmoothRun const& run : runs)
            if (has(run.chain, row))
                for (RowPoint const& point : parallelPoints(run, (row + 0.5) * spacing, spacing)) builder.addInRow(point, row, run.chain);

    for (int row = 0; row <= deepest; ++row)
        for (FluidCorner const& corner : corners)
            if (has(corner.chain, row) && corner.bisector.norm() <= longestBisector)
                builder.addBeyond({corner.point - (row + 0.5) * spacing * corner.bisector, corner.bisector.normalized()}, row,
                                  corner.chain);

    for (int row = 0; row <= deepest; ++row)
        for (SmoothRun const& run : runs)
            if (has(run.chain, row))
                for (RowPoint const& point :
                     continuedPoints(run, (row + 0.5) * spacing, spacing, ghostRows[static_cast<std::size_t>(run.chain)] + 2))
                    builder.addBeyond(point, row, run.chain);
    return std::move(builder.rows);
}

} // namespace mpsDem
