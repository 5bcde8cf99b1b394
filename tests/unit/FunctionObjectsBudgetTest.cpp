#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"
#include "support/ProgramRun.h"

namespace mpsDem {
namespace {

constexpr Real waterMass = 1000 * 0.1 * 0.1 * 200; ///< Of a block of 20 x 10 particles, 0.1 m apart, 1 m thick [kg].

void fill(FunctionObjectScene& scene)
{
    scene.place(scene.block(20, 10));
    MassProperties mass;
    mass.mass = 5;
    mass.inertia = Tensor::Identity();
    scene.bodies.push_back(std::make_unique<RigidBody>("slide", mass, Vector(0, 3, 0), Quaternion::Identity()));
}

TEST(FunctionObjectsBudget, EnergyThatIsBookedIsNotLost)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fill(scene);
    Real& taken = scene.ledger.energy("energy/collision");
    for (int i : scene.particles.fluid()) scene.particles.u[i] = {2, 0, 0};
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type energyBudget;", context);
    for (int i : scene.particles.fluid()) scene.particles.u[i] = {1, 0, 0};
    taken = 1.5 * waterMass;
    scene.bodies[0]->setVelocity({0, 2, 0}, {0, 0, 3});
    object->write({1, 0.5, 0.1, false});
    Table const table = scene.table("watch/0/energy.dat");
    EXPECT_NEAR(table.column("fluidKinetic")[0], 0.5 * waterMass, 1e-6);
    EXPECT_NEAR(table.column("fluidPotential")[0], waterMass * 10 * 0.5, 1e-6);
    EXPECT_NEAR(table.column("bodyKinetic")[0], 0.5 * 5 * 4 + 0.5 * 9, 1e-9);
    EXPECT_NEAR(table.column("bodyPotential")[0], 5 * 10 * 3, 1e-9);
    EXPECT_NEAR(table.column("collision")[0], 1.5 * waterMass, 1e-6);
    EXPECT_NEAR(table.column("change")[0], 0.5 * 5 * 4 + 0.5 * 9, 1e-6);
}

TEST(FunctionObjectsBudget, MomentumWithoutAnImpulseIsResidual)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fill(scene);
    Vector& gravity = scene.ledger.impulse("impulse/gravityOnFluid");
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type momentumBudget;", context);
    for (int i : scene.particles.fluid()) scene.particles.u[i] = {0, -1, 0};
    gravity = waterMass * Vector(0, -1, 0);
    object->write({1, 0.1, 0.1, false});
    scene.bodies[0]->setVelocity({3, 0, 0}, Vector::Zero());
    object->write({2, 0.2, 0.1, false});
    Table const table = scene.table("watch/0/momentum.dat");
    EXPECT_NEAR(table.column("fluidy")[0], -waterMass, 1e-6);
    EXPECT_NEAR(table.column("gravityOnFluidy")[0], -waterMass, 1e-6);
    EXPECT_NEAR(table.column("share")[0], 0, 1e-12);
    EXPECT_NEAR(table.column("bodiesx")[1], 15, 1e-9);
    EXPECT_NEAR(table.column("residualx")[1], 15, 1e-9);
    EXPECT_NEAR(table.column("share")[1], 15 / (waterMass * 10), 1e-10);
}

TEST(FunctionObjectsBudget, StartSurvivesARestart)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fill(scene);
    RunContext const context = scene.context();
    State state;
    makeFunctionObject("type energyBudget;", context)->save(state);
    for (int i : scene.particles.fluid()) scene.particles.u[i] = {2, 0, 0};
    auto const resumed = makeFunctionObject("type energyBudget;", context);
    resumed->load(state);
    resumed->write({1, 0.5, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/energy.dat").column("change")[0], 2 * waterMass, 1e-5);
}

TEST(FunctionObjectsBudget, MomentumSumsBeginAtTheRestartThatAddsThem)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fill(scene);
    Vector& gravity = scene.ledger.impulse("impulse/gravityOnFluid");
    for (int i : scene.particles.fluid()) scene.particles.u[i] = {0, -1, 0};
    gravity = waterMass * Vector(0, -3, 0); // of the time before; the walls took up two thirds, but nobody summed that
    RunContext const context = scene.context(0.3);
    auto const added = makeFunctionObject("type momentumBudget;", context);
    added->load(State());
    for (int i : scene.particles.fluid()) scene.particles.u[i] = {0, -2, 0};
    gravity += waterMass * Vector(0, -1, 0);
    added->write({4, 0.4, 0.1, false});
    Table const table = scene.table("watch/0.3/momentum.dat");
    EXPECT_NEAR(table.column("gravityOnFluidy")[0], -waterMass, 1e-6);
    EXPECT_NEAR(table.column("share")[0], 0, 1e-12);
    EXPECT_NE(test::contentOf(scene.folder / "postProcessing/watch/0.3/momentum.dat").find("since t = 0.3 s"), std::string::npos);

    // The next restart goes on from there.
    State state;
    added->save(state);
    RunContext const later = scene.context(0.4);
    auto const resumed = makeFunctionObject("type momentumBudget;", later);
    resumed->load(state);
    resumed->write({5, 0.5, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0.4/momentum.dat").column("gravityOnFluidy")[0], -waterMass, 1e-6);
    EXPECT_NE(test::contentOf(scene.folder / "postProcessing/watch/0.4/momentum.dat").find("since t = 0.3 s"), std::string::npos);
}

TEST(FunctionObjectsBudget, ExtremesNameTheirParticle)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fill(scene);
    scene.particles.p[42] = 7;
    scene.particles.u[13] = {3, 4, 0};
    RunContext const context = scene.context();
    makeFunctionObject("type fieldMinMax;", context)->write({1, 0.1, 0.1, false});
    Table const table = scene.table("watch/0/fieldMinMax.dat");
    EXPECT_EQ(table.column("max(p)")[0], 7);
    EXPECT_EQ(table.column("max(p)_id")[0], 42);
    EXPECT_NEAR(table.column("max(p)_x")[0], 0.25, 1e-12);
    EXPECT_EQ(table.column("min(p)_id")[0], 0);
    EXPECT_EQ(table.column("max(U)")[0], 5);
    EXPECT_EQ(table.column("max(U)_id")[0], 13);
}

} // namespace
} // namespace mpsDem
