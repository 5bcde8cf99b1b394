#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "io/VtkFile.h"
#include "io/WaterSurface.h"
#include "support/Measured.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

using test::expectBelow;
using test::expectBetween;

/// Lattice of particles half a spacing from the borders of (low, high), in whole spacings of 1.
std::vector<Vector> lattice(std::array<int, 3> const& low, std::array<int, 3> const& high)
{
    std::vector<Vector> points;
    for (int k = low[2]; k < high[2]; ++k)
        for (int j = low[1]; j < high[1]; ++j)
            for (int i = low[0]; i < high[0]; ++i) points.emplace_back(i + 0.5, j + 0.5, k + 0.5);
    return points;
}

/// Water of 12 x 6 x 10 in a box of solid particles, three rows thick, whose sides are 10 high.
struct Tank
{
    std::vector<Vector> fluid = lattice({0, 0, 0}, {12, 6, 10}), solid;

    Tank()
    {
        for (Vector const& r : lattice({-3, -3, -3}, {15, 10, 13}))
            if (r.x() < 0 || r.x() > 12 || r.y() < 0 || r.z() < 0 || r.z() > 10) solid.push_back(r);
    }
};

WaterSurfaceControls controlsOf(Real resolution = 2, int smoothing = 20)
{
    WaterSurfaceControls controls;
    controls.spacing = 1;
    controls.resolution = resolution;
    controls.smoothing = smoothing;
    return controls;
}

TEST(WaterSurface, LiesOnTheLevelOfStillWaterAndOnTheWalls)
{
    Tank const tank;
    SurfaceMesh const mesh = waterSurface(tank.fluid, tank.solid, controlsOf());
    Real level = 0, wall = 0, floor = 0;
    for (Vector const& r : mesh.points)
    {
        bool const high = r.y() > 5, middleX = r.x() > 1 && r.x()<11, middleZ = r.z()> 1 && r.z() < 9;
        if (high && middleX && middleZ) level = std::max(level, std::abs(r.y() - 6));
        if (r.y() < 1 && middleX && middleZ) floor = std::max(floor, std::abs(r.y()));
        if (r.x() < 1 && r.y() > 1 && r.y() < 5 && middleZ) wall = std::max(wall, std::abs(r.x()));
    }
    expectBelow("water surface: level, away from walls [spacings]", level, 0.06);
    expectBelow("water surface: floor [spacings]", floor, 0.06);
    expectBelow("water surface: side wall [spacings]", wall, 0.06);
    expectBetween("water surface: volume over particles' volumes", mesh.volume() / 720, 0.96, 1.0);
}

TEST(WaterSurface, MeetsTheWallAtItsLevel)
{
    // The share of filled space is taken of what walls leave free: without that the water would bend down within two spacings of them.
    Tank const tank;
    SurfaceMesh const mesh = waterSurface(tank.fluid, tank.solid, controlsOf(4, 0));
    Real worst = 0;
    for (Vector const& r : mesh.points)
        if (r.x() > 0.25 && r.x() < 0.75 && r.y() > 4 && r.z() > 3 && r.z() < 7) worst = std::max(worst, std::abs(r.y() - 6));
    expectBelow("water surface: level within 0.75 of a wall [spacings]", worst, 0.15);
}

TEST(WaterSurface, BallHasItsVolumeAndNormals)
{
    std::vector<Vector> ball;
    Real const radius = 8;
    for (Vector const& r : lattice({-9, -9, -9}, {9, 9, 9}))
        if (r.norm() < radius) ball.push_back(r);
    SurfaceMesh const mesh = waterSurface(ball, {}, controlsOf());
    Real tilt = 0, off = 0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
        tilt = std::max(tilt, (mesh.normals[i] - mesh.points[i].normalized()).norm());
        off = std::max(off, std::abs(mesh.points[i].norm() - radius));
    }
    expectBelow("water surface: ball, largest distance from the sphere [spacings]", off, 0.5);
    expectBelow("water surface: ball, largest error of a normal", tilt, 0.4);
    expectBetween("water surface: ball, volume over particles' volumes", mesh.volume() / static_cast<Real>(ball.size()), 0.97, 1.03);
}

