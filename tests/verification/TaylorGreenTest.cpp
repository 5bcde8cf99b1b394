// Decaying vortices in a periodic box: u = sin(kx) cos(ky), v = -cos(kx) sin(ky), k = 2 pi, kinetic energy ~ exp(-4 nu k^2 t).

#include <cmath>
#include <numbers>

#include "support/RunCase.h"

namespace mpsDem::test {

TEST(TaylorGreen, energyDecaysAsTheExactSolution)
{
    Real const nu = 0.01; // Reynolds number 100 with the box of 1 m and 1 m/s
    Real const k = 2 * std::numbers::pi;
    RunCase run(0.02);
    run.gravity(Vector::Zero());
    run.write("constant/transportProperties", "nu 0.01; rho 1000;");
    run.write("system/setParticlesDict", "regions ( boxToParticle { box (0 0 0) (1 1 0); } );");
    run.write("system/mpsSchemes", "freeSurfaceSchemes { type none; } cyclic { min (0 0 0); max (1 1 0); }");
    run.fixedSteps(1, 1e-3).make([&](ParticleSet& particles) {
        for (int const i : particles.fluid())
        {
            Real const x = k * particles.r[i].x(), y = k * particles.r[i].y();
            particles.u[i] = Vector(std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y), 0);
        }
    });
    Real const exact = 0.25 * 1000 * std::exp(-4 * nu * k * k);
    Real thinnest = 1e300;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 0.5) return;
        for (int const i : scene.particles().fluid()) thinnest = std::min(thinnest, scene.particles().n[i]);
    });
    expectBelow("Taylor-Green, Re 100: energy at 1 s, relative error", kineticEnergy(run.scene()) / exact - 1, 0.04);
    expectBetween("Taylor-Green, Re 100: least n/n0 (no void)", thinnest, 0.8, 1.2);
}

} // namespace mpsDem::test
