#include <gtest/gtest.h>

#include "boundaries/BoundaryRows.h"
#include "core/Polyline.h"
#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

/// Open tank 2 m wide, water 1 m deep with its exact pressure.
void fillTank(FunctionObjectScene& scene)
{
    Polyline const tank("tank", {{0, 1.5, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1.5, 0}}, false, Polyline::FluidSide::Left);
    int const rows = 3;
    BoundaryRows const walls = boundaryRows(std::span(&tank, 1), std::span(&rows, 1), 0.1);
    auto points = scene.block(20, 10);
    for (std::size_t i = 0; i < walls.position.size(); ++i) points.push_back({walls.position[i], walls.type[i], walls.normal[i]});
    scene.place(points);
    for (int i : scene.particles.owned()) scene.particles.p[i] = std::max(0.0, 1e4 * (1 - scene.particles.r[i].y()));
    for (int i : scene.particles.wall()) scene.particles.wet[i] = scene.particles.r[i].y() < 1;
}

TEST(Forces, StillWaterPressesOnATankWithItsWeight)
{
    FunctionObjectScene scene({2, 0.1, 0.5});
    fillTank(scene);
    RunContext const context = scene.context();
    makeFunctionObject("type forces; patches (tank); CofR (1 0 0);", context)->write({1, 0.5, 0.1, false});
    Table const force = scene.table("watch/0/force.dat"), moment = scene.table("watch/0/moment.dat");
    Real const weight = 1000 * 10 * 2 * 1 * 0.5;
    EXPECT_NEAR(force.column("tank_y")[0], -weight, 1e-6 * weight);
    EXPECT_NEAR(force.column("total_y")[0], -weight, 1e-6 * weight);
    EXPECT_NEAR(force.column("tank_x")[0], 0, 1e-6 * weight);
    EXPECT_NEAR(moment.column("tank_z")[0], 0, 1e-6 * weight);
}

TEST(Forces, OfABodyAreThoseItFelt)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    MassProperties mass;
    mass.mass = 5;
    mass.inertia = Tensor::Identity();
    scene.bodies.push_back(std::make_unique<RigidBody>("slide", mass, Vector(1, 2, 0), Quaternion::Identity()));
    scene.bodies[0]->fluid = {Vector(3, 4, 0), Vector(0, 0, 7)};
    RunContext const context = scene.context();
    makeFunctionObject("type forces; bodies (slide);", context)->write({1, 0.5, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/force.dat").column("slide_y")[0], 4, 1e-9);
    EXPECT_NEAR(scene.table("watch/0/moment.dat").column("slide_z")[0], 7 + 1 * 4 - 2 * 3, 1e-9);
    EXPECT_THROW(makeFunctionObject("type forces; patches (slide);", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type forces; bodies (slid);", context), CaseError);
}

} // namespace
} // namespace mpsDem
