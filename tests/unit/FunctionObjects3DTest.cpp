#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"
#include "support/Measured.h"

namespace mpsDem {
namespace {

using test::expectBelow;

constexpr Real l0 = 0.1;

/// Largest error of interfaceHeight over places all over the water [spacings].
Real gaugeError(std::string const& keys, std::function<Real(Real, Real)> const& surface)
{
    FunctionObjectScene scene({3, l0, 1});
    scene.place(scene.columns(40, 30, 10, surface));
    RunContext const context = scene.context();
    std::vector<Vector> places;
    std::string text = "type interfaceHeight; " + keys + " locations (";
    for (Real x = 0.61; x < 3.4; x += 0.37)
        for (Real z = 0.57; z < 2.4; z += 0.29)
        {
            places.emplace_back(x, 0, z);
            text += "(" + std::to_string(x) + " 0 " + std::to_string(z) + ")";
        }
    makeFunctionObject(text + ");", context)->write({1, 0.5, 0.1, false});
    Table const table = scene.table("watch/0/height.dat");
    Real worst = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
        worst = std::max(worst, std::abs(table.column("eta" + std::to_string(k))[0] - surface(places[k].x(), places[k].z())));
    return worst / l0;
}

Real level(Real, Real) { return 2; }
Real tilted(Real x, Real z) { return 2 + 0.15 * x - 0.1 * z; }
Real cosine(Real x, Real z) { return 2 + 0.3 * std::cos(2 * std::numbers::pi * x / 4) * std::cos(2 * std::numbers::pi * z / 4); }

TEST(FunctionObjects3D, GaugesReadLevelTiltedAndWavySurfaces)
{
    expectBelow("3-D gauge: level, volume [spacings]", gaugeError("", level), 1e-6);
    expectBelow("3-D gauge: level, top [spacings]", gaugeError("method top;", level), 0.1);
    // Means over a square are exact for a plane.
    expectBelow("3-D gauge: tilted plane, volume [spacings]", gaugeError("", tilted), 1e-6);
    expectBelow("3-D gauge: tilted plane, top [spacings]", gaugeError("method top;", tilted), 0.1);
    // (pi W/L)^2/6 in either direction of an amplitude of 3 spacings: 0.025; as much again for the width of the columns of particles.
    expectBelow("3-D gauge: cosine, volume [spacings]", gaugeError("", cosine), 0.05);
    expectBelow("3-D gauge: cosine, top [spacings]", gaugeError("method top;", cosine), 0.1);
}

TEST(FunctionObjects3D, ProfileRunsAlongAnyLine)
{
    FunctionObjectScene scene({3, l0, 1});
    scene.place(scene.columns(40, 30, 10, tilted));
    RunContext const context = scene.context();
    makeFunctionObject("type freeSurfaceProfile; from (0.5 0 2.5); to (3.5 0 0.5); count 21;", context)->write({1, 0.5, 0.1, false});
    Table const table = scene.table("watch/0/profile_0.5.dat");
    auto const x = table.column("x"), z = table.column("z"), eta = table.column("eta");
    ASSERT_EQ(x.size(), 21U);
    EXPECT_NEAR(z[10], 1.5, 1e-9);
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(eta[k], tilted(x[k], z[k]), 1e-6);
    EXPECT_THROW(makeFunctionObject("type freeSurfaceProfile;", context), CaseError) << "no line";
}

/// Tank of 2 x 1 x 1.5 m (x y z), water 1 m deep at rest. Its five sides are surfaces 0 (floor), 1 (x = 0), 2 (x = 2), 3 (z = 0), 4 (z = 1.5);
/// in edges and corners stand particles whose normals point between those of the sides, as rows of walls make them.
void fillTank(FunctionObjectScene& scene)
{
    std::vector<FunctionObjectScene::Point> points;
    std::vector<int> surface;
    for (int k = -1; k <= 15; ++k)
        for (int j = -1; j < 15; ++j)
            for (int i = -1; i <= 20; ++i)
            {
                Vector const n((i < 0) - (i > 19), j < 0, (k < 0) - (k > 14));
                Vector const r((i + 0.5) * l0, (j + 0.5) * l0, (k + 0.5) * l0);
                if (n.norm() == 0 && j < 10) points.push_back({r});
                if (n.norm() == 0) continue;
                points.push_back({r, ParticleType::Wall, n.normalized()});
                surface.push_back(n.y() != 0 ? 0 : n.x() > 0 ? 1 : n.x() < 0 ? 2 : n.z() > 0 ? 3 : 4);
            }
    scene.place(points);
    scene.wallNames = {"floor", "left", "right", "back", "front"};
    scene.wallOf.assign(surface.begin(), surface.end());
    for (int i : scene.particles.owned()) scene.particles.p[i] = std::max(0.0, 1e4 * (1 - scene.particles.r[i].y()));
    for (int i : scene.particles.wall()) scene.particles.wet[i] = scene.particles.r[i].y() < 1;
}

TEST(FunctionObjects3D, ForcesOfStillWaterOnTheSidesOfATank)
{
    FunctionObjectScene scene({3, l0, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    makeFunctionObject("type forces; patches (floor left right back front); CofR (1 0 0.75);", context)->write({1, 0.5, 0.1, false});
    Table const force = scene.table("watch/0/force.dat"), moment = scene.table("watch/0/moment.dat");
    Real const weight = 1e4 * 2 * 1 * 1.5;
    EXPECT_NEAR(force.column("floor_y")[0], -weight, 1e-6 * weight);
    EXPECT_NEAR(force.column("total_y")[0], -weight, 1e-6 * weight);
    EXPECT_NEAR(force.column("left_x")[0], -0.5e4 * 1.5, 1e-6 * weight) << "rho g h^2 / 2 a metre";
    EXPECT_NEAR(force.column("right_x")[0], 0.5e4 * 1.5, 1e-6 * weight);
    EXPECT_NEAR(force.column("back_z")[0], -0.5e4 * 2, 1e-6 * weight);
    EXPECT_NEAR(force.column("front_z")[0], 0.5e4 * 2, 1e-6 * weight);
    EXPECT_NEAR(force.column("total_x")[0], 0, 1e-6 * weight);
    // Arm of the pressure on a side: a third of the depth, less the trapezoidal sum's share l0^2/12 of h^2.
    Real const arm = 1.0 / 3 * (1 - 0.5 * l0 * l0);
    EXPECT_NEAR(moment.column("right_z")[0], -0.5e4 * 1.5 * arm, 1e-3 * weight);
    EXPECT_NEAR(moment.column("total_z")[0], 0, 1e-6 * weight);
}

} // namespace
} // namespace mpsDem
