#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "boundaries/BoundaryRows.h"
#include "scene/GeometryReader.h"

namespace {

using namespace mpsDem;

constexpr Real spacing = 0.02;

BoundaryRows rowsOf(Polyline const& outline)
{
    int const ghostRows = 2;
    return boundaryRows(std::span(&outline, 1), std::span(&ghostRows, 1), spacing);
}

struct Summary
{
    int walls = 0, ghosts = 0;
    Real least = std::numeric_limits<Real>::infinity();      ///< Distance of two particles [spacings].
    Real shallowest = std::numeric_limits<Real>::infinity(); ///< Depth of a wall particle [spacings].
};

Summary summaryOf(Polyline const& outline)
{
    auto const rows = rowsOf(outline);
    Summary sum;
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        EXPECT_TRUE(outline.encloses(rows.position[i]));
        Real const depth = -outline.closest(rows.position[i]).distance / spacing;
        if (rows.type[i] == ParticleType::Wall) sum.shallowest = std::min(sum.shallowest, depth);
        if (rows.type[i] == ParticleType::Wall)
            ++sum.walls;
        else
            ++sum.ghosts;
        for (std::size_t j = 0; j < i; ++j) sum.least = std::min(sum.least, (rows.position[i] - rows.position[j]).norm() / spacing);
    }
    return sum;
}

TEST(BodyRows, BoxHasARowOfWallParticlesHalfASpacingInside)
{
    auto const sum = summaryOf(Polyline::outline("box", {{0, 0, 0}, {0.4, 0, 0}, {0.4, 0.2, 0}, {0, 0.2, 0}}));
    EXPECT_EQ(sum.walls, 2 * 20 + 2 * 10 - 4);                          // a ring of cells
    EXPECT_EQ(sum.ghosts, (2 * 18 + 2 * 8 - 4) + (2 * 16 + 2 * 6 - 4)); // two more rings
    EXPECT_NEAR(sum.least, 1, 1e-9);
    EXPECT_NEAR(sum.shallowest, 0.5, 1e-9);
}

TEST(BodyRows, SharpTipsAreSampledUpToAFifthOfASpacing)
{
    auto const wedge = Polyline::outline("slide", {{0.01, 0.99, 0}, {0.51, 0.49, 0}, {0.51, 0.99, 0}});
    auto const sum = summaryOf(wedge);
    EXPECT_GE(sum.least, 0.7);
    EXPECT_GE(sum.shallowest, 0.2 - 1e-12);
    // The wall row reaches into the tips of 45 degrees: a particle within 1.7 spacings of either, where half a spacing of depth from both
    // sides would end at 0.5 / sin(22.5 degrees) = 1.31 spacings and the even row at most half a spacing behind that.
    auto const rows = rowsOf(wedge);
    for (Vector const& tip : {Vector(0.01, 0.99, 0), Vector(0.51, 0.49, 0)})
    {
        Real nearest = std::numeric_limits<Real>::infinity();
        for (std::size_t i = 0; i < rows.position.size(); ++i)
            if (rows.type[i] == ParticleType::Wall) nearest = std::min(nearest, (rows.position[i] - tip).norm() / spacing);
        EXPECT_LE(nearest, 1.7);
    }
}

TEST(BodyRows, CylinderHasRowsAsEvenAsACircle)
{
    Real const radius = 0.1;
    auto const rows = rowsOf(Polyline::outline("cylinder", circlePoints({0.3, 0.2, 0}, radius, spacing)));
    std::vector<int> count(3, 0);
    for (Vector const& r : rows.position)
    {
        Real const depth = (radius - (r - Vector(0.3, 0.2, 0)).norm()) / spacing - 0.5;
        int const row = static_cast<int>(std::lround(depth));
        ASSERT_TRUE(row >= 0 && row <= 2);
        EXPECT_NEAR(depth, row, 0.02);
        ++count[static_cast<std::size_t>(row)];
    }
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(count[static_cast<std::size_t>(k)], static_cast<int>(std::lround(2 * std::numbers::pi * (radius / spacing - k - 0.5))))
            << k;
}

TEST(BodyRows, RowsDoNotDependOnTheSenseOfThePoints)
{
    std::vector<Vector> const points{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.1, 0}, {0.1, 0.1, 0}, {0.1, 0.3, 0}, {0, 0.3, 0}};
    std::vector<Vector> const reversed(points.rbegin(), points.rend());
    auto const a = summaryOf(Polyline::outline("angle", points)), b = summaryOf(Polyline::outline("angle", reversed));
    EXPECT_EQ(a.walls, b.walls);
    EXPECT_EQ(a.ghosts, b.ghosts);
    EXPECT_GE(a.least, 0.7);
}

TEST(BodyRows, ThinBodyKeepsItsWallRow)
{
    auto const sum = summaryOf(Polyline::outline("plate", {{0, 0, 0}, {0.4, 0, 0}, {0.4, spacing, 0}, {0, spacing, 0}}));
    EXPECT_EQ(sum.walls, 20);
    EXPECT_EQ(sum.ghosts, 0);
}

} // namespace
