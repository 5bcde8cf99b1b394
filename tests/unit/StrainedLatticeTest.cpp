// A lattice that is strained at constant volume: what eqs 3 and 5 make of it, and what the forms for waves do.

#include <cmath>

#include "particles/CorrectedDivergence.h"
#include "particles/NeighbourList.h"
#include "particles/NumberDensity.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real spacing = 0.1, radius = 2.1 * spacing, strain = 0.15;

/// Particles of water, drawn out by 1 + strain along x and compressed as much along y; the one at the origin has the index `middle`.
struct Strained
{
    ParticleSet particles{Lattice{2, spacing, 1}};
    NeighbourList neighbours{{radius, radius}, false};
    ReferenceConstants constants = referenceConstants(Lattice{2, spacing, 1}, radius);
    int middle = 0;

    /// @param diagonal  The lattice is turned by 45 degrees before.
    explicit Strained(bool diagonal)
    {
        Field<Vector> position;
        Real const s = diagonal ? std::sqrt(0.5) : 0, c = diagonal ? s : 1;
        for (int x = -8; x <= 8; ++x)
            for (int y = -8; y <= 8; ++y)
                position.emplace_back(spacing * (c * x - s * y) * (1 + strain), spacing * (s * x + c * y) / (1 + strain), 0);
        std::size_t const n = position.size();
        particles.assign(position, Field<Vector>(n, Vector::Zero()), Field<Real>(n, 0), Field<ParticleType>(n, ParticleType::Fluid),
                         Field<int>(n, -1), Field<Vector>(n, Vector::Zero()));
        neighbours.update(particles);
        numberDensity(particles, neighbours, constants);
        for (int i : particles.fluid())
            if (particles.r[i].norm() < particles.r[middle].norm()) middle = i;
    }

    /// The velocity (x, -y) 1/s, whose divergence is zero.
    [[nodiscard]] Vector velocity(int j) const { return {particles.r[j].x(), -particles.r[j].y(), 0}; }
};

/// The smooth density of the middle less that of the lattice.
Real smooth(Strained const& lattice)
{
    return SmoothDensity(lattice.particles.lattice(), radius)(lattice.particles, lattice.neighbours, lattice.middle) - 1;
}

} // namespace

TEST(StrainedLattice, looksDenseAlongItsRowsWithoutASmoothWeight)
{
    Strained const rows(false), diagonals(true);
    expectBetween("strain .15 along the rows: n/n0 - 1", rows.particles.n[rows.middle] - 1, 0.02, 0.04);
    expectBelow("strain .15 along the diagonals: n/n0 - 1", diagonals.particles.n[diagonals.middle] - 1, 0.005);
    expectBelow("strain .15 along the rows: smooth density - 1", smooth(rows), 0.002);
    expectBelow("strain .15 along the diagonals: smooth density - 1", smooth(diagonals), 0.002);
}

TEST(StrainedLattice, hasNoDivergenceInTheCorrectedForm)
{
    Strained const rows(false);
    auto const u = [&](int j) { return rows.velocity(j); };
    Real const plain = divergence(rows.particles, rows.neighbours, rows.constants, u, rows.middle);
    Real const corrected = correctedDivergence<2>(rows.particles, rows.neighbours, rows.constants, u, rows.middle);
    expectBetween("strain .15 along the rows: divergence of eq 5 over the rate of strain", std::abs(plain), 0.1, 1);
    expectBelow("strain .15 along the rows: corrected divergence over the rate of strain", corrected, 1e-12);
}

} // namespace mpsDem::test
