#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/RigidBody.h"
#include "support/Measured.h"

namespace mpsDem {
namespace {

Real constexpr pi = std::numbers::pi;

using test::expectBelow;

RigidBody bodyWith(Real mass, Vector const& moments, Vector const& centre = Vector::Zero())
{
    MassProperties properties;
    properties.mass = mass;
    properties.inertia = moments.asDiagonal();
    return RigidBody("body", properties, centre, Quaternion::Identity());
}

void run(RigidBody& body, Real h, long count, int subSteps = 1)
{
    for (long i = 0; i < count; ++i)
    {
        body.beginStep();
        Real const time = static_cast<Real>(i * subSteps) * h;
        for (int k = 0; k < subSteps; ++k) body.advance(time + k * h, h);
        body.endStep(subSteps * h);
    }
}

TEST(RigidBodyVerification, DzhanibekovKeepsEnergyAndMomentum)
{
    // Asymmetric top about its middle axis, disturbed: it flips over again and again. One turn a second, 100 turns.
    RigidBody body = bodyWith(1, Vector(1, 2, 3));
    body.setVelocity(Vector::Zero(), 2 * pi * Vector(1e-3, 1, 1e-3));
    Vector const momentum = body.inertia() * body.angularVelocity();
    Real const energy = body.kineticEnergy();
    Real energyError = 0, momentumError = 0;
    int flips = 0;
    Real sign = 1;
    for (int i = 0; i < 1000; ++i)
    {
        run(body, 1e-4, 10, 100);
        energyError = std::max(energyError, std::abs(body.kineticEnergy() / energy - 1));
        momentumError = std::max(momentumError, (body.inertia() * body.angularVelocity() - momentum).norm() / momentum.norm());
        Real const side = (body.rotation().transpose() * body.angularVelocity()).y() < 0 ? -1 : 1;
        flips += side != sign;
        sign = side;
    }
    EXPECT_GT(flips, 10);
    expectBelow("Dzhanibekov, energy drift in 100 turns", energyError, 1e-6);
    expectBelow("Dzhanibekov, angular momentum, relative", momentumError, 1e-8);
}

TEST(RigidBodyVerification, SymmetricTopPrecessesAtItsRate)
{
    // Torque-free symmetric top: the body axis goes round the momentum at |L| / I1.
    RigidBody top = bodyWith(1, Vector(2, 2, 1));
    top.setVelocity(Vector::Zero(), Vector(1, 0, 5));
    Vector const momentum = top.inertia() * top.angularVelocity();
    run(top, 5e-3, 2000);
    Vector const exact = Eigen::AngleAxisd(momentum.norm() / 2 * 10, momentum.normalized()) * Vector::UnitZ();
    expectBelow("precession of a symmetric top, error at 10 s", (top.rotation().col(2) - exact).norm(), 1e-8);
}

TEST(RigidBodyVerification, FreeTopConvergesAtSecondOrder)
{
    auto const pose = [](Real h, long count) {
        RigidBody top = bodyWith(1, Vector(1, 2, 3));
        top.setVelocity(Vector::Zero(), Vector(1, 2, 1));
        run(top, h, count);
        return top.rotation();
    };
    Tensor const reference = pose(1.25e-3, 4000);
    Real const coarse = (pose(2e-2, 250) - reference).norm(), fine = (pose(1e-2, 500) - reference).norm();
    expectBelow("asymmetric top, error at 5 s, h = 10 ms", fine, 2e-3);
    expectBelow("asymmetric top, |2 - observed order|", std::abs(std::log2(coarse / fine) - 2), 0.1);
}

TEST(RigidBodyVerification, GravityTopKeepsItsEnergyWithSubSteps)
{
    // Top on a tip that a stiff spring holds: the moment of the spring acts on a spinning body.
    RigidBody body = bodyWith(1, Vector(0.02, 0.02, 0.01), Vector(0, 0, 0.1));
    body.addRestraint(makeRestraint("tip", Dictionary::fromText("sixDoFRigidBodyMotionRestraint linearSpring; anchor (0 0 0); "
                                                                "refAttachmentPt (0 0 0); stiffness 2000; damping 0; restLength 0;")));
    body.setGravity(Vector(0, 0, -9.81));
    body.setVelocity(Vector(0, 0.02, 0), Vector(-0.2, 0, 60));
    auto const energy = [&] {
        Real const stretch = body.toSpace(Vector(0, 0, -0.1)).norm();
        return body.kineticEnergy() + 9.81 * body.centre().z() + 1000 * stretch * stretch;
    };
    Real const begin = energy();
    Real worst = 0;
    for (int i = 0; i < 100; ++i)
    {
        run(body, 1e-4, 10, 100);
        worst = std::max(worst, std::abs(energy() / begin - 1));
    }
    expectBelow("sleeping top on a spring, energy in 10 s", worst, 1e-5);
    expectBelow("sleeping top stays upright, axis from z", 1 - body.rotation()(2, 2), 1e-3);
}

TEST(RigidBodyVerification, SpringPeriod)
{
    // T = 2 pi sqrt(m / k); semi-implicit Euler shortens it by (omega h)^2 / 24.
    RigidBody body = bodyWith(2, Vector(1, 1, 1), Vector(1.1, 0, 0));
    body.addRestraint(makeRestraint("spring", Dictionary::fromText("sixDoFRigidBodyMotionRestraint linearSpring; anchor (0 0 0); "
                                                                   "refAttachmentPt (1.1 0 0); stiffness 200; damping 0; restLength 1;")));
    Real const h = 1e-3;
    std::vector<Real> crossings;
    Real amplitude = 0;
    for (int i = 0; i < 20000; ++i)
    {
        Real const before = body.centre().x() - 1;
        run(body, h, 1);
        Real const after = body.centre().x() - 1;
        if (before < 0 && after >= 0) crossings.push_back(h * (i - before / (after - before)));
        if (i >= 19000) amplitude = std::max(amplitude, std::abs(after));
    }
    Real const period = (crossings.back() - crossings.front()) / static_cast<Real>(crossings.size() - 1);
    Real const exact = 2 * pi * std::sqrt(2.0 / 200);
    expectBelow("linear spring, period error", std::abs(period / exact - 1), 2 * 1e-4 / 24);
    expectBelow("linear spring, amplitude after 31 periods", std::abs(amplitude / 0.1 - 1), 1e-4);
}

TEST(RigidBodyVerification, DampedSpringDecays)
{
    // x = exp(-c t / 2m) x0 at each period.
    RigidBody body = bodyWith(2, Vector(1, 1, 1), Vector(1.1, 0, 0));
    body.addRestraint(makeRestraint("spring", Dictionary::fromText("sixDoFRigidBodyMotionRestraint linearSpring; anchor (0 0 0); "
                                                                   "refAttachmentPt (1.1 0 0); stiffness 200; damping 2; restLength 1;")));
    Real const omega = std::sqrt(100 - 0.25);
    Real const time = 2 * pi / omega * 5, h = time / 50000;
    run(body, h, 50000);
    Real const ratio = (body.centre().x() - 1) / 0.1 / std::exp(-0.5 * time);
    expectBelow("damped spring, decay in five periods", std::abs(ratio - 1), 1e-4);
}

TEST(RigidBodyVerification, DamperConvergesAtFirstOrder)
{
    auto const error = [](Real h, int count) {
        RigidBody body = bodyWith(2, Vector(1, 1, 1));
        body.addRestraint(makeRestraint("damper", Dictionary::fromText("sixDoFRigidBodyMotionRestraint linearDamper; coeff 3;")));
        body.setVelocity(Vector(1, 0, 0), Vector::Zero());
        run(body, h, count);
        return std::abs(body.velocity().x() / std::exp(-1.5) - 1);
    };
    Real const coarse = error(2e-3, 500), fine = error(1e-3, 1000);
    expectBelow("linear damper, error at 1 s, h = 1 ms", fine, 1.5 * 1.5 * 1e-3 / 2 * 1.01);
    expectBelow("linear damper, |1 - observed order|", std::abs(std::log2(coarse / fine) - 1), 0.01);
}

TEST(RigidBodyVerification, LightBodyWithAddedMassIsStable)
{
    // Body of a twentieth of its added mass: lagging the fluid's answer would multiply the error by -20 every step.
    RigidBody body = bodyWith(1, Vector(1, 1, 1));
    body.setGravity(Vector(0, -9.81, 0));
    Matrix6 const addedMass = 20 * Matrix6::Identity();
    Vector6 assumed = Vector6::Zero();
    Real worst = 0;
    Real const buoyancy = 2 * 9.81, exact = (buoyancy - 9.81) / 21;
    for (int i = 0; i < 100; ++i)
    {
        body.fluid.force = Vector(0, buoyancy, 0) - 20 * assumed.head<3>(); // what a fluid that took a* answers
        body.setAddedMass(addedMass, assumed);
        run(body, 1e-3, 1);
        worst = std::max(worst, std::abs(body.acceleration().y() / exact - 1));
        assumed.head<3>() = body.acceleration();
    }
    expectBelow("light body (1:20), acceleration", worst, 1e-11);
}

TEST(RigidBodyVerification, MomentumBudgetCloses)
{
    // m dV = dt (all loads + reaction), with constraint, spring, release and latch in one run.
    RigidBody body = bodyWith(2, Vector(0.3, 0.5, 0.7), Vector(1, 2, 3));
    body.addConstraint(makeConstraint("line", Dictionary::fromText("sixDoFRigidBodyMotionConstraint line; direction (3 -4 0);")));
    body.addRestraint(makeRestraint("spring", Dictionary::fromText("sixDoFRigidBodyMotionRestraint linearSpring; anchor (0 0 0); "
                                                                   "refAttachmentPt (1 2 4); stiffness 20; damping 1; restLength 1;")));
    body.setGravity(Vector(0, -9.81, 0));
    body.setVelocity(Vector(3, -4, 0), Vector(1, 2, 3));
    body.setReleaseTime(0.1);
    Real worst = 0;
    Real const dt = 0.01;
    for (int i = 0; i < 50; ++i)
    {
        Vector const before = body.mass() * body.velocity();
        body.beginStep();
        for (int k = 0; k < 4; ++k)
        {
            body.contactNormal.force = Vector(std::sin(i + k), 0, 1);
            body.advance(i * dt + k * dt / 4, dt / 4);
            if (i == 40 && k == 1) body.lock();
        }
        body.endStep(dt);
        Vector const impulse = dt * (body.gravityLoad() + body.meanContactNormal() + body.meanRestraint() + body.meanReaction()).force;
        worst = std::max(worst, (body.mass() * body.velocity() - before - impulse).norm());
    }
    EXPECT_TRUE(body.locked());
    expectBelow("momentum budget of a body, worst step [N s]", worst, 1e-13);
}

} // namespace
} // namespace mpsDem
