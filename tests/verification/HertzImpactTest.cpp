// Impacts of balls with the Hertz-Mindlin law against closed forms and against the tests of Y. Chung and J. Ooi, Granular Matter 13 (2011).
// A rigid plane has twice the effective modulus of two equal materials: youngsModulus is doubled there.

#include <algorithm>

#include "support/ChungOoi.h"
#include "support/ContactScene.h"

namespace mpsDem::test {

namespace {

constexpr Real pi = std::numbers::pi;

struct Ball
{
    Real radius;
    Real density;
    Real youngsModulus;
    Real poissonsRatio;

    [[nodiscard]] Real mass() const { return 4.0 / 3.0 * pi * radius * radius * radius * density; }
};

struct HertzResult
{
    Real force = 0;
    Real overlap = 0;
    Real time = 0;
    Real restitution = 0;
};

std::string dictionary(Ball const& ball, bool rigidPlane, Real mu, Real e)
{
    return "law hertzMindlin; mu " + std::to_string(mu) + "; e " + std::to_string(e) + "; youngsModulus " +
           std::to_string(ball.youngsModulus * (rigidPlane ? 2 : 1)) + "; poissonsRatio " + std::to_string(ball.poissonsRatio) +
           "; collisionResolutionSteps 200;";
}

/// F_max, delta_max and time of an elastic impact: delta = (15 m v^2 / (16 E* sqrt R))^(2/5), t = 2.868 (m^2 / (R E*^2 v))^(1/5).
HertzResult closedForm(Real mass, Real radius, Real modulus, Real speed)
{
    HertzResult exact;
    exact.overlap = std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
    exact.force = 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(exact.overlap, 1.5);
    exact.time = 2.868 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2);
    return exact;
}

/// Runs until the first ball is free again.
HertzResult run(ContactScene& scene, Real dt)
{
    RigidBody const& ball = *scene.pointers[0];
    Real const before = ball.velocity().norm();
    HertzResult result;
    Real first = -1;
    for (int i = 0; i < 100000 && (first < 0 || scene.contact->contactCount() > 0); ++i)
        scene.step(dt, 1, [&] {
            if (ball.contactNormal.force.norm() <= 0) return;
            if (first < 0) first = scene.time;
            result.time = scene.time - first;
            result.force = std::max(result.force, ball.contactNormal.force.norm());
            result.overlap = std::max(result.overlap, scene.contact->maxOverlap());
        });
    result.restitution = ball.velocity().norm() / before;
    return result;
}

HertzResult ballOnPlane(Ball const& ball, Real speed, Real e)
{
    ContactScene scene;
    scene.spacing = 2 * ball.radius;
    scene.surfaces = {floorLine()};
    scene.addBall("ball", ball.radius, ball.density, {0, ball.radius * 1.0001, 0}).setVelocity({0, -speed, 0}, Vector::Zero());
    scene.build(dictionary(ball, true, 0, e));
    return run(scene, 1e-3 * ball.radius / speed);
}

void expectHertz(std::string const& name, HertzResult const& found, HertzResult const& exact)
{
    expectBelow(name + ", peak force, relative error", found.force / exact.force - 1, 0.01);
    expectBelow(name + ", overlap, relative error", found.overlap / exact.overlap - 1, 0.01);
    expectBelow(name + ", time of contact, relative error", found.time / exact.time - 1, 0.01);
}

} // namespace

// Test 1: two equal balls of glass, 10 m/s each. Digitised curve: 10.704 kN, 40.48 us.
TEST(HertzImpact, chungOoi1TwoBallsOfGlass)
{
    Ball const glass{0.01, 2800, 4.8e10, 0.2};
    ContactScene scene;
    scene.spacing = 0.02;
    scene.addBall("left", glass.radius, glass.density, {-0.0100001, 0, 0}).setVelocity({10, 0, 0}, Vector::Zero());
    scene.addBall("right", glass.radius, glass.density, {0.0100001, 0, 0}).setVelocity({-10, 0, 0}, Vector::Zero());
    scene.build(dictionary(glass, false, 0.35, 1));
    HertzResult const found = run(scene, 1e-6);
    expectHertz("Chung & Ooi 1", found, closedForm(0.5 * glass.mass(), 0.5 * glass.radius, 4.8e10 / (2 * 0.96), 20));
    expectBelow("Chung & Ooi 1, peak force against the curve", found.force / 10704 - 1, 0.015);
    expectBelow("Chung & Ooi 1, time against the curve", found.time / 40.48e-6 - 1, 0.015);
}

// Test 2: a ball of aluminium alloy on a rigid plane at 0.2 m/s. Digitised curve: 11.357 kN, 727.5 us.
TEST(HertzImpact, chungOoi2BallOnPlane)
{
    Ball const aluminium{0.1, 2699, 7e10, 0.3};
    HertzResult const found = ballOnPlane(aluminium, 0.2, 1);
    expectHertz("Chung & Ooi 2", found, closedForm(aluminium.mass(), aluminium.radius, 7e10 / 0.91, 0.2));
    expectBelow("Chung & Ooi 2, peak force against the curve", found.force / 11357 - 1, 0.015);
    expectBelow("Chung & Ooi 2, time against the curve", found.time / 727.5e-6 - 1, 0.015);
}

// Test 3: restitution out as restitution in.
TEST(HertzImpact, chungOoi3Restitution)
{
    for (Real const e : {0.2, 0.4, 0.6, 0.8, 1.0})
    {
        HertzResult const found = ballOnPlane({0.0025, 4000, 3.8e11, 0.23}, 3.9, e);
        expectBelow("Chung & Ooi 3, e " + std::to_string(e) + ", relative error", found.restitution / e - 1, 0.01);
    }
}

// Test 4: oblique impact of a ball of aluminium oxide.
TEST(HertzImpact, chungOoi4ObliqueImpact)
{
    Ball const ball{0.0025, 4000, 3.8e11, 0.23};
    for (Oblique const& row : chungOoi4)
    {
        ContactScene scene;
        scene.spacing = 2 * ball.radius;
        scene.surfaces = {floorLine()};
        RigidBody& body = scene.addBall("ball", ball.radius, ball.density, {0, ball.radius * 1.0001, 0});
        Real const angle = row.angle * pi / 180;
        Vector const before = 3.9 * Vector(std::sin(angle), -std::cos(angle), 0);
        body.setVelocity(before, Vector::Zero());
        scene.build(dictionary(ball, true, 0.092, 0.98));
        run(scene, 1e-6);
        Vector const after = body.velocity();
        Vector const patch = body.velocityAt(body.centre() - Vector(0, ball.radius, 0));
        expectOnTheCurves("Chung & Ooi 4",
                          {row.angle, after.x() / before.x(), body.angularVelocity().z(), std::atan2(patch.x(), patch.y()) * 180 / pi},
                          row);
    }
}

} // namespace mpsDem::test
