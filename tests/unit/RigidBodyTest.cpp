#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "bodies/RigidBody.h"
#include "core/Errors.h"

namespace mpsDem {
namespace {

MassProperties brick()
{
    MassProperties mass;
    mass.mass = 2;
    mass.inertia = Vector(0.3, 0.5, 0.7).asDiagonal();
    mass.volume = 1e-3;
    return mass;
}

RigidBody brickAt(Vector const& centre) { return RigidBody("brick", brick(), centre, Quaternion::Identity()); }

/// One fluid step of `count` sub-steps.
void step(RigidBody& body, Real time, Real dt, int count = 1)
{
    body.beginStep();
    for (int i = 0; i < count; ++i) body.advance(time + i * dt / count, dt / count);
    body.endStep(dt);
}

TEST(RigidBody, PureTranslationIsExact)
{
    RigidBody body = brickAt(Vector(1, 2, 0));
    body.setVelocity(Vector(1, 0, 0), Vector::Zero());
    for (int i = 0; i < 100; ++i) step(body, 1e-3 * i, 1e-3, 10);
    EXPECT_NEAR((body.centre() - Vector(1.1, 2, 0)).norm(), 0, 1e-12); // 0.1 m in 0.1 s
    EXPECT_EQ(body.velocity(), Vector(1, 0, 0));
    EXPECT_EQ(body.orientation().coeffs(), Quaternion::Identity().coeffs());
    EXPECT_EQ(body.acceleration(), Vector(0, 0, 0));
}

TEST(RigidBody, FreeFallHasTheErrorOfSemiImplicitEuler)
{
    Vector const g(0, -9.81, 0);
    Real const h = 1e-3, t = 0.5;
    RigidBody body = brickAt(Vector::Zero());
    body.setGravity(g);
    for (int i = 0; i < 500; ++i) step(body, i * h, h);
    EXPECT_NEAR(body.velocity().y(), g.y() * t, 1e-12);
    EXPECT_NEAR(body.centre().y(), g.y() * t * t / 2 + h * g.y() * t / 2, 1e-12); // y_n = g h^2 n (n + 1) / 2
    EXPECT_NEAR((body.acceleration() - g).norm(), 0, 1e-12);
    EXPECT_NEAR(body.meanReaction().force.norm(), 0, 1e-12);
}

TEST(RigidBody, MomentAboutAPrincipalAxisTurnsIt)
{
    RigidBody body = brickAt(Vector::Zero());
    body.fluid.moment = Vector(0, 0, 1.4); // 2 rad/s2
    Real const h = 1e-3;
    for (int i = 0; i < 1000; ++i) step(body, i * h, h);
    EXPECT_NEAR((body.angularVelocity() - Vector(0, 0, 2)).norm(), 0, 1e-12);
    Eigen::AngleAxisd const turned(body.orientation());
    EXPECT_NEAR(turned.angle() * turned.axis().z(), 1 + h, 1e-12);
    EXPECT_NEAR((body.angularAcceleration() - Vector(0, 0, 2)).norm(), 0, 1e-11);
}

TEST(RigidBody, LoadsAddUpAndForcesAtAnArmTurn)
{
    Load load;
    load.add(Vector(0, 3, 0), Vector(2, 0, 0));
    EXPECT_EQ(load.moment, Vector(0, 0, 6));

    RigidBody body = brickAt(Vector::Zero());
    body.fluid.force = Vector(1, 0, 0);
    body.contactNormal.force = Vector(0, 2, 0);
    body.contactTangential.force = Vector(0, 0, 4);
    step(body, 0, 0.1, 4);
    EXPECT_NEAR((body.velocity() - 0.1 * Vector(0.5, 1, 2)).norm(), 0, 1e-15);
    EXPECT_NEAR((body.meanContactNormal().force - Vector(0, 2, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((body.meanContactTangential().force - Vector(0, 0, 4)).norm(), 0, 1e-15);
}

TEST(RigidBody, MaterialPointsMoveWithTheBody)
{
    RigidBody body = brickAt(Vector(1, 0, 0));
    body.setVelocity(Vector(0, 1, 0), Vector(0, 0, 2));
    EXPECT_NEAR((body.velocityAt(Vector(1.5, 0, 0)) - Vector(0, 2, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((body.accelerationAt(Vector(1.5, 0, 0)) - Vector(-2, 0, 0)).norm(), 0, 1e-15); // -omega^2 r
    EXPECT_NEAR((body.toSpace(Vector(0.5, 0, 0)) - Vector(1.5, 0, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR(body.kineticEnergy(), 0.5 * 2 * 1 + 0.5 * 0.7 * 4, 1e-15);
}

TEST(RigidBody, AddedMassEntersEqs13And14)
{
    // (M + Ma) a = F + Ma a*, full 6 x 6 with coupling of force and moment.
    Matrix6 seed;
    for (int i = 0; i < 36; ++i) seed(i) = std::sin(1.0 + i);
    Matrix6 const addedMass = seed * seed.transpose();
    Vector6 assumed, force;
    assumed << 1, -2, 3, 0.5, 0.2, -0.7;
    force << 4, 5, -6, 0.7, -0.8, 0.9;

    RigidBody body = brickAt(Vector::Zero());
    body.fluid = {force.head<3>(), force.tail<3>()};
    body.setAddedMass(addedMass, assumed);
    Real const h = 1e-6;
    step(body, 0, h);
    Vector6 const a = (body.massMatrix() + addedMass).inverse() * (force + addedMass * assumed);
    EXPECT_NEAR((body.acceleration() - a.head<3>()).norm(), 0, 1e-9);
    EXPECT_NEAR((body.angularAcceleration() - a.tail<3>()).norm(), 0, 1e-5); // gyroscopic term of the new omega: O(h)
}

TEST(RigidBody, AddedMassAtTheAssumedAccelerationChangesNothing)
{
    // With a* the acceleration that the body takes anyhow, the answer is that of weak coupling, gyroscopic part included.
    RigidBody weak = brickAt(Vector::Zero()), strong = brickAt(Vector::Zero());
    for (RigidBody* body : {&weak, &strong})
    {
        body->setVelocity(Vector::Zero(), Vector(1, 2, 3));
        body->fluid = {Vector(1, 2, 3), Vector(0.1, 0.2, -0.3)};
    }
    Real const h = 1e-5;
    step(weak, 0, h);
    Vector6 assumed;
    assumed << weak.acceleration(), weak.angularAcceleration();
    strong.setAddedMass(5 * Matrix6::Identity(), assumed);
    step(strong, 0, h);
    EXPECT_NEAR((strong.acceleration() - weak.acceleration()).norm(), 0, 1e-9);
    EXPECT_NEAR((strong.angularAcceleration() - weak.angularAcceleration()).norm(), 0, 1e-3); // O(h), of 7 rad/s2
}

TEST(RigidBody, IndefiniteAddedMassIsRefused)
{
    RigidBody body = brickAt(Vector::Zero());
    EXPECT_THROW(body.setAddedMass(-3 * Matrix6::Identity(), Vector6::Zero()), CaseError);
}

TEST(RigidBody, RestsUntilItsReleaseAndTakesUpItsVelocityThen)
{
    RigidBody body = brickAt(Vector::Zero());
    body.setGravity(Vector(0, -10, 0));
    body.setVelocity(Vector(3, 0, 0), Vector::Zero());
    body.setReleaseTime(0.2);
    EXPECT_TRUE(body.still(0.1));
    EXPECT_FALSE(body.still(0.2));
    for (int i = 0; i < 200; ++i) step(body, i * 1e-3, 1e-3);
    EXPECT_EQ(body.centre(), Vector(0, 0, 0));
    EXPECT_EQ(body.velocity(), Vector(0, 0, 0));
    EXPECT_NEAR(body.meanReaction().force.y(), 20, 1e-12); // carries its weight
    step(body, 0.2, 1e-3);
    EXPECT_NEAR((body.velocity() - Vector(3, -0.01, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR(body.acceleration().y(), -10, 1e-10);
}

TEST(RigidBody, LockHoldsForGoodAndTellsTheMomentumLost)
{
    RigidBody body = brickAt(Vector::Zero());
    body.setVelocity(Vector(1, -2, 0), Vector(0, 0, 3));
    body.beginStep();
    body.advance(0, 0.01);
    EXPECT_EQ(body.lock(), Vector(2, -4, 0));
    body.endStep(0.01);
    EXPECT_TRUE(body.locked());
    EXPECT_TRUE(body.still(1e9));
    EXPECT_EQ(body.freeDirections(), 0);
    EXPECT_NEAR((body.meanReaction().force - Vector(-200, 400, 0)).norm(), 0, 1e-9); // its impulse over dt
    EXPECT_NEAR(body.meanReaction().moment.z(), -210, 1e-9);
    EXPECT_EQ(body.acceleration(), Vector(0, 0, 0));

    Vector const there = body.centre();
    body.fluid.force = Vector(100, 0, 0);
    step(body, 0.01, 0.1);
    EXPECT_EQ(body.centre(), there);
    EXPECT_EQ(body.meanReaction().force, Vector(-100, 0, 0));
}

TEST(RigidBody, HeldBodyCarriesTheLoadOfTheFluidAtRest)
{
    // The load was found for a*; without acceleration it is F + Ma a*.
    RigidBody body = brickAt(Vector::Zero());
    body.setReleaseTime(1);
    body.fluid.force = Vector(5, 0, 0);
    Vector6 assumed = Vector6::Zero();
    assumed(0) = 2;
    body.setAddedMass(3 * Matrix6::Identity(), assumed);
    step(body, 0, 0.1);
    EXPECT_NEAR(body.meanReaction().force.x(), -11, 1e-14);
}

TEST(RigidBody, TwoDimensionalBodyStaysInThePlaneBitwise)
{
    MassProperties mass = brick();
    mass.inertia(0, 2) = mass.inertia(2, 0) = 0.1; // couples z to x: must not reach the plane
    RigidBody body("slide", mass, Vector(1, 2, 0), Quaternion(Eigen::AngleAxisd(0.3, Vector::UnitZ())));
    body.restrictTo2D();
    EXPECT_EQ(body.freeDirections(), 3);
    EXPECT_DOUBLE_EQ(body.freeProjection().trace(), 3);
    body.setVelocity(Vector(1, 2, 7), Vector(7, 8, 0.5));
    EXPECT_EQ(body.velocity(), Vector(1, 2, 0));
    EXPECT_EQ(body.angularVelocity(), Vector(0, 0, 0.5));
    Matrix6 addedMass = 0.1 * Matrix6::Identity();
    addedMass(0, 2) = addedMass(2, 0) = addedMass(5, 3) = addedMass(3, 5) = 0.05;
    for (int i = 0; i < 200; ++i)
    {
        body.fluid = {Vector(std::sin(i), std::cos(i), 5), Vector(6, 7, std::cos(3 * i))};
        body.setAddedMass(addedMass, Vector6::Ones());
        step(body, i * 1e-2, 1e-2, 5);
    }
    EXPECT_EQ(body.centre().z(), 0);
    EXPECT_EQ(body.velocity().z(), 0);
    EXPECT_EQ(body.angularVelocity().head<2>(), Eigen::Vector2d(0, 0));
    EXPECT_EQ(body.orientation().x(), 0);
    EXPECT_EQ(body.orientation().y(), 0);
    EXPECT_EQ(body.rotation().col(2), Vector(0, 0, 1));
    EXPECT_NEAR(body.orientation().norm(), 1, 1e-15);
}

TEST(RigidBody, OrientationOutOfThePlaneIsRefusedIn2D)
{
    RigidBody body("slide", brick(), Vector::Zero(), Quaternion(Eigen::AngleAxisd(0.3, Vector::UnitX())));
    EXPECT_THROW(body.restrictTo2D(), CaseError);
}

TEST(RigidBody, MassAndInertiaMustBePositive)
{
    MassProperties mass = brick();
    mass.mass = 0;
    EXPECT_THROW(RigidBody("none", mass, Vector::Zero(), Quaternion::Identity()), CaseError);
    mass = brick();
    mass.inertia(1, 1) = -1;
    EXPECT_THROW(RigidBody("none", mass, Vector::Zero(), Quaternion::Identity()), CaseError);
    mass.inertia(1, 1) = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_THROW(RigidBody("none", mass, Vector::Zero(), Quaternion::Identity()), CaseError);
}

TEST(RigidBody, SavedAndLoadedBodyGoesOnBitwise)
{
    auto const push = [](RigidBody& body, int i) {
        body.fluid = {Vector(std::sin(i), std::cos(i), 1), Vector(0.1, std::cos(3 * i), 0.2)};
        body.setAddedMass((0.3 + 0.1 * std::sin(i)) * Matrix6::Identity(), std::sin(i) * Vector6::Ones());
        step(body, i * 1e-2, 1e-2, 7);
    };
    auto const fresh = [] {
        RigidBody body = brickAt(Vector(1, 2, 3));
        body.setGravity(Vector(0, -9.81, 0));
        body.setVelocity(Vector(1, 0, 0), Vector(3, 0.1, 0.2));
        body.setReleaseTime(0.1);
        return body;
    };
    for (int stop : {5, 40}) // before and after the release at step 10
    {
        RigidBody whole = fresh();
        for (int i = 0; i < stop; ++i) push(whole, i);
        State saved;
        whole.save(saved);
        RigidBody second = fresh();
        second.load(saved);
        for (int i = stop; i < 60; ++i)
        {
            push(whole, i);
            push(second, i);
        }
        State a, b;
        whole.save(a);
        second.save(b);
        EXPECT_EQ(a.blocks(), b.blocks());
        EXPECT_GT(whole.velocity().norm(), 0.1);
    }
}

TEST(RigidBody, LockSurvivesARestart)
{
    RigidBody body = brickAt(Vector::Zero());
    body.setVelocity(Vector(1, 0, 0), Vector::Zero());
    body.lock();
    State state;
    body.save(state);
    RigidBody second = brickAt(Vector::Zero());
    second.load(state);
    EXPECT_TRUE(second.locked());
    EXPECT_EQ(second.velocity(), Vector(0, 0, 0));
    State empty;
    EXPECT_THROW(second.load(empty), CaseError);
}

} // namespace
} // namespace mpsDem
