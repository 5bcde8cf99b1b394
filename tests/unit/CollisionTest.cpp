#include <gtest/gtest.h>

#include "fluid/Collision.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real spacing = 0.1;

/// Velocity after collisions of a particle 0.6 spacings above the row of a wall along x, between two of its particles.
Vector afterCollision(std::string const& walls, Vector const& velocity, Vector const& wallVelocity)
{
    Lattice const lattice{2, spacing, 1};
    Field<Vector> const position{Vector(0, 0.6 * spacing, 0), Vector(-0.4 * spacing, 0, 0), Vector(0.4 * spacing, 0, 0)};
    Field<Vector> const velocities{velocity, wallVelocity, wallVelocity};
    Vector const up = Vector::UnitY();
    ParticleSet particles(lattice);
    particles.assign(position, velocities, Field<Real>(3, 0), {ParticleType::Fluid, ParticleType::Wall, ParticleType::Wall},
                     Field<int>(3, -1), {Vector::Zero(), up, up});
    NeighbourList neighbours({0.21, 0.21}, false);
    neighbours.update(particles);
    Ledger ledger;
    auto const collision = Collision::read(Dictionary::fromText("restitution 0.2; " + walls), SchemeSet::Standard, lattice, 1000, ledger);
    collision->apply(particles, neighbours, 1e-3);
    return particles.u[*particles.fluid().begin()];
}

} // namespace

// A particle that slips along a wall, and a wall that passes below it: nothing happens to either.
TEST(Collision, alongTheNormalLetsWaterSlip)
{
    Vector const slips(1, 0, 0), rests(0, 0, 0);
    expectBelow("collision, walls normal, slipping: change of u [m/s]", (afterCollision("walls normal;", slips, rests) - slips).norm(),
                1e-15);
    expectBelow("collision, walls normal, wall that passes: u [m/s]", afterCollision("walls normal;", rests, slips).norm(), 1e-15);
    // Balls in a row take it along: the ball behind catches up with the particle, which is 0.72 spacings away.
    Vector const pushed = afterCollision("", rests, slips);
    expectBetween("collision, walls centres, wall that passes: ux [m/s]", pushed.x(), 0.1, 1);
    expectBetween("collision, walls centres, wall that passes: uy [m/s]", pushed.y(), 0.1, 1);
}

// Two particles of the wall are within reach: the plane is hit once all the same.
TEST(Collision, alongTheNormalReversesTheNormalVelocityOnce)
{
    Vector const u = afterCollision("walls normal;", Vector(0.3, -1, 0), Vector::Zero());
    expectBelow("collision, walls normal: error of the velocity that remains [m/s]", (u - Vector(0.3, 0.2, 0)).norm(), 1e-14);
}

TEST(Collision, anUnknownDirectionIsRefused) { EXPECT_THROW(afterCollision("walls sideways;", Vector::Zero(), Vector::Zero()), CaseError); }

} // namespace mpsDem::test