TEST(WaterSurface, IsCutOpenAtAPlane)
{
    Tank const tank;
    auto controls = controlsOf();
    controls.cuts = {CutPlane{Vector(0, 0, 4.3), Vector::UnitZ()}};
    Real middle = 0, rim = 0, plain = 0;
    for (Vector const& r : waterSurface(tank.fluid, tank.solid, controls).points)
    {
        if (r.z() > 3.9 && r.x() > 2 && r.x() < 10 && r.y() > 2 && r.y() < 4) middle = std::max(middle, std::abs(r.z() - 4.3));
        rim = std::max(rim, r.z() - 4.3);
    }
    controls.smoothing = 0;
    for (Vector const& r : waterSurface(tank.fluid, tank.solid, controls).points) plain = std::max(plain, r.z());
    expectBelow("water surface: cut, before smoothing [spacings]", plain - 4.3, 1e-5);
    expectBelow("water surface: cut, its middle [spacings]", middle, 0.06);
    expectBelow("water surface: cut, its rim [spacings]", rim, 0.1); // smoothing a right angle overshoots
}

TEST(WaterSurface, IsCutAtSeveralPlanes)
{
    Tank const tank; // 12 x 6 x 10 spacings
    auto controls = controlsOf(2, 0);
    controls.cuts = {CutPlane{Vector(9, 0, 0), Vector::UnitX()}, CutPlane{Vector(3, 0, 0), -Vector::UnitX()}};
    SurfaceMesh const mesh = waterSurface(tank.fluid, tank.solid, controls);
    expectBetween("water surface: between two cuts, volume over particles' volumes", mesh.volume() / 360, 0.96, 1.0);
    Real low = 1e300, high = -1e300;
    for (Vector const& r : mesh.points) low = std::min(low, r.x()), high = std::max(high, r.x());
    expectBelow("water surface: between two cuts, farthest beyond [spacings]", std::max(3 - low, high - 9), 1e-5);
}

TEST(WaterSurface, PassesALoneDropBy)
{
    std::vector<Vector> fluid = lattice({0, 0, 0}, {6, 6, 6});
    fluid.emplace_back(20, 3, 3);
    SurfaceMesh const mesh = waterSurface(fluid, {}, controlsOf());
    for (Vector const& r : mesh.points) EXPECT_LT(r.x(), 7);
    auto const share = filledShare(fluid, {}, controlsOf());
    expectBetween("filled share at a lone particle, 21 / (16 pi)", share.back(), 0.4177, 0.4179);
    EXPECT_GT(share[3 + 6 * 3 + 36 * 3], 0.95);
    // Beside walls no particle of still water is a drop; one that has sunk into the floor is.
    Tank tank;
    tank.fluid.emplace_back(6, -0.6, 5);
    auto const inTank = filledShare(tank.fluid, tank.solid, controlsOf());
    EXPECT_LT(inTank.back(), 0.5);
    EXPECT_GT(*std::min_element(inTank.begin(), inTank.end() - 1), 0.5);
    EXPECT_TRUE(waterSurface({}, {}, controlsOf()).points.empty());
}

TEST(WaterSurface, MeansOfValues)
{
    std::vector<Vector> const fluid = lattice({0, 0, 0}, {8, 8, 8}), places{Vector(4, 4, 4), Vector(4.2, 3.7, 4.4), Vector(40, 0, 0)};
    std::vector<Real> height;
    for (Vector const& r : fluid) height.push_back(r.y());
    KernelMean const mean(fluid, 2);
    auto const found = mean.at(places, height);
    EXPECT_NEAR(found[0], 4, 1e-12) << "middle of a lattice cell";
    EXPECT_NEAR(found[1], 3.7, 0.05);
    EXPECT_EQ(found[2], 0) << "no particle near";
    EXPECT_NEAR(mean.at(places, fluid)[0].z(), 4, 1e-12);
}

TEST(WaterSurface, FileForParaViewKeepsPointsNormalsAndArrays)
{
    std::vector<Vector> const points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, normals(3, Vector::UnitZ());
    std::vector<std::array<int, 3>> const triangles{{0, 1, 2}};
    std::vector<Real> const elevation{0.5, 1.5, 2.5};
    TriangleCells cells;
    cells.points = points;
    cells.normals = normals;
    cells.triangles = triangles;
    cells.scalars.emplace_back("elevation", elevation);
    TemporaryFolder folder;
    writeTriangles(folder / "surface.vtp", cells, 0.25);
    auto const cloud = readPointCloud(folder / "surface.vtp");
    auto const surface = readSurface(folder / "surface.vtp");
    EXPECT_EQ(cloud.time, 0.25);
    EXPECT_EQ(cloud.position, points);
    EXPECT_EQ(cloud.scalars.at("elevation"), elevation);
    EXPECT_EQ(cloud.vectors.at("Normals"), normals);
    ASSERT_EQ(surface.polygons.size(), 1U);
    EXPECT_EQ(surface.polygons[0], (std::vector<std::int64_t>{0, 1, 2}));
}

} // namespace
} // namespace mpsDem
