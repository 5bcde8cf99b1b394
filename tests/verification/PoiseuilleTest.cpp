// Flow between two plates driven by a body force: u = 6 U (y/h)(1 - y/h) for g = 12 nu U/h^2, after it has developed from rest:
// what is missing falls as exp(-pi^2 nu t/h^2), 0.01 % at 9 s.

#include <cmath>

#include "support/Channel.h"

namespace mpsDem::test {

namespace {

/// L2 error of u over L2 of u. Mean speed U = 1 m/s, height h = 1 m, nu = 0.1 m2/s: Reynolds number 10.
Real profileError(Real spacing)
{
    RunCase run(spacing);
    writeChannel(run);
    run.fixedSteps(10, 2.5e-3).make();
    Series error;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 9) return;
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
    return error.mean();
}

} // namespace

TEST(Poiseuille, profileIsTheParabolaOnTwentyCells) { expectBelow("Poiseuille, Re 10, 20 cells: L2 error of u", profileError(0.05), 0.02); }

TEST(Poiseuille, profileConvergesToTheParabola)
{
    Real const coarse = profileError(0.05), fine = profileError(0.025);
    expectBelow("Poiseuille, Re 10, 40 cells: L2 error of u", fine, 0.005);
    expectBetween("Poiseuille, Re 10: order of the L2 error", std::log2(coarse / fine), 1, 4);
}

} // namespace mpsDem::test
