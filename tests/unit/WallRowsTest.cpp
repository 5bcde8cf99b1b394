#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "boundaries/BoundaryRows.h"
#include "boundaries/SegmentTree.h"
#include "scene/GeometryReader.h"

namespace {

using namespace mpsDem;
using Side = Polyline::FluidSide;

constexpr Real spacing = 0.02;

BoundaryRows rowsOf(std::vector<Polyline> const& walls, int ghostRows = 2)
{
    return boundaryRows(walls, std::vector<int>(walls.size(), ghostRows), spacing);
}

bool has(BoundaryRows const& rows, Vector const& place, ParticleType type)
{
    for (std::size_t i = 0; i < rows.position.size(); ++i)
        if ((rows.position[i] - place).norm() < 1e-9 && rows.type[i] == type) return true;
    return false;
}

Real leastDistance(BoundaryRows const& rows)
{
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < rows.position.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, (rows.position[i] - rows.position[j]).norm());
    return least;
}

/// A wall particle near every place of the parallel half a spacing behind the wall: the greatest distance from such a place [spacings].
Real greatestHole(BoundaryRows const& rows, Vector const& begin, Vector const& end)
{
    Real hole = 0;
    for (int k = 0; k <= 1000; ++k)
    {
        Vector const place = begin + (k / 1000.0) * (end - begin);
        Real nearest = std::numeric_limits<Real>::infinity();
        for (std::size_t i = 0; i < rows.position.size(); ++i)
            if (rows.type[i] == ParticleType::Wall) nearest = std::min(nearest, (rows.position[i] - place).norm());
        hole = std::max(hole, nearest / spacing);
    }
    return hole;
}

TEST(WallRows, StraightWallHasItsRowHalfASpacingBehindTheSurface)
{
    auto const rows = rowsOf({Polyline("floor", {{0, 0, 0}, {1, 0, 0}}, false, Side::Left)});
    int walls = 0;
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        if (rows.type[i] != ParticleType::Wall) continue;
        ++walls;
        EXPECT_NEAR(rows.position[i].y(), -spacing / 2, 1e-14);
        EXPECT_NEAR(rows.normal[i].y(), 1, 1e-14);
    }
    EXPECT_EQ(walls, 50); // L / l0: the row goes on beyond the open ends as ghosts only
    for (int k = 1; k <= 2; ++k) EXPECT_TRUE(has(rows, {0.5 * spacing, -(k + 0.5) * spacing, 0}, ParticleType::Ghost));
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(has(rows, {-(i + 0.5) * spacing, -0.5 * spacing, 0}, ParticleType::Ghost));
}

TEST(WallRows, CornerOfATankIsFilledOnce)
{
    auto const rows = rowsOf({Polyline("tank", {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, false, Side::Left)});
    Real const h = spacing / 2;
    EXPECT_TRUE(has(rows, {-h, -h, 0}, ParticleType::Wall)); // on the bisector
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            if (i + j == 0) continue;
            EXPECT_TRUE(has(rows, {-h - i * spacing, -h - j * spacing, 0}, ParticleType::Ghost)) << i << " " << j;
        }
    EXPECT_NEAR(leastDistance(rows), spacing, 1e-9);
}

TEST(WallRows, RampAndFloorAsTwoWallsJoinLikeOne)
{
    std::vector<Vector> const points{{-0.6, 1.6, 0}, {1, 0, 0}, {4, 0, 0}};
    auto const one = rowsOf({Polyline("bed", points, false, Side::Left)});
    auto const two =
        rowsOf({Polyline("ramp", {points[0], points[1]}, false, Side::Left), Polyline("floor", {points[1], points[2]}, false, Side::Left)});
    ASSERT_EQ(one.position.size(), two.position.size());
    for (std::size_t i = 0; i < one.position.size(); ++i)
        EXPECT_TRUE(has(two, one.position[i], one.type[i])) << one.position[i].transpose();
    EXPECT_GE(leastDistance(two), 0.7 * spacing);
    // No hole in the wall row at the foot, whose parallel turns at foot - l0 / 2 (tan 22.5 degrees, 1).
    Vector const turn(1 - 0.5 * spacing * std::tan(std::numbers::pi / 8), -0.5 * spacing, 0);
    Vector const alongRamp = Vector(-1, 1, 0).normalized();
    EXPECT_LE(greatestHole(two, turn, turn + 0.5 * alongRamp), 0.55);
    EXPECT_LE(greatestHole(two, turn, turn + Vector(0.5, 0, 0)), 0.55);
}

