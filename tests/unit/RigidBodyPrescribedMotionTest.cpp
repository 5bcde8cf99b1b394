#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bodies/RigidBody.h"
#include "bodies/TabulatedMotion.h"
#include "core/Errors.h"

namespace mpsDem {
namespace {

Real constexpr pi = std::numbers::pi;

std::unique_ptr<PrescribedMotion> motion(std::string const& entries)
{
    return makePrescribedMotion(Dictionary::fromText("solidBodyMotionFunction " + entries));
}

RigidBody brick()
{
    MassProperties mass;
    mass.mass = 2;
    mass.inertia = Vector(0.3, 0.5, 0.7).asDiagonal();
    return RigidBody("brick", mass, Vector(1, 2, 0), Quaternion::Identity());
}

void steps(RigidBody& body, Real dt, int count, Real start = 0)
{
    for (int i = 0; i < count; ++i)
    {
        body.beginStep();
        body.advance(start + i * dt, dt / 2);
        body.advance(start + i * dt + dt / 2, dt / 2);
        body.endStep(dt);
    }
}

TEST(RigidBodyPrescribedMotion, LinearMotionDoesNotFeelLoads)
{
    RigidBody body = brick();
    body.setPrescribedMotion(motion("linearMotion; velocity (1 -0.5 0);"));
    EXPECT_EQ(body.velocity(), Vector(1, -0.5, 0));
    EXPECT_EQ(body.freeDirections(), 0);
    EXPECT_FALSE(body.still(0));
    body.setGravity(Vector(0, -10, 0));
    body.fluid.force = Vector(3, 0, 0);
    steps(body, 1e-3, 100);
    EXPECT_NEAR((body.centre() - Vector(1.1, 1.95, 0)).norm(), 0, 1e-12); // 0.1 m in 0.1 s
    EXPECT_EQ(body.acceleration(), Vector(0, 0, 0));
    EXPECT_NEAR((body.meanReaction().force - Vector(-3, 20, 0)).norm(), 0, 1e-12);
}

TEST(RigidBodyPrescribedMotion, OscillationNeedsItsForce)
{
    RigidBody body = brick();
    body.setPrescribedMotion(motion("oscillatingLinearMotion; amplitude (0 0.1 0); omega 6.283185307179586;"));
    Real const dt = 1e-4;
    steps(body, dt, 2500); // a quarter of a period
    EXPECT_NEAR(body.centre().y(), 2.1, 1e-12);
    EXPECT_NEAR(body.velocity().y(), 0, 1e-12);
    Real const middle = 0.25 - dt / 2;
    EXPECT_NEAR(body.meanReaction().force.y(), -2 * 0.1 * 4 * pi * pi * std::sin(2 * pi * middle), 1e-5);
}

TEST(RigidBodyPrescribedMotion, RotationAboutAnOriginCarriesTheCentre)
{
    RigidBody body = brick();
    body.setPrescribedMotion(motion("rotatingMotion; origin (0 2 0); axis (0 0 3); omega 1.5707963267948966;"));
    steps(body, 1e-3, 1000); // a quarter turn
    EXPECT_NEAR((body.centre() - Vector(0, 3, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((body.velocity() - Vector(-pi / 2, 0, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((body.toSpace(Vector(1, 0, 0)) - Vector(0, 4, 0)).norm(), 0, 1e-12);
    // Centripetal force m omega^2 r towards the origin.
    EXPECT_NEAR((body.meanReaction().force - Vector(0, -2 * pi * pi / 4, 0)).norm(), 0, 1e-2);
}

TEST(RigidBodyPrescribedMotion, TurningAnAsymmetricBodyNeedsTheGyroscopicMoment)
{
    RigidBody body = brick();
    body.setPrescribedMotion(motion("rotatingMotion; origin (1 2 0); axis (1 1 1); omega 2;"));
    Real const dt = 1e-5;
    steps(body, dt, 1);
    Vector const omega = 2 * Vector(1, 1, 1).normalized();
    EXPECT_NEAR((body.meanReaction().moment - omega.cross(body.inertia() * omega)).norm(), 0, 1e-4);
}

TEST(RigidBodyPrescribedMotion, TableIsMetAtItsTimesAndParabolasBetween)
{
    // x = t^2 / 2 from rest, turning by 90 t degrees about z: interpolation is exact for both.
    auto const table = motion("tabulated6DoFMotion; times (0 1 3 4); translations ((0 0 0) (0.5 0 0) (4.5 0 0) (8 0 0)); "
                              "rotations ((0 0 0) (0 0 90) (0 0 270) (0 0 360));");
    for (Real t : {0.0, 0.3, 1.0, 2.2, 3.5, 4.0})
    {
        RigidMotion const now = table->at(t, Vector(1, 2, 0), Quaternion::Identity());
        EXPECT_NEAR((now.centre - Vector(1 + t * t / 2, 2, 0)).norm(), 0, 1e-13);
        EXPECT_NEAR((now.velocity - Vector(t, 0, 0)).norm(), 0, 1e-13);
        EXPECT_NEAR((now.angularVelocity - Vector(0, 0, pi / 2)).norm(), 0, 1e-13);
        EXPECT_NEAR((now.orientation * Vector::UnitX() - Vector(std::cos(pi / 2 * t), std::sin(pi / 2 * t), 0)).norm(), 0, 1e-13);
    }
    RigidMotion const behind = table->at(9, Vector(1, 2, 0), Quaternion::Identity());
    EXPECT_EQ(behind.centre, Vector(9, 2, 0));
    EXPECT_EQ(behind.velocity, Vector(0, 0, 0));
}

TEST(RigidBodyPrescribedMotion, LinearTableHasStraightPieces)
{
    auto const table = motion("tabulated6DoFMotion; interpolationScheme linear; "
                              "times (0 1 2); translations 3((0 0 0) (1 0 0) (4 2 0));");
    RigidMotion const now = table->at(1.5, Vector::Zero(), Quaternion::Identity());
    EXPECT_NEAR((now.centre - Vector(2.5, 1, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((now.velocity - Vector(3, 2, 0)).norm(), 0, 1e-15);
}

TEST(RigidBodyPrescribedMotion, VelocitiesOfATableAreTheRatesOfItsPoses)
{
    // Turns about all axes and about a point away from the centre, against central differences.
    std::vector<TabulatedMotion::Row> rows;
    for (int i = 0; i < 8; ++i)
        rows.push_back({0.5 * i, Vector(std::sin(i), std::cos(i), 0.1 * i), Vector(0.3 * i, std::sin(i), -0.2 * i)});
    TabulatedMotion const table(rows, TabulatedMotion::Interpolation::Spline, Vector(0.5, -0.2, 0.1));
    Real const e = 1e-5;
    for (Real t : {0.2, 1.1, 2.7, 3.3})
    {
        auto const pose = [&](Real time) { return table.at(time, Vector(1, 2, 3), Quaternion::Identity()); };
        RigidMotion const now = pose(t), before = pose(t - e), after = pose(t + e);
        EXPECT_NEAR((now.velocity - (after.centre - before.centre) / (2 * e)).norm(), 0, 1e-8);
        Vector const arm(0.3, 0.4, -0.5);
        Vector const rate = (after.orientation * arm - before.orientation * arm) / (2 * e);
        EXPECT_NEAR((now.angularVelocity.cross(now.orientation * arm) - rate).norm(), 0, 1e-8);
    }
}

TEST(RigidBodyPrescribedMotion, BeginsAtTheRelease)
{
    RigidBody body = brick();
    body.setReleaseTime(0.5);
    body.setPrescribedMotion(motion("linearMotion; velocity (1 0 0);"));
    EXPECT_EQ(body.velocity(), Vector(0, 0, 0));
    EXPECT_TRUE(body.still(0.4));
    steps(body, 0.05, 10);
    EXPECT_EQ(body.centre(), Vector(1, 2, 0));
    steps(body, 0.05, 10, 0.5);
    EXPECT_NEAR(body.centre().x(), 1.5, 1e-12);
}

TEST(RigidBodyPrescribedMotion, RestartGoesOnBitwise)
{
    auto const fresh = [] {
        RigidBody body = brick();
        body.setPrescribedMotion(motion("oscillatingLinearMotion; amplitude (0.3 0.1 0); omega 3;"));
        return body;
    };
    RigidBody whole = fresh();
    steps(whole, 0.01, 10);
    State saved, a, b;
    whole.save(saved);
    RigidBody second = fresh();
    second.load(saved);
    steps(whole, 0.01, 10, 0.1);
    steps(second, 0.01, 10, 0.1);
    whole.save(a);
    second.save(b);
    EXPECT_EQ(a.blocks(), b.blocks());
}

TEST(RigidBodyPrescribedMotion, WrongTablesAndWordsAreRefused)
{
    EXPECT_THROW((void)motion("linearMoton; velocity (1 0 0);"), CaseError);
    std::string const two = "translations ((0 0 0) (1 0 0));";
    EXPECT_NO_THROW((void)motion("tabulated6DoFMotion; times (0 1); " + two));
    EXPECT_THROW((void)motion("tabulated6DoFMotion; times (0); translations ((0 0 0));"), CaseError);
    EXPECT_THROW((void)motion("tabulated6DoFMotion; times (1 0); " + two), CaseError);
    EXPECT_THROW((void)motion("tabulated6DoFMotion; times (0 1 2); " + two), CaseError);
    EXPECT_THROW((void)motion("tabulated6DoFMotion; times (0 1);"), CaseError);
    EXPECT_THROW((void)motion("tabulated6DoFMotion; times (0 1); interpolationScheme cubic; " + two), CaseError);
    RigidBody body = brick();
    body.restrictTo2D();
    EXPECT_THROW(body.setPrescribedMotion(motion("linearMotion; velocity (0 0 1);")), CaseError);
    // Seen when the case is read, though the motion stays in the plane for a second: never in the middle of a run.
    std::string const later = "tabulated6DoFMotion; times (0 1 2); ";
    EXPECT_THROW(body.setPrescribedMotion(motion(later + "translations ((0 0 0) (1 0 0) (2 0 1));")), CaseError);
    EXPECT_THROW(body.setPrescribedMotion(motion(later + "rotations ((0 0 0) (0 0 5) (0 5 5));")), CaseError);
    EXPECT_NO_THROW(
        body.setPrescribedMotion(motion(later + "translations ((0 0 0) (1 0 0) (2 1 0)); rotations ((0 0 0) (0 0 5) (0 0 9));")));
}

} // namespace
} // namespace mpsDem
