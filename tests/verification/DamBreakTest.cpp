// A column of 0.6 m x 0.3 m collapses into a tank of 1.61 m (geometry of Lobovsky et al. 2014).

#include <algorithm>

#include "support/RunCase.h"

namespace mpsDem::test {

TEST(DamBreak, frontReachesTheWallInTime)
{
    Real const spacing = 0.01;
    RunCase run(spacing);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.9 0) (0 0 0) (1.61 0 0) (1.61 0.9 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.6 0.3 0); } );\n");
    run.control(0.8, 1e-3).make();
    Real const energyAtStart = 1000 * 9.81 * 0.6 * 0.3 * 0.15;
    Real arrival = 0, least = 1e300, rise = 0;
    run.run([&](Scene const& scene, Step const& step) {
        ParticleSet const& particles = scene.particles();
        Real front = 0;
        for (int const i : particles.fluid())
            if (particles.n[i] > 0.3) front = std::max(front, particles.r[i].x());
        if (arrival == 0 && front >= 1.6) arrival = step.time;
        Real const energy = (kineticEnergy(scene) + potentialEnergy(scene)) / energyAtStart;
        least = std::min(least, energy);
        rise = std::max(rise, energy - least);
    });
    expectBetween("dam break: front at x = 1.6 m [s]", arrival, 0.43, 0.45);
    expectBelow("dam break: rise of the energy over its start", rise, 0.005);
    expectBelow("dam break: particles lost", static_cast<Real>(run.scene().fluid()->escaped()), 0);
    expectBelow("dam break: limited accelerations", static_cast<Real>(run.scene().fluid()->fluid().limited()), 50);
}

} // namespace mpsDem::test
