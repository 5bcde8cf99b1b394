#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "functionObjects/SurfaceElevation.h"
#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

using Method = SurfaceElevationControls::Method;

SurfaceElevationControls controlsOf(Method method)
{
    SurfaceElevationControls controls;
    controls.method = method;
    return controls;
}

/// Largest error over the surface of water whose rows lie parallel to a surface tilted by `degrees`, in spacings.
Real tiltError(Method method, Real degrees)
{
    Real const angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    FunctionObjectScene scene({2, 1, 1});
    std::vector<FunctionObjectScene::Point> points;
    for (int i = -40; i < 40; ++i)
        for (int j = 0; j < 20; ++j)
        {
            Real const x = i + 0.31, y = -(j + 0.5);
            points.push_back({Vector(c * x - s * y, s * x + c * y, 0)});
        }
    scene.place(points);
    SurfaceElevation surface(scene.particles, controlsOf(method), Vector::UnitY());
    surface.update();
    Real worst = 0;
    for (Real x = -10; x <= 10; x += 0.17) worst = std::max(worst, std::abs(*surface.elevation({x, 0, 0}) - std::tan(angle) * x));
    return worst;
}

TEST(SurfaceElevation, IsExactForALevelLattice)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(40, 10));
    SurfaceElevation surface(scene.particles, controlsOf(Method::Volume), Vector::UnitY());
    surface.update();
    for (Real const x : {0.5, 1.234, 2.0, 3.07}) EXPECT_NEAR(*surface.elevation({x, 0, 0}), 1.0, 1e-12);
}

TEST(SurfaceElevation, TiltedStillSurfaceIsFoundWithinATenthOfASpacing)
{
    for (Real const degrees : {0.0, 3.0, 10.0, 20.0, 30.0})
    {
        for (Method const method : {Method::Volume, Method::Top})
        {
            Real const error = tiltError(method, degrees);
            char name[64];
            std::snprintf(name, sizeof name, "surface at %g degrees, %s", degrees, method == Method::Volume ? "volume" : "top");
            std::printf("%-48s %14.6g  bound %g\n", name, error, 0.1);
            EXPECT_LT(error, 0.1);
        }
    }
}

TEST(SurfaceElevation, DoesNotSeeDropsAndSideWalls)
{
    for (Method const method : {Method::Volume, Method::Top})
    {
        FunctionObjectScene scene({2, 0.1, 1});
        auto points = scene.block(40, 10);
        for (int k = 0; k < 5; ++k) points.push_back({Vector(1.0 + 0.1 * k, 2, 0)});
        for (int k = 0; k < 30; ++k) points.push_back({Vector(-0.05, 0.05 + 0.1 * k, 0), ParticleType::Wall, Vector::UnitX()});
        scene.place(points);
        SurfaceElevation surface(scene.particles, controlsOf(method), Vector::UnitY());
        surface.update();
        EXPECT_NEAR(*surface.elevation({1.2, 0, 0}), 1, 0.006); // 0.05 spacings is what method top is off on a lattice
        EXPECT_NEAR(*surface.elevation({0.1, 0, 0}), 1, method == Method::Volume ? 1e-12 : 0.05);
    }
}

TEST(SurfaceElevation, FilmOnAFloorIsAsDeepAsItIs)
{
    FunctionObjectScene scene({2, 0.1, 1});
    auto points = scene.block(20, 1);
    for (int k = 0; k < 20; ++k)
        for (int row = 0; row < 3; ++row)
            points.push_back(
                {Vector(0.05 + 0.1 * k, -0.05 - 0.1 * row, 0), row == 0 ? ParticleType::Wall : ParticleType::Ghost, Vector::UnitY()});
    scene.place(points);
    SurfaceElevation surface(scene.particles, controlsOf(Method::Volume), Vector::UnitY());
    surface.update();
    EXPECT_NEAR(*surface.elevation({1, 0, 0}), 0.1, 1e-12);
}

TEST(SurfaceElevation, HasNothingWhereItIsDry)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(10, 5));
    SurfaceElevation surface(scene.particles, controlsOf(Method::Volume), Vector::UnitY());
    surface.update();
    EXPECT_FALSE(surface.elevation({2, 0, 0}).has_value());
}

TEST(SurfaceElevation, HoldsIn3DWithZUp)
{
    FunctionObjectScene scene({3, 0.1, 1});
    std::vector<FunctionObjectScene::Point> points;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            for (int k = 0; k < 5; ++k) points.push_back({Vector(0.05 + 0.1 * i, 0.05 + 0.1 * j, 0.05 + 0.1 * k)});
    scene.place(points);
    SurfaceElevation surface(scene.particles, controlsOf(Method::Volume), Vector::UnitZ());
    surface.update();
    EXPECT_NEAR(*surface.elevation({0.41, 0.37, 7}), 0.5, 1e-12);
}

} // namespace
} // namespace mpsDem
