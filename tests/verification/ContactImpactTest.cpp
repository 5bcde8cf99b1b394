// Head-on and oblique impacts with the linear law: restitution, time of contact, energy, momentum.

#include "support/ContactScene.h"

namespace mpsDem::test {

namespace {

struct Impact
{
    Real restitution;
    Real contactTime;
    Real gain;   ///< Kinetic energy after it / before it - 1.
    Real budget; ///< (Kinetic energy after it + dissipated) / before it - 1.
};

/// A ball of 0.1 m falls on the floor without gravity. @param refine  Sub-steps as a multiple of those asked for.
Impact ballOnFloor(std::string const& dictionary, Real speed, Real gap, Real dt = 1e-4, Real refine = 1)
{
    ContactScene scene;
    scene.surfaces = {floorLine()};
    RigidBody& ball = scene.addBall("ball", 0.1, 2700, {0, 0.1 + gap, 0});
    ball.setVelocity({0, -speed, 0}, Vector::Zero());
    scene.build(dictionary);
    Real const before = scene.kineticEnergy();
    Real first = -1;
    Real last = -1;
    for (int i = 0; i < 100000 && (first < 0 || scene.contact->contactCount() > 0); ++i)
        scene.step(dt, refine, [&] {
            if (ball.contactNormal.force.y() <= 0) return;
            if (first < 0) first = scene.time;
            last = scene.time;
        });
    Real const after = scene.kineticEnergy();
    return {ball.velocity().y() / speed, last - first, after / before - 1, (after + scene.contact->dissipatedEnergy()) / before - 1};
}

std::string linear(Real e, Real stiffness)
{
    return "mu 0.3; e " + std::to_string(e) + "; stiffness constant; normalStiffness " + std::to_string(stiffness) + ";";
}

} // namespace

TEST(ContactImpact, restitutionIsTheOneAskedFor)
{
    for (Real const e : {0.2, 0.5, 0.9})
        for (Real const gap : {1e-4, 1.37e-4})
        {
            Impact const impact = ballOnFloor(linear(e, 1e9), 1, gap);
            expectBelow("restitution " + std::to_string(e) + ", relative error", impact.restitution / e - 1, 0.01);
            expectBelow("  energy budget, relative", impact.budget, 2e-3);
        }
}

// t = (pi - 2 asin(zeta)) / (omega0 sqrt(1 - zeta^2)): from the first touch until the force of spring and dashpot is zero.
TEST(ContactImpact, contactTimeOfTheDampedOscillator)
{
    Real const mass = 4.0 / 3.0 * std::numbers::pi * 1e-3 * 2700;
    Real const stiffness = 1e9 * 0.02;
    for (Real const e : {0.2, 0.5, 0.9})
    {
        Real const zeta = dampingRatio(e);
        Real const omega = std::sqrt(stiffness / mass * (1 - zeta * zeta));
        Real const exact = (std::numbers::pi - 2 * std::asin(zeta)) / omega;
        Impact const impact = ballOnFloor(linear(e, 1e9), 1, 1e-4, 1e-4, 20);
        expectBelow("time of contact, e " + std::to_string(e) + ", relative error", impact.contactTime / exact - 1, 0.01);
    }
}

TEST(ContactImpact, elasticImpactGainsNoEnergy)
{
    Real mostGained = 0;
    Real mostLost = 0;
    for (Real const speed : {0.5, 1.0, 3.0})
        for (Real const stiffness : {1e9, 1e10, 1e11})
            for (Real const dt : {5e-4, 1e-3, 2e-3})
            {
                Impact const impact = ballOnFloor(linear(1, stiffness), speed, 1.23e-4, dt);
                mostGained = std::max(mostGained, impact.gain);
                mostLost = std::max(mostLost, -impact.gain);
            }
    expectBelow("elastic impacts, largest relative gain of energy", mostGained, 1e-3);
    expectBelow("elastic impacts, largest relative loss of energy", mostLost, 5e-3);
}

// Two bodies of different mass and shape meet off their centres; whatever acts, momentum stays.
TEST(ContactImpact, bodiesExchangeMomentum)
{
    ContactScene scene;
    RigidBody& a = scene.addBox("a", 0.2, 0.1, 2700, {-0.1501, 0, 0});
    RigidBody& b = scene.addBox("b", 0.1, 0.1, 1000, {0.0101, 0.03, 0}, 0.1);
    a.setVelocity({1, 0.1, 0}, {0, 0, 1});
    b.setVelocity({-0.5, 0, 0}, Vector::Zero());
    scene.build("mu 0.4; e 0.5;");
    auto const momentum = [&] { return Vector(a.mass() * a.velocity() + b.mass() * b.velocity()); };
    auto const angular = [&] {
        return a.mass() * a.centre().cross(a.velocity()).z() + a.inertia()(2, 2) * a.angularVelocity().z() +
               b.mass() * b.centre().cross(b.velocity()).z() + b.inertia()(2, 2) * b.angularVelocity().z();
    };
    Vector const p = momentum();
    Real const l = angular();
    Real const energy = scene.kineticEnergy();
    Real const scale = a.mass();
    std::size_t touched = 0;
    for (int i = 0; i < 400; ++i)
    {
        scene.step(1e-4);
        touched = std::max(touched, scene.contact->contactCount());
    }
    EXPECT_GT(touched, 0u);
    EXPECT_LT(a.velocity().x(), 0.9);
    expectBelow("two bodies, relative change of momentum", (momentum() - p).norm() / scale, 1e-12);
    expectBelow("two bodies, relative change of angular momentum", (angular() - l) / scale, 1e-12);
    expectBelow("two bodies, energy budget, relative",
                (scene.kineticEnergy() + scene.contact->elasticEnergy() + scene.contact->dissipatedEnergy()) / energy - 1, 0.01);
}

// Two equal cubes face to face (set-up: Amicarelli et al. 2015): they exchange their velocities.
TEST(ContactImpact, equalCubesExchangeVelocities)
{
    for (Real const first : {0.5, 0.75, 0.075})
    {
        ContactScene scene;
        scene.spacing = 0.005;
        scene.thickness = 0.05;
        Real const second = first == 0.5 ? -0.5 : (first == 0.75 ? -0.25 : -0.025);
        RigidBody& a = scene.addBox("a", 0.05, 0.05, 500, {-0.0251, 0, 0});
        RigidBody& b = scene.addBox("b", 0.05, 0.05, 500, {0.0251, 0, 0});
        a.setVelocity({first, 0, 0}, Vector::Zero());
        b.setVelocity({second, 0, 0}, Vector::Zero());
        scene.build("mu 0; e 1;");
        for (int i = 0; i < 100; ++i) scene.step(first > 0.1 ? 1e-4 : 1e-3);
        expectBelow("equal cubes at " + std::to_string(first) + " m/s, error [m/s]",
                    std::max(std::abs(a.velocity().x() - second), std::abs(b.velocity().x() - first)), 1e-2 * first);
    }
}

} // namespace mpsDem::test
