#include <cmath>

#include <gtest/gtest.h>

#include "bodies/RigidBody.h"
#include "core/Errors.h"

namespace mpsDem {
namespace {

RigidBody brick()
{
    MassProperties mass;
    mass.mass = 2;
    mass.inertia << 0.3, 0.02, 0.01, 0.02, 0.5, 0.03, 0.01, 0.03, 0.7;
    return RigidBody("brick", mass, Vector(1, 2, 3), Quaternion::Identity());
}

std::unique_ptr<Constraint> constraint(std::string const& entries)
{
    return makeConstraint("test", Dictionary::fromText("sixDoFRigidBodyMotionConstraint " + entries));
}

/// Pushes and turns the body in all directions for 10 s.
void shake(RigidBody& body)
{
    for (int i = 0; i < 1000; ++i)
    {
        body.fluid = {Vector(std::sin(i), 1 + std::cos(2 * i), std::sin(3 * i)), Vector(std::cos(i), 0.3, std::sin(5 * i))};
        body.beginStep();
        for (int k = 0; k < 5; ++k) body.advance(0.01 * i, 0.002);
        body.endStep(0.01);
    }
}

TEST(RigidBodyConstraint, LineKeepsTheBodyOnIt)
{
    RigidBody body = brick();
    body.addConstraint(constraint("line; direction (1 -1 0);"));
    EXPECT_EQ(body.freeDirections(), 4);
    shake(body);
    Vector const moved = body.centre() - Vector(1, 2, 3);
    EXPECT_GT(moved.norm(), 1);
    EXPECT_NEAR((moved + Vector(-moved.x(), moved.x(), 0)).norm() / moved.norm(), 0, 1e-14);
    EXPECT_NEAR(body.meanReaction().force.dot(Vector(1, -1, 0)), 0, 1e-14);
}

TEST(RigidBodyConstraint, LineTakesItsPartOfTheWeight)
{
    // A body on a frictionless 30 degree guide: a = g sin(30), reaction m g cos(30).
    RigidBody body = brick();
    body.addConstraint(constraint("line; direction (1.7320508075688772 -1 0);"));
    body.addConstraint(constraint("orientation;"));
    body.setGravity(Vector(0, -9.81, 0));
    body.beginStep();
    body.advance(0, 0.01);
    body.endStep(0.01);
    EXPECT_NEAR(body.acceleration().norm(), 9.81 / 2, 1e-12);
    EXPECT_NEAR(body.meanReaction().force.norm(), 2 * 9.81 * std::sqrt(0.75), 1e-12);
}

TEST(RigidBodyConstraint, PlaneKeepsTheBodyInIt)
{
    RigidBody body = brick();
    body.addConstraint(constraint("plane; normal (0 0 2);"));
    EXPECT_EQ(body.freeDirections(), 5);
    shake(body);
    EXPECT_EQ(body.centre().z(), 3);
    EXPECT_GT(body.centre().y(), 3);
}

TEST(RigidBodyConstraint, PointHoldsTheCentreAndLeavesTheRotation)
{
    RigidBody body = brick();
    body.addConstraint(constraint("point; centreOfRotation (1 2 3);"));
    shake(body);
    EXPECT_EQ(body.centre(), Vector(1, 2, 3));
    EXPECT_GT(body.angularVelocity().norm(), 1e-2);
}

TEST(RigidBodyConstraint, PointElsewhereIsRefusedWithTheReason)
{
    RigidBody body = brick();
    try
    {
        body.addConstraint(constraint("point; centreOfRotation (0 0 0);"));
        FAIL() << "must throw";
    }
    catch (CaseError const& error)
    {
        EXPECT_NE(std::string(error.what()).find("centre of mass"), std::string::npos);
        EXPECT_EQ(error.code(), ExitCode::BadInput);
    }
}

TEST(RigidBodyConstraint, AxisLeavesOneRotation)
{
    Vector const axis = Vector(1, 2, -1).normalized();
    RigidBody body = brick();
    body.addConstraint(constraint("axis; axis (1 2 -1);"));
    EXPECT_EQ(body.freeDirections(), 4);
    shake(body);
    EXPECT_NEAR((body.rotation() * axis - axis).norm(), 0, 1e-12); // 5000 turns by a quaternion, 2e-16 each
    EXPECT_NEAR(body.angularVelocity().cross(axis).norm(), 0, 1e-14 * body.angularVelocity().norm());
    EXPECT_GT(body.angularVelocity().norm(), 0.1);
}

TEST(RigidBodyConstraint, BodyTurningAboutAnInclinedAxisPushesOnItsBearings)
{
    // Dynamic imbalance: the bearings give omega x (I omega), and the speed does not change.
    RigidBody body = brick();
    body.addConstraint(constraint("axis; axis (1 2 -1);"));
    body.addConstraint(constraint("point;"));
    Vector const omega = 3 * Vector(1, 2, -1).normalized();
    body.setVelocity(Vector::Zero(), omega);
    Vector const expected = omega.cross(body.inertia() * omega);
    body.beginStep();
    body.advance(0, 1e-4);
    body.endStep(1e-4);
    EXPECT_NEAR((body.meanReaction().moment - expected).norm(), 0, 1e-12);
    EXPECT_NEAR((body.angularVelocity() - omega).norm(), 0, 1e-14);
}

TEST(RigidBodyConstraint, OrientationStaysBitwise)
{
    RigidBody body = brick();
    body.addConstraint(constraint("orientation;"));
    shake(body);
    EXPECT_EQ(body.orientation().coeffs(), Quaternion::Identity().coeffs());
    EXPECT_EQ(body.angularVelocity(), Vector(0, 0, 0));
}

TEST(RigidBodyConstraint, SeveralConstraintsLeaveTheirCommonDirections)
{
    RigidBody body = brick();
    body.addConstraint(constraint("plane; normal (1 1 0);"));
    body.addConstraint(constraint("plane; normal (0 1 1);"));
    body.addConstraint(constraint("axis; axis (1 0 0);"));
    body.addConstraint(constraint("axis; axis (0 1 0);")); // two axes leave no rotation
    EXPECT_EQ(body.freeDirections(), 1);
    Vector const free = Vector(1, -1, 1).normalized();
    Tensor const expected = free * free.transpose();
    EXPECT_NEAR((body.freeProjection().topLeftCorner<3, 3>() - expected).norm(), 0, 1e-15);
    shake(body);
    Vector const moved = body.centre() - Vector(1, 2, 3);
    EXPECT_NEAR(moved.cross(free).norm() / moved.norm(), 0, 1e-14);
}

TEST(RigidBodyConstraint, BodyWithoutFreeDirectionIsStill)
{
    RigidBody body = brick();
    EXPECT_FALSE(body.still(0));
    body.addConstraint(constraint("point;"));
    body.addConstraint(constraint("orientation;"));
    EXPECT_TRUE(body.still(0));
    EXPECT_EQ(body.freeDirections(), 0);
}

TEST(RigidBodyConstraint, AddedMassRespectsConstraints)
{
    RigidBody body = brick();
    body.addConstraint(constraint("line; direction (1 1 0);"));
    body.addConstraint(constraint("orientation;"));
    Matrix6 addedMass = Matrix6::Zero();
    addedMass.topLeftCorner<3, 3>() << 4, 1, 0, 1, 2, 0, 0, 0, 3;
    body.setAddedMass(addedMass, Vector6::Zero());
    body.fluid.force = Vector(1, 0, 0);
    body.beginStep();
    body.advance(0, 0.01);
    body.endStep(0.01);
    // Along e = (1 1 0)/sqrt 2: (m + e.Ma e) a = e.F with e.Ma e = 4.
    EXPECT_NEAR(body.acceleration().x(), std::sqrt(0.5) * std::sqrt(0.5) / 6, 1e-15);
}

TEST(RigidBodyConstraint, UnknownWordIsRefusedWithTheNearest)
{
    try
    {
        (void)constraint("lime; direction (1 0 0);");
        FAIL() << "must throw";
    }
    catch (CaseError const& error)
    {
        EXPECT_NE(std::string(error.what()).find("did you mean line?"), std::string::npos) << error.what();
    }
    EXPECT_THROW((void)constraint("line; direction (0 0 0);"), CaseError);
    EXPECT_THROW((void)constraint("axis;"), CaseError);
}

} // namespace
} // namespace mpsDem
