#include <cmath>

#include <gtest/gtest.h>

#include "fluid/VelocityDamping.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// A patch of 10 by 10 fluid particles, each a little off its place.
ParticleSet patch(Lattice const& lattice)
{
    Field<Vector> position;
    for (int j = 0; j < 10; ++j)
        for (int i = 0; i < 10; ++i)
            position.emplace_back((i + 0.1 * std::sin(7.0 * j + i)) * lattice.spacing, (j + 0.1 * std::cos(5.0 * i - j)) * lattice.spacing,
                                  0);
    std::size_t const count = position.size();
    ParticleSet particles(lattice);
    particles.assign(position, Field<Vector>(count, Vector::Zero()), Field<Real>(count, 0), Field<ParticleType>(count, ParticleType::Fluid),
                     Field<int>(count, -1), Field<Vector>(count, Vector::Zero()));
    return particles;
}

/// uStar after a step from the velocities u(r, number of the particle).
template <class Velocity>
ParticleSet damped(Velocity const& velocity)
{
    Lattice const lattice{2, 0.1, 1};
    ParticleSet particles = patch(lattice);
    for (int i : particles.fluid()) particles.uStar[i] = particles.u[i] = velocity(particles.r[i], i);
    NeighbourList neighbours({0.21, 0.21}, false);
    neighbours.update(particles);
    auto const damping = VelocityDamping::read(Dictionary::fromText("type deviation;"), SchemeSet::Standard, lattice,
                                               referenceConstants(lattice, 0.21).n0, 9.81);
    damping->addTo(particles, neighbours, PeriodicImages(), 5e-3);
    return particles;
}

} // namespace

TEST(VelocityDamping, leavesALinearFieldAlone)
{
    ParticleSet const particles = damped([](Vector const& r, int) { return Vector(0.3 + 2 * r.x() - r.y(), 1.5 * r.x() - 2 * r.y(), 0); });
    Real worst = 0;
    for (int i : particles.fluid()) worst = std::max(worst, (particles.uStar[i] - particles.u[i]).norm());
    expectBelow("velocity damping, linear field: change [m/s]", worst, 1e-13);
}

TEST(VelocityDamping, takesEnergyButNoMomentumFromANoisyOne)
{
    ParticleSet const particles = damped([](Vector const&, int i) { return Vector(std::sin(13.0 * i), std::cos(29.0 * i), 0); });
    Vector change = Vector::Zero();
    Real before = 0, after = 0;
    for (int i : particles.fluid())
    {
        change += particles.uStar[i] - particles.u[i];
        before += particles.u[i].squaredNorm();
        after += particles.uStar[i].squaredNorm();
    }
    expectBelow("velocity damping, noise: change of momentum over mass [m/s]", change.norm(), 1e-12);
    expectBetween("velocity damping, noise: energy left", after / before, 0.5, 0.95);
}

TEST(VelocityDamping, isAbsentUnlessNamed)
{
    Lattice const lattice{2, 0.1, 1};
    EXPECT_EQ(VelocityDamping::read(Dictionary(), SchemeSet::Standard, lattice, 4.9, 9.81), nullptr);
    EXPECT_NE(VelocityDamping::read(Dictionary(), SchemeSet::Waves, lattice, 4.9, 9.81), nullptr);
    EXPECT_EQ(VelocityDamping::read(Dictionary::fromText("type deviation;"), SchemeSet::Standard, lattice, 4.9, 0), nullptr);
}

} // namespace mpsDem::test
