// Cubes on planes and on one another in 3-D: rest, impacts on faces, edges and corners, energy, stacks.

#include "support/SolidScene.h"

namespace mpsDem::test {

namespace {

constexpr Real g = 9.81;
constexpr Real side = 0.2;
Vector const cubeSize(side, side, side);

Quaternion turned(Real angle, Vector const& axis) { return Quaternion(Eigen::AngleAxisd(angle, axis.normalized())); }

/// Height of the centre of a turned cube that touches z = 0.
Real standingHeight(Quaternion const& pose)
{
    Real least = 0;
    for (int k = 0; k < 8; ++k) least = std::min(least, (pose * (side / 2 * Vector(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1))).z());
    return -least;
}

/// Largest values over impacts of a cube on a floor.
struct Impacts
{
    Real gained = 0;  ///< Kinetic energy after / before - 1.
    Real balance = 0; ///< Energy with springs and heat / before - 1.
    Real overlap = 0; ///< [spacings]
};

/// One impact; see impacts().
void addImpact(Impacts& sum, Quaternion const& pose, Real speed, Real e, Real dt, Real factor)
{
    SolidScene scene;
    scene.walls = {floorMesh(1)};
    RigidBody& cube = scene.addCuboid("cube", cubeSize, 1000, {0, 0, 1e-3 + standingHeight(pose)}, pose);
    cube.setVelocity({0, 0, -speed}, Vector::Zero());
    scene.build("mu 0.3; e " + std::to_string(e) + "; impactSpeed " + std::to_string(factor * speed) + ";");
    Real const before = scene.kineticEnergy();
    std::size_t touched = 0;
    while (scene.time < 1 && (touched == 0 || scene.contact->contactCount() > 0))
    {
        scene.step(dt, 1, [&] {
            touched = std::max(touched, scene.contact->contactCount());
            sum.overlap = std::max(sum.overlap, scene.contact->maxOverlap() / scene.spacing);
        });
    }
    EXPECT_GT(touched, 0u);
    sum.gained = std::max(sum.gained, scene.kineticEnergy() / before - 1);
    sum.balance = std::max(sum.balance, std::abs(scene.energy() / before - 1));
}

/// Impacts at 0.5 to 3 m/s on face, edge, corner and askew, e 0.2 and 1. @param factor  impactSpeed over speed. @param steps  Fluid steps [s].
Impacts impacts(Real factor, std::vector<Real> const& steps)
{
    std::vector<Quaternion> const poses{Quaternion::Identity(), turned(std::numbers::pi / 4, Vector::UnitX()),
                                        Quaternion::FromTwoVectors(Vector(-1, -1, -1), -Vector::UnitZ()), turned(0.4, Vector(1, 2, 0.3))};
    Impacts sum;
    for (Quaternion const& pose : poses)
        for (Real const speed : {0.5, 1.0, 3.0})
            for (Real const e : {0.2, 1.0})
                for (Real const dt : steps) addImpact(sum, pose, speed, e, dt, factor);
    return sum;
}

} // namespace

// Standing on an edge or a corner under its centre, a cube without friction or spin carries its weight there: the edge and corner points
// alone, no double force.
TEST(SolidContact, cubeStandsOnEdgeAndCorner)
{
    std::vector<std::pair<std::string, Quaternion>> const poses{
        {"face", Quaternion::Identity()},
        {"edge", turned(std::numbers::pi / 4, Vector::UnitX())},
        {"corner", Quaternion::FromTwoVectors(Vector(-1, -1, -1), -Vector::UnitZ())}};
    for (auto const& [name, pose] : poses)
    {
        SolidScene scene;
        scene.gravity = Vector(0, 0, -g);
        scene.walls = {cutPlane("floor", {-1, -1, 0}, {1, 1, 0}, 50)};
        RigidBody& cube = scene.addCuboid("cube", cubeSize, 1000, {0, 0, standingHeight(pose)}, pose);
        scene.build("mu 0.3; e 0.1;");
        for (int i = 0; i < 100; ++i) scene.step(1e-3);
        expectBelow("cube on its " + name + ", force / weight - 1", cube.meanContactNormal().force.z() / (8 * g) - 1, 1e-3);
        expectBelow("cube on its " + name + ", overlap / spacing", scene.contact->maxOverlap() / scene.spacing, 5e-3);
        expectBelow("cube on its " + name + ", speed [m/s]", cube.velocity().norm(), 1e-3);
    }
}

// Impact at 0.5 to 3 m/s on face, edge and corner, elastic and not: no energy is gained. Where impactSpeed is the speed of the impact, the
// rule for the stiffness (PairStiffness.h) lets a corner sink in by 0.05 spacings: the bound is that of the rule.
TEST(SolidContact, impactsGainNoEnergy)
{
    Impacts const found = impacts(1, {5e-4, 2e-3});
    expectBelow("impacts of a cube, largest relative gain of kinetic energy", found.gained, 1e-3);
    expectBelow("impacts of a cube, energy budget, relative", found.balance, 1e-2);
    expectBelow("impacts of a cube, largest overlap / spacing", found.overlap, 0.051);
}

// An impactSpeed of five times the speed of the impact keeps the overlap below 0.01 spacings, in 5 times as many sub-steps: at 3 m/s fluid
// steps of 2 ms would need more than the 2000 that are allowed.
TEST(SolidContact, impactsOfAFifthOfImpactSpeedSinkInByAHundredth)
{
    Impacts const found = impacts(5.05, {1e-4, 5e-4});
    expectBelow("impacts of a cube, impactSpeed 5.05 v, relative gain of kinetic energy", found.gained, 1e-3);
    expectBelow("impacts of a cube, impactSpeed 5.05 v, largest overlap / spacing", found.overlap, 0.01);
}

// Overlap 0.0500 spacings with impactSpeed v, 0.0167 with 3 v (1.7 times the processor time of the test), 0.0100 with 5 v (2.5 times). The sub-steps
// go with impactSpeed; with 5 v cubes at 3 m/s need 3141 of them in a fluid step of 2 ms, which is refused.
TEST(SolidContact, DISABLED_impactsSinkInByAHundredth)
{
    expectBelow("impacts of a cube, largest overlap / spacing", impacts(1, {5e-4, 2e-3}).overlap, 0.01);
}

// Two cubes meet off their centres in 3-D; momentum and angular momentum stay.
TEST(SolidContact, bodiesExchangeMomentum)
{
    SolidScene scene;
    RigidBody& a = scene.addCuboid("a", {0.2, 0.1, 0.15}, 2700, {-0.16, 0, 0}, turned(0.05, Vector(1, 1, 0)));
    RigidBody& b = scene.addCuboid("b", {0.1, 0.1, 0.1}, 1000, {0.0101, 0.03, 0.02}, turned(0.3, Vector(0, 1, 1)));
    a.setVelocity({1, 0.1, 0}, {0, 0, 1});
    b.setVelocity({-0.5, 0, 0.1}, {1, 0, 0});
    scene.build("mu 0.4; e 0.5;");
    auto const momentum = [&] { return Vector(a.mass() * a.velocity() + b.mass() * b.velocity()); };
    auto const angular = [&] {
        Vector sum = Vector::Zero();
        for (RigidBody const* body : scene.pointers)
            sum += body->mass() * body->centre().cross(body->velocity()) + body->inertia() * body->angularVelocity();
        return sum;
    };
    Vector const p = momentum(), l = angular();
    Real const energy = scene.energy();
    std::size_t touched = 0;
    for (int i = 0; i < 400; ++i)
    {
        scene.step(1e-4);
        touched = std::max(touched, scene.contact->contactCount());
    }
    EXPECT_GT(touched, 0u);
    EXPECT_LT(a.velocity().x(), 0.9);
    expectBelow("two cuboids, relative change of momentum", (momentum() - p).norm() / a.mass(), 1e-12);
    expectBelow("two cuboids, relative change of angular momentum", (angular() - l).norm() / a.mass(), 1e-6);
    expectBelow("two cuboids, energy budget, relative", scene.energy() / energy - 1, 0.01);
}

// A cube on a cube on a cube stands still for 10 s; each contact carries what stands on it.
TEST(SolidContact, threeStackedCubesStandStill)
{
    SolidScene scene;
    scene.gravity = Vector(0, 0, -g);
    scene.spacing = 0.05;
    scene.walls = {cutPlane("floor", {-1, -1, 0}, {1, 1, 0}, 20)};
    for (int i = 0; i < 3; ++i)
        scene.addCuboid("cube" + std::to_string(i), cubeSize, 1000, {0.013 * i, -0.007 * i, side * (i + 0.5)},
                        turned(0.1 * i, Vector::UnitZ()));
    scene.build("mu 0.5; e 0.1; impactSpeed 0.1;");
    auto const places = [&] {
        std::vector<Vector> centres;
        for (RigidBody const* cube : scene.pointers) centres.push_back(cube->centre());
        return centres;
    };
    auto const moved = [&](std::vector<Vector> const& from) {
        Real most = 0;
        for (std::size_t i = 0; i < from.size(); ++i) most = std::max(most, (scene.pointers[i]->centre() - from[i]).norm());
        return most;
    };
    std::vector<Vector> const start = places();
    for (int i = 0; i < 600; ++i) scene.step(5e-3);
    std::vector<Vector> const settled = places();
    Real energy = 0;
    for (int i = 0; i < 1400; ++i)
    {
        scene.step(5e-3);
        energy = std::max(energy, scene.kineticEnergy());
    }
    Real carried = 0;
    for (ContactPair const& pair : scene.contact->pairs())
        if (pair.parts().other < 0)
            for (Contact const& contact : pair.contacts()) carried += contact.normalForce.z();
    expectBelow("three cubes, displacement in 10 s / spacing", moved(start) / scene.spacing, 0.02);
    expectBelow("three cubes, displacement from 3 to 10 s [m]", moved(settled), 1e-6);
    expectBelow("three cubes, largest kinetic energy / (weight x spacing)", energy / (24 * g * scene.spacing), 1e-9);
    expectBelow("three cubes, force of the floor / weight of all - 1", carried / (24 * g) - 1, 1e-6);
}

} // namespace mpsDem::test
