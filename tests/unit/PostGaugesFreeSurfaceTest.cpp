#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "postGauges/FreeSurface.h"
#include "support/Measured.h"

namespace mpsDem::postGauges {

namespace {

constexpr Real dx = 0.02;

/// Lattice points below a surface y = eta(x) and above a bed, disturbed by up to `jitter` spacings.
std::vector<Vector> water(std::function<Real(Real)> const& eta, std::function<Real(Real)> const& bed, Real jitter)
{
    std::mt19937_64 engine(7);
    auto const shift = [&] { return jitter * dx * (2 * (static_cast<Real>(engine() >> 11) * 0x1p-53) - 1); };
    std::vector<Vector> points;
    for (int i = 0; i < 100; ++i)
    {
        for (int j = 0; j < 60; ++j)
        {
            Real const x = (i + 0.5) * dx, y = (j + 0.5) * dx;
            if (y < eta(x) && y > bed(x)) points.emplace_back(x + shift(), y + shift(), 0);
        }
    }
    return points;
}

std::vector<Vector> levelWater(Real depth, Real jitter = 0)
{
    return water([depth](Real) { return depth; }, [](Real) { return 0.0; }, jitter);
}

/// Three rows of wall and ghost particles below y = 0.
std::vector<Vector> floorRows()
{
    std::vector<Vector> points;
    for (int i = -3; i < 103; ++i)
        for (int j = 0; j < 3; ++j) points.emplace_back((i + 0.5) * dx, -(j + 0.5) * dx, 0);
    return points;
}

SurfaceSettings settings(SurfaceMethod method)
{
    SurfaceSettings s;
    s.spacing = dx;
    s.method = method;
    return s;
}

Real eta(std::vector<Vector> const& fluid, std::vector<Vector> const& solid, SurfaceMethod method, Real x)
{
    return FreeSurface(fluid, solid, settings(method)).elevation(Vector(x, 0, 0)).value();
}

} // namespace

TEST(PostGaugesFreeSurface, levelLatticeIsExactByVolume)
{
    auto const fluid = levelWater(0.8);
    for (Real const x : {0.5, 0.507, 0.51, 1.2345})
        test::expectBelow("level lattice, volume, error [spacings]", (eta(fluid, floorRows(), SurfaceMethod::Volume, x) - 0.8) / dx, 1e-9);
}

TEST(PostGaugesFreeSurface, levelLatticeByTopIsWithinATenthOfASpacing)
{
    auto const fluid = levelWater(0.8);
    for (Real const x : {0.5, 0.507, 0.51, 1.2345})
        test::expectBelow("level lattice, top, error [spacings]", (eta(fluid, floorRows(), SurfaceMethod::Top, x) - 0.8) / dx, 0.1);
}

TEST(PostGaugesFreeSurface, disturbedLatticeGivesLittleNoise)
{
    // Independent shifts within 0.15 spacings (deviation s = 0.087) of about 3 x 2 particles at the sides, 2 at the base and 2 at the top of
    // a column 2 spacings wide: deviation sqrt(10) s / 2 = 0.14 spacings.
    auto const fluid = levelWater(0.8, 0.15);
    FreeSurface const volume(fluid, floorRows(), settings(SurfaceMethod::Volume));
    FreeSurface const top(fluid, floorRows(), settings(SurfaceMethod::Top));
    Real volumeSquares = 0, topSquares = 0;
    int places = 0;
    for (Real x = 0.3; x < 1.7; x += 0.013, ++places)
    {
        volumeSquares += std::pow((volume.elevation(Vector(x, 0, 0)).value() - 0.8) / dx, 2);
        topSquares += std::pow((top.elevation(Vector(x, 0, 0)).value() - 0.8) / dx, 2);
    }
    test::expectBelow("jitter 0.15, volume, rms [spacings]", std::sqrt(volumeSquares / places), 0.17);
    test::expectBelow("jitter 0.15, top, rms [spacings]", std::sqrt(topSquares / places), 0.13);
}

TEST(PostGaugesFreeSurface, tiltedSurfaceIsUnbiased)
{
    // The lattice makes steps of one spacing out of a slope of 0.1; a window of ten spacings holds one whole step.
    auto const slope = [](Real x) { return 0.6 + 0.1 * x; };
    auto const fluid = water(
        slope, [](Real) { return 0.0; }, 0);
    auto wide = settings(SurfaceMethod::Volume);
    wide.width = 10;
    FreeSurface const surface(fluid, floorRows(), wide);
    Real worst = 0;
    for (Real x = 0.4; x < 1.6; x += 0.013) worst = std::max(worst, std::abs(surface.elevation(Vector(x, 0, 0)).value() - slope(x)));
    test::expectBelow("slope 0.1, width 10, worst [spacings]", worst / dx, 0.1);
}

TEST(PostGaugesFreeSurface, dropsAreNotSeen)
{
    auto fluid = levelWater(0.8);
    Real const before = eta(fluid, floorRows(), SurfaceMethod::Volume, 1.0);
    for (int i = 0; i < 6; ++i) fluid.emplace_back(0.95 + i * dx, 1.1, 0);
    FreeSurface const surface(fluid, floorRows(), settings(SurfaceMethod::Volume));
    EXPECT_EQ(surface.drops(), 6U);
    EXPECT_EQ(surface.elevation(Vector(1.0, 0, 0)).value(), before);
    EXPECT_FALSE(surface.elevation(Vector(3.0, 0, 0)).has_value()) << "no fluid there";
}

TEST(PostGaugesFreeSurface, thinFilmKeepsItsDepth)
{
    auto const fluid = levelWater(2 * dx);
    test::expectBelow("film of 2 spacings, volume [spacings]", (eta(fluid, floorRows(), SurfaceMethod::Volume, 1.0) - 2 * dx) / dx, 1e-9);
    test::expectBelow("film of 2 spacings, top [spacings]", (eta(fluid, floorRows(), SurfaceMethod::Top, 1.0) - 2 * dx) / dx, 0.1);
}

TEST(PostGaugesFreeSurface, sideWallAboveTheWaterIsNotWater)
{
    auto solid = floorRows();
    for (int k = 0; k < 3; ++k)
        for (int j = -3; j < 60; ++j) solid.emplace_back(-(k + 0.5) * dx, (j + 0.5) * dx, 0);
    auto const fluid = levelWater(0.8);
    test::expectBelow("gauge beside a wall, volume [spacings]", (eta(fluid, solid, SurfaceMethod::Volume, dx) - 0.8) / dx, 1e-9);
    test::expectBelow("gauge beside a wall, top [spacings]", (eta(fluid, solid, SurfaceMethod::Top, dx) - 0.8) / dx, 0.1);
}

TEST(PostGaugesFreeSurface, blockInThreeDimensionsWithUpAlongZ)
{
    std::vector<Vector> fluid;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j)
            for (int k = 0; k < 10; ++k) fluid.emplace_back((i + 0.5) * dx, (j + 0.5) * dx, (k + 0.5) * dx);
    auto s = settings(SurfaceMethod::Volume);
    s.dimensions = 3;
    s.up = Vector::UnitZ();
    Real const byVolume = FreeSurface(fluid, {}, s).elevation(Vector(0.111, 0.123, 0)).value();
    test::expectBelow("3-D block, volume, error [spacings]", (byVolume - 10 * dx) / dx, 1e-9);
    s.method = SurfaceMethod::Top;
    Real const byTop = FreeSurface(fluid, {}, s).elevation(Vector(0.111, 0.123, 0)).value();
    test::expectBelow("3-D block, top, error [spacings]", (byTop - 10 * dx) / dx, 0.1);
}

TEST(PostGaugesFreeSurface, groupsOfParticles)
{
    std::vector<Vector> const points = {{0, 0, 0}, {1, 0, 0}, {2, 0.5, 0}, {10, 0, 0}, {-5, 0, 0}, {-5, 1, 0}};
    EXPECT_EQ(groupSizes(points, 1.2), (std::vector<int>{3, 3, 3, 1, 2, 2}));
    EXPECT_TRUE(groupSizes({}, 1.0).empty());
}

} // namespace mpsDem::postGauges
