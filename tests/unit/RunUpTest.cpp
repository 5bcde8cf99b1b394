#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"
#include "support/Measured.h"

namespace mpsDem {
namespace {

using test::expectBelow;

constexpr Real l0 = 0.1, pi = std::numbers::pi;

/// Slope through the z axis that rises along +x, and on it a film of three rows whose upper edge is at `edge(z)` along the slope.
struct Slope
{
    Real angle;
    Vector tangent{std::cos(angle), std::sin(angle), 0}, normal{-std::sin(angle), std::cos(angle), 0};

    explicit Slope(Real degrees) : angle(degrees * pi / 180) {}

    template <class Edge>
    void place(FunctionObjectScene& scene, int wide, Edge edge) const
    {
        bool const planar = scene.particles.lattice().dimensions == 2;
        std::vector<FunctionObjectScene::Point> points;
        for (int k = 0; k < (planar ? 1 : wide); ++k)
        {
            Real const z = planar ? 0 : (k + 0.5) * l0;
            for (int i = 0; i < 60; ++i)
                points.push_back({(i - 30 + 0.5) * l0 * tangent - 0.5 * l0 * normal + Vector(0, 0, z), ParticleType::Wall, normal});
            for (int row = 0; row < 3; ++row)
                for (int i = 0; i < 20; ++i)
                    points.push_back({(edge(z) - (i + 0.5) * l0) * tangent + (row + 0.5) * l0 * normal + Vector(0, 0, z)});
        }
        scene.place(points);
    }
};

TEST(RunUp, IsExactForALevelEdgeOnSlopes)
{
    for (Real const degrees : {5.0, 15.0, 45.0, 90.0})
        for (int const dimensions : {2, 3})
        {
            FunctionObjectScene scene({dimensions, l0, 1});
            Slope const slope(degrees);
            slope.place(scene, 10, [](Real) { return 1.23; });
            RunContext const context = scene.context();
            makeFunctionObject("type runUp; patches (tank); zero 0.1;", context)->write({1, 1, 0.1, false});
            Table const table = scene.table("watch/0/runUp.dat");
            Real const height = 1.23 * std::sin(slope.angle) - 0.1;
            EXPECT_NEAR(table.column("height")[0], height, 1e-9);
            EXPECT_NEAR(table.column("distance")[0], height / std::sin(slope.angle), 1e-9);
            EXPECT_EQ(scene.table("watch/0/places_1.dat").column("height").size(), dimensions == 2 ? 1U : 5U);
        }
}

TEST(RunUp, LeavesOutWallsSteeperThanAsked)
{
    FunctionObjectScene scene({3, l0, 1});
    Slope const slope(45);
    slope.place(scene, 10, [](Real) { return 1.0; });
    RunContext const context = scene.context();
    makeFunctionObject("type runUp; patches (tank); steepest 46;", context)->write({1, 1, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/runUp.dat").column("height")[0], std::sqrt(0.5), 1e-9);
    EXPECT_THROW(makeFunctionObject("type runUp; patches (tank); steepest 44;", context), CaseError);
}

TEST(RunUp, FollowsACurvedEdgeOverZAndKeepsTheHighest)
{
    FunctionObjectScene scene({3, l0, 1});
    Slope const slope(30);
    auto const edge = [](Real z, Real a) { return 1 + a * std::cos(2 * pi * z / 4); };
    slope.place(scene, 40, [&](Real z) { return edge(z, 0.5); });
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type runUp; patches (tank); spacing 0.1;", context);
    object->execute({1, 0.5, 0.1, false});
    slope.place(scene, 40, [&](Real z) { return edge(z, -0.2); });
    object->write({2, 1, 0.1, false});
    Table const table = scene.table("watch/0/places_1.dat"), total = scene.table("watch/0/runUp.dat");
    auto const place = table.column("place"), now = table.column("distance"), most = table.column("distanceMax");
    ASSERT_EQ(place.size(), 40U);
    Real offNow = 0, offMost = 0;
    for (std::size_t k = 0; k < place.size(); ++k)
    {
        EXPECT_NEAR(place[k], (static_cast<Real>(k) + 0.5) * l0, 1e-9);
        offNow = std::max(offNow, std::abs(now[k] - edge(place[k], -0.2)));
        offMost = std::max(offMost, std::abs(most[k] - std::max(edge(place[k], 0.5), edge(place[k], -0.2))));
    }
    expectBelow("run-up over z, now [spacings]", offNow / l0, 1e-6);
    expectBelow("run-up over z, largest [spacings]", offMost / l0, 1e-6);
    EXPECT_NEAR(total.column("distanceMax")[0], edge(0.05, 0.5), 1e-9);
    EXPECT_NEAR(total.column("placeMax")[0], 0.05, 1e-9);
    EXPECT_EQ(total.column("timeOfMax")[0], 0.5);
    EXPECT_NEAR(total.column("place")[0], 1.95, 0.11);
    State state;
    object->save(state);
    auto const later = makeFunctionObject("type runUp; patches (tank); spacing 0.1;", context);
    later->load(state);
    later->write({3, 2, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/places_2.dat").column("distanceMax")[0], edge(0.05, 0.5), 1e-9) << "after a restart";
    EXPECT_EQ(scene.table("watch/0/places_2.dat").column("timeOfMax")[0], 0.5);
}

TEST(RunUp, DoesNotCountDropsFloorsAndWaterAwayFromTheWall)
{
    FunctionObjectScene scene({3, l0, 1});
    Slope const slope(30);
    slope.place(scene, 4, [](Real) { return 1.0; });
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type runUp; patches (tank);", context);
    std::vector<FunctionObjectScene::Point> points;
    for (int i : scene.particles.owned())
        points.push_back({scene.particles.r[i], scene.particles.fluid().contains(i) ? ParticleType::Fluid : ParticleType::Wall,
                          scene.particles.normal[i]});
    for (int i = 0; i < 6; ++i) points.push_back({(2 + i * l0) * slope.tangent + 0.5 * l0 * slope.normal + Vector(0, 0, 0.1)});
    for (int i = 0; i < 30; ++i) points.push_back({(1 + i * l0) * slope.tangent + 4.5 * l0 * slope.normal + Vector(0, 0, 0.1)});
    scene.place(points);
    object->write({1, 1, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/runUp.dat").column("distance")[0], 1, 1e-9);
    EXPECT_THROW(makeFunctionObject("type runUp; patches (tonk);", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type runUp; patches ();", context), CaseError);
    FunctionObjectScene level({3, l0, 1});
    Slope(0).place(level, 4, [](Real) { return 1.0; });
    RunContext const flat = level.context();
    EXPECT_THROW(makeFunctionObject("type runUp; patches (tank);", flat), CaseError) << "nothing to climb";
}

} // namespace
} // namespace mpsDem
