#include <cmath>

#include <gtest/gtest.h>

#include "bodies/RigidBodyReader.h"
#include "core/Errors.h"

namespace mpsDem {
namespace {

/// Unit density wedge with legs 0.5 m, 0.55 m wide.
MassProperties shape()
{
    std::vector<Vector> const points = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
    return MassProperties::fromPolygon(Polyline::outline("wedge", points), 0.55, 1);
}

std::unique_ptr<RigidBody> read(std::string const& entries, bool planar = true, MassProperties const& from = shape())
{
    Dictionary const dict = Dictionary::fromText(entries, "constant/rigidBodyProperties");
    auto body = readRigidBody("slide", dict, from, planar);
    dict.requireAllRead();
    return body;
}

/// Text of the error, or nothing.
std::string refusal(std::string const& entries, bool planar = true, MassProperties const& from = shape())
{
    try
    {
        (void)read(entries, planar, from);
    }
    catch (CaseError const& error)
    {
        return error.what();
    }
    return {};
}

TEST(RigidBodyReader, MassScalesTheShape)
{
    auto const body = read("mass 140;");
    EXPECT_EQ(body->name(), "slide");
    EXPECT_DOUBLE_EQ(body->mass(), 140);
    EXPECT_NEAR(body->inertia()(2, 2), 140 * 0.5 / 18, 1e-12);
    EXPECT_NEAR((body->centre() - Vector(0.5 / 3, 0.5 / 3, 0)).norm(), 0, 1e-15);
    EXPECT_EQ(body->freeDirections(), 3);
    EXPECT_FALSE(body->report());
}

TEST(RigidBodyReader, DensityGivesTheSame)
{
    auto const body = read("density 2000; report yes;");
    EXPECT_NEAR(body->mass(), 2000 * 0.125 * 0.55, 1e-12);
    EXPECT_NEAR(body->inertia()(2, 2), body->mass() * 0.5 / 18, 1e-12);
    EXPECT_TRUE(body->report());
}

TEST(RigidBodyReader, GivenValuesGoBeforeTheShape)
{
    auto const body = read("mass 140; centreOfMass (0.2 0.1 0); momentOfInertia (1 2 3);");
    EXPECT_EQ(body->centre(), Vector(0.2, 0.1, 0));
    EXPECT_DOUBLE_EQ(body->inertia()(2, 2), 3);
}

TEST(RigidBodyReader, OrientationNamesAxesAndDoesNotTurnTheShape)
{
    // Axes turned by 90 degrees about z: x' = y, y' = -x.
    std::string const axes = "orientation (0 -1 0 1 0 0 0 0 1);";
    auto const fromShape = read("mass 140; " + axes);
    EXPECT_NEAR((fromShape->inertia() - read("mass 140;")->inertia()).norm(), 0, 1e-13);
    auto const given = read("mass 140; momentOfInertia (1 2 3); " + axes);
    EXPECT_NEAR((given->inertia().diagonal() - Vector(2, 1, 3)).norm(), 0, 1e-14);
}

TEST(RigidBodyReader, VelocitiesMomentumAndRelease)
{
    auto const body = read("mass 140; velocity (1 2 0); angularVelocity (0 0 3);");
    EXPECT_EQ(body->velocity(), Vector(1, 2, 0));
    EXPECT_EQ(body->angularVelocity(), Vector(0, 0, 3));

    std::string const turned = "mass 2; momentOfInertia (1 2 4); orientation (0 -1 0 1 0 0 0 0 1); angularMomentum (3 4 8);";
    EXPECT_NEAR((read(turned, false)->angularVelocity() - Vector(-2, 3, 2)).norm(), 0, 1e-14);

    auto const waiting = read("mass 140; velocity (1 2 0); releaseTime 0.3;");
    EXPECT_TRUE(waiting->still(0.2));
    EXPECT_EQ(waiting->velocity(), Vector(0, 0, 0));
}

TEST(RigidBodyReader, ConstraintsRestraintsAndMotion)
{
    auto const body = read("mass 140; constraints { slope { sixDoFRigidBodyMotionConstraint line; direction (1 -1 0); } "
                           "noTurn { sixDoFRigidBodyMotionConstraint orientation; } } "
                           "restraints { rope { sixDoFRigidBodyMotionRestraint linearDamper; coeff 5; } } velocity (2 -2 0);");
    EXPECT_EQ(body->freeDirections(), 1);
    body->beginStep();
    body->advance(0, 1e-3);
    body->endStep(1e-3);
    EXPECT_NEAR((body->meanRestraint().force - Vector(-10, 10, 0)).norm(), 0, 1e-12);

    auto const driven = read("mass 140; prescribedMotion { solidBodyMotionFunction linearMotion; velocity (1 0 0); }");
    EXPECT_EQ(driven->velocity(), Vector(1, 0, 0));
}

TEST(RigidBodyReader, ContradictionsAreRefusedWithWhatIsAllowed)
{
    EXPECT_NE(refusal("").find("either mass or density"), std::string::npos);
    EXPECT_NE(refusal("mass 1; density 2;").find("either mass or density"), std::string::npos);
    EXPECT_NE(refusal("mass -1;"), "");
    EXPECT_NE(refusal("mass 140; centreOfMass (0 0 0);").find("momentOfInertia"), std::string::npos);
    EXPECT_NE(refusal("mass 140; momentOfInertia (1 0 1);"), "");
    EXPECT_NE(refusal("mass 140; orientation (1 0 0 0 1 0 0 0 2);").find("rotation"), std::string::npos);
    EXPECT_NE(refusal("mass 140; orientation (1 0 0 0 0 -1 0 1 0);").find("about z"), std::string::npos);
    EXPECT_NE(refusal("mass 140; velocity (0 0 1);").find("constraints"), std::string::npos);
    EXPECT_NE(refusal("mass 140; angularVelocity (0 0 1); angularMomentum (0 0 1);"), "");
    EXPECT_NE(refusal("mass 140; prescribedMotion { solidBodyMotionFunction linearMotion; velocity (1 0 0); } constraints {}"), "");
    EXPECT_NE(refusal("mass 140; constraints { a { sixDoFRigidBodyMotionConstraint lin; } }"), "");
    EXPECT_NE(refusal("mass 140; masss 3;"), "");
    EXPECT_NE(refusal("density 140;", true, MassProperties()).find("shape"), std::string::npos);
    EXPECT_NE(refusal("mass 140;", true, MassProperties()).find("centreOfMass"), std::string::npos);
    EXPECT_NE(refusal("mass 140; centreOfMass (0 0 0);", true, MassProperties()).find("momentOfInertia"), std::string::npos);
    EXPECT_EQ(refusal("mass 140; centreOfMass (0 0 0); momentOfInertia (1 1 1);", true, MassProperties()), "");
}

} // namespace
} // namespace mpsDem
