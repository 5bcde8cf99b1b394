#include <cmath>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

void addBody(FunctionObjectScene& scene)
{
    MassProperties mass;
    mass.mass = 5;
    mass.inertia = Tensor::Identity();
    scene.bodies.push_back(std::make_unique<RigidBody>("slide", mass, Vector(1, 2, 0), Quaternion::Identity()));
    scene.bodies[0]->setGravity(scene.gravity);
    scene.bodies[0]->setVelocity({1, 0, 0}, {0, 0, 2});
}

void fly(RigidBody& body, Real time, Real dt)
{
    body.beginStep();
    body.advance(time, dt);
    body.endStep(dt);
}

TEST(SixDoFRigidBodyState, TellsMotionAndLoadsApart)
{
    FunctionObjectScene scene({2, 0.1, 1});
    addBody(scene);
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type sixDoFRigidBodyState;", context);
    fly(*scene.bodies[0], 0, 0.1);
    object->write({1, 0.1, 0.1, false});
    Table const table = scene.table("watch/0/slide.dat");
    EXPECT_NEAR(table.column("x")[0], 1.1, 1e-12);
    EXPECT_NEAR(table.column("dx")[0], 0.1, 1e-12);
    EXPECT_NEAR(table.column("dy")[0], -0.1, 1e-12); // semi-implicit: -g dt^2
    EXPECT_NEAR(table.column("Uy")[0], -1, 1e-12);
    EXPECT_NEAR(table.column("angle")[0], 0.2, 1e-9);
    EXPECT_NEAR(table.column("q3")[0], std::sin(0.1), 1e-9);
    EXPECT_NEAR(table.column("omegaz")[0], 2, 1e-12);
    EXPECT_NEAR(table.column("Fgravityy")[0], -50, 1e-12);
    EXPECT_EQ(table.column("FcontactNormaly")[0], 0);
    EXPECT_EQ(table.column("Mreactionz")[0], 0);
}

TEST(SixDoFRigidBodyState, DisplacementCountsFromTheVeryStartAfterARestart)
{
    FunctionObjectScene scene({2, 0.1, 1});
    addBody(scene);
    RunContext const context = scene.context();
    State state;
    makeFunctionObject("type sixDoFRigidBodyState;", context)->save(state);
    fly(*scene.bodies[0], 0, 0.1);
    RunContext const later = scene.context(0.1);
    auto const object = makeFunctionObject("type sixDoFRigidBodyState; bodies (slide);", later);
    object->load(state);
    object->write({2, 0.2, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0.1/slide.dat").column("dx")[0], 0.1, 1e-12);
    EXPECT_NEAR(scene.table("watch/0.1/slide.dat").column("angle")[0], 0.2, 1e-9);
}

TEST(SixDoFRigidBodyState, NeedsABody)
{
    FunctionObjectScene scene({2, 0.1, 1});
    RunContext const context = scene.context();
    EXPECT_THROW(makeFunctionObject("type sixDoFRigidBodyState;", context), CaseError);
}

} // namespace
} // namespace mpsDem
