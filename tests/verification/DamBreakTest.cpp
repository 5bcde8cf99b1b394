// A column of 0.6 m x 0.3 m collapses into a tank of 1.61 m (geometry of Lobovsky et al. 2014).

#include <algorithm>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// What is seen of one run.
struct Outcome
{
    Real arrival = 0;        ///< Of the front at x = 1.6 m [s].
    Real rise = 0;           ///< Of the energy above its lowest value before; all energies as shares of that at the start.
    Real energyAtImpact = 0; ///< At the arrival.
    Real energyAtEnd = 0;
    Real lost = 0;    ///< Particles.
    Real limited = 0; ///< Accelerations.
};

/// @param offset  Of the lattice along x [spacings].
Outcome collapse(Real endTime, Real offset)
{
    RunCase run(0.01);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.9 0) (0 0 0) (1.61 0 0) (1.61 0.9 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.6 0.3 0); } );\nlattice { offset (" +
                                             std::to_string(offset) + " 0 0); }");
    run.control(endTime, 1e-3).make();
    Real const energyAtStart = 1000 * 9.81 * 0.6 * 0.3 * 0.15;
    Outcome outcome;
    Real least = 1e300;
    run.run([&](Scene const& scene, Step const& step) {
        ParticleSet const& particles = scene.particles();
        Real front = 0;
        for (int const i : particles.fluid())
            if (particles.n[i] > 0.3) front = std::max(front, particles.r[i].x());
        Real const energy = outcome.energyAtEnd = (kineticEnergy(scene) + potentialEnergy(scene)) / energyAtStart;
        if (outcome.arrival == 0 && front >= 1.6)
        {
            outcome.arrival = step.time;
            outcome.energyAtImpact = energy;
        }
        least = std::min(least, energy);
        outcome.rise = std::max(outcome.rise, energy - least);
    });
    outcome.lost = static_cast<Real>(run.scene().fluid()->escaped());
    outcome.limited = static_cast<Real>(run.scene().fluid()->fluid().limited());
    return outcome;
}

} // namespace

// The tip is a few particles, and no two runs of it are alike: 0.440, 0.440, 0.436, 0.429 and 0.454 s.
TEST(DamBreak, frontReachesTheWallInTime)
{
    Real arrival = 0;
    int runs = 0;
    for (Real const offset : {0.0, 0.01, 0.02, 0.03, 0.04})
    {
        std::string const name = "dam break, lattice at " + std::to_string(offset).substr(0, 4) + " spacings: ";
        Outcome const outcome = collapse(0.8, offset);
        expectBetween(name + "front at x = 1.6 m [s]", outcome.arrival, 0.42, 0.46);
        expectBelow(name + "rise of the energy above its lowest, of that at the start", outcome.rise, 0.005);
        expectBelow(name + "particles lost", outcome.lost, 0);
        expectBelow(name + "limited accelerations", outcome.limited, 50);
        arrival += outcome.arrival;
        ++runs;
    }
    expectBetween("dam break, mean of five starts: front at x = 1.6 m [s]", arrival / runs, 0.43, 0.45);
}

TEST(DamBreak, givesUpEnergyInItsImpacts)
{
    Outcome const outcome = collapse(1.5, 0);
    expectBetween("dam break: energy when the front is at x = 1.6 m, of that at the start", outcome.energyAtImpact, 0.95, 1);
    expectBetween("dam break: energy at 1.5 s, of that at the start", outcome.energyAtEnd, 0.6, 0.8);
}

} // namespace mpsDem::test