TEST(WallRows, RampCutIntoPiecesKeepsItsParticles)
{
    auto const cut = [](int pieces) {
        std::vector<Vector> points;
        for (int k = 0; k <= pieces; ++k) points.emplace_back(1.6 * k / pieces, 1.6 - 1.6 * k / pieces, 0);
        return rowsOf({Polyline("ramp", points, false, Side::Left)});
    };
    auto const whole = cut(1);
    for (int const pieces : {2, 200, 2000})
    {
        auto const rows = cut(pieces);
        ASSERT_EQ(rows.position.size(), whole.position.size()) << pieces;
        Real worst = 0;
        for (std::size_t i = 0; i < rows.position.size(); ++i) worst = std::max(worst, (rows.position[i] - whole.position[i]).norm());
        EXPECT_LT(worst, 1e-9);
    }
}

TEST(WallRows, StepEdgeOfTheSolidHasNoParticleNearerThanItsRow)
{
    // The solid fills x > 0, y < 0: an edge of 270 degrees of fluid.
    std::vector<Polyline> const walls{Polyline("step", {{0, -1, 0}, {0, 0, 0}, {1, 0, 0}}, false, Side::Left)};
    auto const rows = rowsOf(walls);
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        if (rows.position[i].x() > 1 || rows.position[i].y() < -1) continue; // beyond the open ends
        Real const depth = -walls[0].closest(rows.position[i]).distance;
        EXPECT_GE(depth, (rows.type[i] == ParticleType::Wall ? 0.48 : 1.48) * spacing - 1e-12) << rows.position[i].transpose();
    }
    EXPECT_TRUE(has(rows, {0.5 * spacing, -0.5 * spacing, 0}, ParticleType::Wall));
}

TEST(WallRows, EveryParticleLiesBehindTheSurfaceAndApartFromOthers)
{
    for (Real const degrees : {20.0, 45.0, 70.0, 100.0, 135.0, 160.0}) // of fluid between two walls
    {
        Real const angle = degrees * std::numbers::pi / 180;
        std::vector<Polyline> const walls{
            Polyline("wedge", {{std::cos(angle), std::sin(angle), 0}, {0, 0, 0}, {1, 0, 0}}, false, Side::Left)};
        auto const rows = rowsOf(walls);
        for (Vector const& r : rows.position) EXPECT_LT(walls[0].closest(r).distance, 0) << degrees;
        EXPECT_GE(leastDistance(rows), 0.7 * spacing) << degrees;
    }
}

TEST(WallRows, CirclesOfFluidHaveEvenRows)
{
    Real const radius = 0.25;
    auto const rows = rowsOf({Polyline("pipe", circlePoints(Vector::Zero(), radius, spacing), true, Side::Left)});
    int walls = 0;
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        if (rows.type[i] != ParticleType::Wall) continue;
        ++walls;
        EXPECT_NEAR(rows.position[i].norm(), radius + spacing / 2, 0.01 * spacing);
    }
    EXPECT_EQ(walls, static_cast<int>(std::lround(2 * std::numbers::pi * (radius + spacing / 2) / spacing)));
    EXPECT_GE(leastDistance(rows), 0.9 * spacing);
}

TEST(WallRows, GhostRowsFollowTheKernel)
{
    EXPECT_EQ(ghostRowsFor(2.1), 2);
    EXPECT_EQ(ghostRowsFor(3.1), 3);
    EXPECT_EQ(ghostRowsFor(4.01), 4);
}

TEST(SegmentTree, AgreesWithASearchOverAllSegments)
{
    std::vector<Vector> points;
    for (int k = 0; k <= 400; ++k) points.emplace_back(0.01 * k, 0.3 * std::sin(0.05 * k) + 0.02 * ((k * 37) % 11), 0);
    std::vector<Polyline> const chains{Polyline("bed", points, false, Side::Left)};
    SegmentTree const tree(chains);
    for (int k = 0; k < 2000; ++k)
    {
        Vector const r(-0.5 + 0.0025 * k, -1 + 0.001 * ((k * 613) % 2000), 0);
        EXPECT_NEAR(tree.nearest(r).distance, chains[0].closest(r).distance, 1e-12);
    }
}

} // namespace
