// A block on an incline against Coulomb: s = g (sin - mu cos) t^2 / 2 where tan > mu, else it sticks.

#include "support/ContactScene.h"

namespace mpsDem::test {

namespace {

constexpr Real g = 9.81;
constexpr Real length = 0.3;
constexpr Real height = 0.1;
constexpr Real root2 = std::numbers::sqrt2;

Vector const down = Vector(1, -1, 0) / root2;
Vector const up = Vector(1, 1, 0) / root2;

/// A ramp of 45 degrees from (0, 5) to (5, 0) in `pieces`.
Polyline ramp(int pieces)
{
    std::vector<Vector> points;
    for (int i = 0; i <= pieces; ++i) points.emplace_back(5.0 * i / pieces, 5.0 - 5.0 * i / pieces, 0);
    return Polyline("ramp", points, false, Polyline::FluidSide::Left);
}

/// The block lies on the ramp with the overlap that carries it. @param stiffness  [N/m3].
std::unique_ptr<ContactScene> blockOnRamp(Real mu, Real spacing, Polyline const& line, Real stiffness = 1e9)
{
    auto scene = std::make_unique<ContactScene>();
    scene->gravity = Vector(0, -g, 0);
    scene->spacing = spacing;
    scene->surfaces = {line};
    Real const density = 2700;
    Real const overlap = density * length * height * g / root2 / (stiffness * length);
    Vector const foot(0.5, 4.5, 0);
    scene->addBox("block", length, height, density, foot + (0.5 * height - overlap) * up, -std::numbers::pi / 4);
    scene->build("law linearSpringDashpot; mu " + std::to_string(mu) + "; e 0.2; stiffness constant; normalStiffness " +
                 std::to_string(stiffness) + ";");
    return scene;
}

/// Path along the ramp after 0.5 s.
Real path(ContactScene& scene)
{
    Vector const start = scene.pointers[0]->centre();
    for (int i = 0; i < 250; ++i) scene.step(0.002);
    return (scene.pointers[0]->centre() - start).dot(down);
}

} // namespace

// Before the block slides, its tangential springs must stretch by mu N / k_t; the speed that it gains meanwhile is an error of its path,
// which matters where friction nearly holds it and falls with the root of the stiffness.
TEST(ContactIncline, slidesAsCoulombSays)
{
    for (Real const mu : {0.0105, 0.3, 0.9})
    {
        auto scene = blockOnRamp(mu, 0.02, ramp(1), mu > 0.5 ? 2e11 : 1e9);
        Real const exact = 0.5 * g * (1 - mu) / root2 * 0.25;
        expectBelow("incline 45 deg, relative error of path, mu " + std::to_string(mu), path(*scene) / exact - 1, 1e-3);
    }
}

TEST(ContactIncline, sticksAboveTheFrictionAngle)
{
    auto scene = blockOnRamp(1.1, 0.02, ramp(1));
    expectBelow("incline 45 deg, mu 1.1, slip [m]", path(*scene), 1e-4);
    expectBelow("incline 45 deg, mu 1.1, creep in 0.5 s more [m]", path(*scene), 1e-9);
    expectBelow("incline 45 deg, mu 1.1, speed at the end [m/s]", scene->pointers[0]->velocity().norm(), 1e-9);
}

TEST(ContactIncline, frictionDoesNotDependOnTheSpacing)
{
    for (Real const spacing : {0.04, 0.02, 0.01})
    {
        auto scene = blockOnRamp(0.3, spacing, ramp(1));
        Real const effective = 1 - path(*scene) * root2 / (0.5 * g * 0.25);
        expectBelow("friction from the path at spacing " + std::to_string(spacing) + ", relative error", effective / 0.3 - 1, 0.01);
    }
}

TEST(ContactIncline, rampOfManyPiecesIsOneRamp)
{
    auto whole = blockOnRamp(0.3, 0.02, ramp(1));
    Real const exact = path(*whole);
    for (int const pieces : {2, 200, 20000})
    {
        auto scene = blockOnRamp(0.3, 0.02, ramp(pieces));
        expectBelow("ramp of " + std::to_string(pieces) + " pieces, difference of path [m]", path(*scene) - exact, 1e-9);
    }
}

// The pieces are bent to and fro by a tenth of the overlap, so that they stay separate sides and the points cross thousands of joints.
TEST(ContactIncline, crossingJointsKeepsTheForce)
{
    auto whole = blockOnRamp(0.3, 0.02, ramp(1));
    Real const exact = path(*whole);
    std::vector<Vector> points;
    int const pieces = 1000;
    for (int i = 0; i <= pieces; ++i)
        points.push_back(Vector(5.0 * i / pieces, 5.0 - 5.0 * i / pieces, 0) + (i % 2 == 0 ? 0.0 : 2e-7) * up);
    auto bent = blockOnRamp(0.3, 0.02, Polyline("ramp", points, false, Polyline::FluidSide::Left));
    expectBelow("ramp of bent pieces, relative difference of path", path(*bent) / exact - 1, 1e-3);
}

// A ball rolls where tan(theta) <= 3.5 mu: a = 5/7 g sin(theta); else it slips: a = g (sin - mu cos).
TEST(ContactIncline, ballRollsOrSlips)
{
    for (Real const mu : {0.2, 0.5})
    {
        ContactScene scene;
        scene.gravity = Vector(0, -g, 0);
        scene.surfaces = {ramp(1)};
        Real const radius = 0.1;
        Real const overlap = 1e-6;
        RigidBody& disc = scene.addBall("disc", radius, 2000, Vector(0.5, 4.5, 0) + (radius - overlap) * up);
        scene.build("mu " + std::to_string(mu) + "; e 0.2;");
        Real const rolling = 5.0 / 7.0 * g / root2;
        Real const slipping = g * (1 - mu) / root2;
        Real const exact = 0.5 * 0.25 * (1 > 3.5 * mu ? slipping : rolling);
        Vector const start = disc.centre();
        for (int i = 0; i < 50; ++i) scene.step(0.01);
        expectBelow("ball on 45 deg, mu " + std::to_string(mu) + ", relative error of path", (disc.centre() - start).dot(down) / exact - 1,
                    2e-3);
    }
}

} // namespace mpsDem::test
