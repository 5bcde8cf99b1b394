// A box full of water, without a free surface: eq 8 has no Dirichlet value at all, and the pressure is known but for a constant.

#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// Straight line through (y, p) by least squares.
struct Line
{
    Real slope = 0, offset = 0, deviation = 0;
};

Line fit(ParticleSet const& particles)
{
    Real n = 0, y = 0, p = 0, yy = 0, yp = 0;
    for (int const i : particles.fluid())
    {
        Real const yi = particles.r[i].y(), pi = particles.p[i];
        n += 1;
        y += yi;
        p += pi;
        yy += yi * yi;
        yp += yi * pi;
    }
    Line line;
    line.slope = (n * yp - y * p) / (n * yy - y * y);
    line.offset = (p - line.slope * y) / n;
    Real squares = 0;
    for (int const i : particles.fluid())
    {
        Real const error = particles.p[i] - line.offset - line.slope * particles.r[i].y();
        squares += error * error;
    }
    line.deviation = std::sqrt(squares / n);
    return line;
}

} // namespace

TEST(ClosedBox, pressureIsHydrostaticWithoutAFreeSurface)
{
    RunCase run(0.025);
    run.write("system/setParticlesDict", "geometry { box { type searchableBox; min (0 0 0); max (0.5 0.5 0); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.5 0.5 0); } );\n"
                                         "lattice { jitter 0.1; }");
    run.write("system/mpsSchemes", "sourceSchemes { relaxationTime 0.1; }"); // with the default of 0.05 s the energy is 0.109 J/m
    run.fixedSteps(2, 1e-3).make();
    Series slope, deviation, energy;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 1) return;
        Line const line = fit(scene.particles());
        slope.add(line.slope / (-1000 * 9.81) - 1);
        deviation.add(line.deviation / (1000 * 9.81 * 0.5));
        energy.add(kineticEnergy(scene));
    });
    expectBelow("closed box: mean pressure gradient, relative error", slope.mean(), 0.02);
    expectBelow("closed box: RMS of p about its line / rho g H", deviation.mean(), 0.02);
    expectBelow("closed box: kinetic energy [J/m]", energy.largest(), 0.1);
    expectBelow("closed box: particles lost", static_cast<Real>(run.scene().fluid()->escaped()), 0);
}

} // namespace mpsDem::test
