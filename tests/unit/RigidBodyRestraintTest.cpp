#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bodies/RigidBody.h"
#include "core/Errors.h"

namespace mpsDem {
namespace {

RigidBody brick()
{
    MassProperties mass;
    mass.mass = 2;
    mass.inertia = Vector(0.3, 0.5, 0.7).asDiagonal();
    return RigidBody("brick", mass, Vector(1, 2, 0), Quaternion::Identity());
}

std::unique_ptr<Restraint> restraint(std::string const& entries)
{
    return makeRestraint("test", Dictionary::fromText("sixDoFRigidBodyMotionRestraint " + entries));
}

void step(RigidBody& body, Real time, Real h)
{
    body.beginStep();
    body.advance(time, h);
    body.endStep(h);
}

TEST(RigidBodyRestraint, SpringPullsAtItsAttachment)
{
    // Stretched by 2 m of 3 along y, attached 1 m to the right of the centre: F = -k 2 e_y, M = 1 * F_y.
    RigidBody body = brick();
    body.addRestraint(restraint("linearSpring; anchor (2 -1 0); refAttachmentPt (2 2 0); stiffness 5; damping 0; restLength 1;"));
    step(body, 0, 1e-6);
    EXPECT_NEAR((body.meanRestraint().force - Vector(0, -10, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((body.meanRestraint().moment - Vector(0, 0, -10)).norm(), 0, 1e-12);
    EXPECT_NEAR(body.acceleration().y(), -5, 1e-9);
}

TEST(RigidBodyRestraint, SpringDampsTheSpeedAlongItselfOnly)
{
    RigidBody body = brick();
    body.addRestraint(restraint("linearSpring; anchor (1 0 0); refAttachmentPt (1 2 0); stiffness 0; damping 3; restLength 2;"));
    body.setVelocity(Vector(7, 0.5, 0), Vector::Zero());
    step(body, 0, 1e-6);
    EXPECT_NEAR((body.meanRestraint().force - Vector(0, -1.5, 0)).norm(), 0, 1e-12);
}

TEST(RigidBodyRestraint, AttachmentTurnsWithTheBody)
{
    RigidBody body = brick();
    body.addRestraint(restraint("linearSpring; anchor (1 2 0); refAttachmentPt (1.5 2 0); stiffness 4; damping 0; restLength 0;"));
    body.setVelocity(Vector::Zero(), Vector(0, 0, std::numbers::pi / 2));
    for (int i = 0; i < 1000; ++i) step(body, i * 1e-3, 1e-3);
    // The centre has moved under the pull meanwhile; the load is that of the point 0.5 m along the turned x axis.
    Vector const point = body.toSpace(Vector(0.5, 0, 0));
    step(body, 1, 1e-9);
    EXPECT_NEAR((body.meanRestraint().force + 4 * (point - Vector(1, 2, 0))).norm(), 0, 1e-12);
}

TEST(RigidBodyRestraint, LinearDamperSlowsExponentially)
{
    // Semi-implicit Euler: v_n = v_0 (1 - h c / m)^n, near exp(-c t / m).
    RigidBody body = brick();
    body.addRestraint(restraint("linearDamper; coeff 3;"));
    body.setVelocity(Vector(2, -1, 0), Vector(0, 0, 1));
    Real const h = 1e-3;
    for (int i = 0; i < 1000; ++i) step(body, i * h, h);
    EXPECT_NEAR(body.velocity().x() / 2, std::pow(1 - h * 1.5, 1000), 1e-13);
    EXPECT_NEAR(body.velocity().x() / 2, std::exp(-1.5), 1.5 * 1.5 * h / 2 * std::exp(-1.5) * 1.01);
    EXPECT_NEAR(body.angularVelocity().z(), 1, 1e-13);
}

TEST(RigidBodyRestraint, SphericalAngularDamperSlowsTheRotationOnly)
{
    RigidBody body = brick();
    body.addRestraint(restraint("sphericalAngularDamper; coeff 0.14;"));
    body.setVelocity(Vector(1, 0, 0), Vector(0, 0, 2));
    for (int i = 0; i < 1000; ++i) step(body, i * 1e-3, 1e-3);
    EXPECT_NEAR(body.angularVelocity().z() / 2, std::pow(1 - 1e-3 * 0.2, 1000), 1e-13);
    EXPECT_EQ(body.velocity(), Vector(1, 0, 0));
}

TEST(RigidBodyRestraint, AxialAngularSpringTurnsBack)
{
    MassProperties mass;
    mass.mass = 2;
    for (Real angle : {0.4, -0.4, 3.0, -3.0})
    {
        RigidBody body("brick", mass, Vector::Zero(), Quaternion(Eigen::AngleAxisd(angle, Vector::UnitZ())));
        body.addRestraint(restraint("linearAxialAngularSpring; axis (0 0 1); stiffness 5; damping 2;"));
        body.setVelocity(Vector::Zero(), Vector(0, 0, 0.1));
        step(body, 0, 1e-9);
        EXPECT_NEAR(body.meanRestraint().moment.z(), -5 * angle - 0.2, 1e-13);
    }
}

TEST(RigidBodyRestraint, UnknownWordsAndNegativeNumbersAreRefused)
{
    EXPECT_THROW((void)restraint("linearSprong;"), CaseError);
    EXPECT_THROW((void)restraint("linearDamper; coeff -1;"), CaseError);
    EXPECT_THROW((void)restraint("linearSpring; anchor (0 0 0); stiffness 1; damping 0; restLength 0;"), CaseError);
}

} // namespace
} // namespace mpsDem
