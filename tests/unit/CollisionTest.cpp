#include <gtest/gtest.h>

#include "fluid/Collision.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real spacing = 0.1;

/// What is left of a particle 0.6 spacings above the row of a wall along x, between two of its particles, and who got the rest.
struct Outcome
{
    Vector velocity;         ///< Of the particle [m/s].
    Collision::Impulse body; ///< Of the body that the wall belongs to.
    Vector walls;            ///< Impulse of fixed walls on the fluid [N s].
};

/// @param body  Number of the body that the wall belongs to; -1: fixed.
Outcome collide(std::string const& walls, Vector const& velocity, Vector const& wallVelocity, int body)
{
    Lattice const lattice{2, spacing, 1};
    Field<Vector> const position{Vector(0, 0.6 * spacing, 0), Vector(-0.4 * spacing, 0, 0), Vector(0.4 * spacing, 0, 0)};
    Field<Vector> const velocities{velocity, wallVelocity, wallVelocity};
    Vector const up = Vector::UnitY();
    ParticleSet particles(lattice);
    particles.assign(position, velocities, Field<Real>(3, 0), {ParticleType::Fluid, ParticleType::Wall, ParticleType::Wall},
                     {-1, body, body}, {Vector::Zero(), up, up});
    NeighbourList neighbours({0.21, 0.21}, false);
    neighbours.update(particles);
    Ledger ledger;
    auto const collision = Collision::read(Dictionary::fromText("restitution 0.2; " + walls), SchemeSet::Standard, lattice, 1000, ledger);
    collision->apply(particles, neighbours, PeriodicImages(), 1e-3);
    auto const reactions = collision->reactions();
    return {particles.u[*particles.fluid().begin()], reactions.empty() ? Collision::Impulse{} : reactions.front(),
            ledger.impulse("impulse/collisionWithWalls")};
}

Vector afterCollision(std::string const& walls, Vector const& velocity, Vector const& wallVelocity)
{
    return collide(walls, velocity, wallVelocity, -1).velocity;
}

/// Velocity of a particle that falls on a body from above, 0.1 spacings beside the particle of its corner, which looks sideways [m/s]. The next
/// particle of its upper side, which looks up, is 0.9 spacings beside it.
Vector afterFallOnCorner(SurfaceLabel label)
{
    Lattice const lattice{2, spacing, 1};
    Field<Vector> const position{Vector(-0.1 * spacing, 0.6 * spacing, 0), Vector::Zero(), Vector(-spacing, 0, 0)};
    Field<Vector> const velocities{Vector(0.1, -1, 0), Vector::Zero(), Vector::Zero()};
    ParticleSet particles(lattice);
    particles.assign(position, velocities, Field<Real>(3, 0), {ParticleType::Fluid, ParticleType::Wall, ParticleType::Wall}, {-1, 0, 0},
                     {Vector::Zero(), Vector::UnitX(), Vector::UnitY()});
    NeighbourList neighbours({0.21, 0.21}, false);
    neighbours.update(particles);
    int const i = *particles.fluid().begin();
    particles.surface[i] = label;
    Ledger ledger;
    auto const collision = Collision::read(Dictionary::fromText("restitution 0.2; walls normal;"), SchemeSet::Waves, lattice, 1000, ledger);
    collision->apply(particles, neighbours, PeriodicImages(), 1e-3);
    return particles.u[i];
}

} // namespace

// Splash that falls past the plane of the corner would get into the body. In the midst of water the pressure prevents it.
TEST(Collision, alongTheNormalStopsSplashThatFallsOnAnEdge)
{
    expectBelow("collision, walls normal, splash on an edge: error of u [m/s]",
                (afterFallOnCorner(SurfaceLabel::Surface) - Vector(0.1, 0.2, 0)).norm(), 1e-14);
    expectBelow("collision, walls normal, water past an edge: change of u [m/s]",
                (afterFallOnCorner(SurfaceLabel::Interior) - Vector(0.1, -1, 0)).norm(), 1e-14);
}

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

// What the particle loses, 10 kg of water, a body gets: nothing is lost between them. A fixed wall's share is in the ledger.
TEST(Collision, givesABodyWhatTheFluidLoses)
{
    Vector const before(0.3, -1, 0), still = Vector::Zero();
    Real const mass = 1000 * spacing * spacing;
    for (std::string const walls : {"walls normal;", "walls centres;"})
    {
        Outcome const free = collide(walls, before, still, 0), fixed = collide(walls, before, still, -1);
        Vector const lost = mass * (before - free.velocity);
        expectBelow("collision with a body, " + walls + " momentum missing [N s]", (free.body.linear - lost).norm(), 1e-12);
        expectBelow("collision with a wall, " + walls + " momentum missing [N s]", (fixed.walls + lost).norm(), 1e-12);
        EXPECT_TRUE(free.walls.isZero());
        EXPECT_TRUE(fixed.body.linear.isZero());
    }
    // Along the normal one particle of the wall is hit, 0.4 spacings beside the origin: moment about it x J_y.
    Outcome const one = collide("walls normal;", before, still, 0);
    expectBelow("collision with a body: error of the moment [N m s]", std::abs(one.body.moment.z()) - 0.4 * spacing * 1.2 * mass, 1e-12);
}

TEST(Collision, anUnknownDirectionIsRefused) { EXPECT_THROW(afterCollision("walls sideways;", Vector::Zero(), Vector::Zero()), CaseError); }

} // namespace mpsDem::test
