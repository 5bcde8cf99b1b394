#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "core/TriSurface.h"

namespace mpsDem {
namespace {

TEST(TriSurface, boxHasItsVolumeItsNormalsOutwardsAndSixPlaneSides)
{
    TriSurface const box = TriSurface::box("box", {1, 2, 3}, {2, 4, 6});
    EXPECT_NEAR(box.volume(), 6, 1e-12);
    EXPECT_NEAR(box.area(), 22, 1e-12);
    EXPECT_TRUE(box.closed());
    EXPECT_EQ(box.patches(), 6);
    EXPECT_EQ(box.edges().size(), 18u);
    Vector sum = Vector::Zero();
    for (auto const& t : box.triangles())
    {
        EXPECT_GT(t.normal.dot(box.centre(t) - Vector(1.5, 3, 4.5)), 0);
        sum += t.area * t.normal;
    }
    EXPECT_LT(sum.norm(), 1e-12);
    for (auto const& edge : box.edges()) EXPECT_TRUE(std::abs(edge.turn) < 1e-12 || edge.turn > 0.99);
}

TEST(TriSurface, openBoxHasRimsAndFlippedItHoldsFluid)
{
    TriSurface const tank = TriSurface::box("tank", {0, 0, 0}, {1, 1, 1}, {false, false, false, true, false, false}).flipped();
    EXPECT_FALSE(tank.closed());
    EXPECT_EQ(tank.patches(), 5);
    int rims = 0;
    for (auto const& edge : tank.edges())
    {
        if (edge.rim()) ++rims;
        EXPECT_TRUE(std::abs(edge.turn) < 1e-12 || edge.turn < -0.99) << "valleys of the fluid's box";
    }
    EXPECT_EQ(rims, 4);
    for (auto const& t : tank.triangles()) EXPECT_LT(t.normal.dot(tank.centre(t) - Vector(0.5, 0.5, 0.5)), 0);
}

TEST(TriSurface, prismOverAConcavePolygonHasItsVolumeInAnySenseOfRotation)
{
    std::vector<Vector> corners{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}};
    Real const area = 2 * 2 - 0.5 * 2 * 1.5;
    for (int turn = 0; turn < 2; ++turn)
    {
        TriSurface const prism = TriSurface::prism("prism", corners, -0.5, 1);
        EXPECT_NEAR(prism.volume(), 1.5 * area, 1e-12);
        EXPECT_TRUE(prism.closed());
        EXPECT_EQ(prism.patches(), 7);
        std::reverse(corners.begin(), corners.end());
    }
}

TEST(TriSurface, stripsHaveTheFluidOnTheSideThatIsAskedFor)
{
    TriSurface const floor = TriSurface::extruded("floor", {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, false, 0, 3, true);
    EXPECT_NEAR(floor.triangles()[0].normal.y(), 1, 1e-12);
    EXPECT_EQ(floor.patches(), 2);
    EXPECT_NEAR(floor.area(), 3 * (1 + std::sqrt(2)), 1e-12);
    EXPECT_NEAR(TriSurface::extruded("roof", {{0, 0, 0}, {1, 0, 0}}, false, 0, 3, false).triangles()[0].normal.y(), -1, 1e-12);
}

TEST(TriSurface, channelHoldsTheFluidBetweenItsSideWallsWhateverTheSenseOfItsPoints)
{
    std::vector<Vector> chain{{-0.6, 1.6, 0}, {1, 0, 0}, {6, 0, 0}, {6, 1.6, 0}};
    Real const side = 1.6 * (5 + 6.6) / 2;
    for (int turn = 0; turn < 2; ++turn)
    {
        TriSurface const channel = TriSurface::channel("basin", chain, 0, 0.5);
        EXPECT_EQ(channel.patches(), 5); // ramp, floor, end, two sides
        EXPECT_NEAR(channel.area(), 2 * side + 0.5 * (1.6 * std::sqrt(2) + 5 + 1.6), 1e-12);
        for (auto const& t : channel.triangles()) EXPECT_GT(t.normal.dot(Vector(3, 0.8, 0.25) - channel.centre(t)), 0);
        int rims = 0;
        for (auto const& edge : channel.edges()) rims += edge.rim() ? 1 : 0;
        EXPECT_EQ(rims, 4) << "open above";
        std::reverse(chain.begin(), chain.end());
    }
}

TEST(TriSurface, cylinderAndSphereApproachTheirVolumes)
{
    TriSurface const cylinder = TriSurface::cylinder("rod", {1, 0, 0}, {1, 2, 1}, 0.5, 64);
    EXPECT_NEAR(cylinder.volume() / (std::numbers::pi * 0.25 * std::sqrt(5)), 1, 2e-3);
    EXPECT_TRUE(cylinder.closed());
    TriSurface const sphere = TriSurface::sphere("ball", {1, 2, 3}, 0.5, 0.05);
    EXPECT_NEAR(sphere.volume() / (4 * std::numbers::pi / 3 * 0.125), 1, 5e-3);
    EXPECT_TRUE(sphere.closed());
    for (auto const& edge : sphere.edges())
        EXPECT_LE((sphere.points()[static_cast<std::size_t>(edge.a)] - sphere.points()[static_cast<std::size_t>(edge.b)]).norm(), 0.05);
}

TEST(TriSurface, movedKeepsVolumeAndTurnsNormals)
{
    TriSurface const box = TriSurface::box("box", {0, 0, 0}, {1, 2, 3});
    Tensor const turn = Eigen::AngleAxisd(0.7, Vector(1, 1, 0).normalized()).toRotationMatrix();
    TriSurface const moved = box.moved(turn, {5, 0, 0});
    EXPECT_NEAR(moved.volume(), 6, 1e-12);
    EXPECT_LT((moved.triangles()[3].normal - turn * box.triangles()[3].normal).norm(), 1e-15);
}

void refuses(std::vector<Vector> const& points, std::vector<TriSurface::Corners> const& triangles, std::string const& word)
{
    try
    {
        TriSurface("bad", points, triangles);
        ADD_FAILURE() << "accepted, wanted: " << word;
    }
    catch (CaseError const& error)
    {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(TriSurface, refusesWhatIsNoSurface)
{
    std::vector<Vector> const points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
    refuses(points, {}, "no triangle");
    refuses(points, {{0, 1, 7}}, "no point 7");
    refuses(points, {{0, 1, 1}}, "no area");
    refuses(points, {{0, 1, 2}, {0, 1, 3}}, "opposite orientation");
    refuses(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, "3 triangles");
    refuses({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}}, "not finite");
}

} // namespace
} // namespace mpsDem
