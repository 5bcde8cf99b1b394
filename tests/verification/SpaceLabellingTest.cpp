// Labelling of walls (DBL) in 3-D: walls that the water does not reach are dry, cost no unknown, and get wet when it comes.

#include <algorithm>
#include <cmath>
#include <string>

#include "pressure/PressureEquation.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real spacing = 0.05;

/// A column of water of `length` by 0.4 m by 0.4 m in an open box of 1 m by `height` by 0.4 m.
RunCase& column(RunCase& run, Real length, Real height)
{
    run.threeDimensions();
    run.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (1 " + std::to_string(height) +
                                             " 0.4); open (top); } }\nregions ( boxToParticle { box (0 0 0) (" + std::to_string(length) +
                                             " 0.4 0.4); } );\n");
    return run;
}

/// Distance of the nearest fluid particle from a wall particle [spacings], and of the nearest right in front of it (within 53 degrees).
struct Nearest
{
    Real any = 1e300, inFront = 1e300;
};

Nearest nearest(ParticleSet const& particles, int wall)
{
    Nearest found;
    for (int const j : particles.fluid())
    {
        Vector const r = particles.r[j] - particles.r[wall];
        Real const distance = r.norm() / spacing;
        found.any = std::min(found.any, distance);
        if (r.dot(particles.normal[wall]) > 0.6 * r.norm()) found.inFront = std::min(found.inFront, distance);
    }
    return found;
}

/// What the labels of one run showed. A label is of the positions at the start of the step, from which a particle moves up to 0.25 spacings.
struct Seen
{
    long dry = 0;                     ///< Particle-steps of walls without fluid within two spacings.
    int dryButWet = 0;                ///< Of them, those labelled wet.
    Real dryPressure = 0;             ///< Largest |p| of them [Pa].
    long near = 0;                    ///< Particle-steps of walls with fluid in front within 1.2 spacings.
    int nearButDry = 0;               ///< Of them, those labelled dry.
    Real endWall = 0;                 ///< Largest p of the wall x = 1 m [Pa].
    Real reached = -1;                ///< Time at which a particle of that wall gets wet first [s].
    int wetAtStart = 0, wetAtEnd = 0; ///< Of the wall x = 1 m.

    void observe(ParticleSet const& particles, Step const& step)
    {
        wetAtEnd = 0;
        for (int const i : particles.wall())
        {
            bool const wet = particles.wet[i] != 0;
            Nearest const fluid = nearest(particles, i);
            if (fluid.any > 2)
            {
                ++dry;
                dryButWet += wet;
                dryPressure = std::max(dryPressure, std::abs(particles.p[i]));
            }
            if (fluid.inFront < 1.2)
            {
                ++near;
                nearButDry += !wet;
            }
            if (particles.normal[i].x() > -0.9) continue;
            wetAtEnd += wet;
            endWall = std::max(endWall, particles.p[i]);
        }
        if (reached < 0 && wetAtEnd > 0) reached = step.time;
        if (step.time < 0.1) wetAtStart += wetAtEnd;
    }
};

/// Unknowns of eq 8 for the labels of the last step.
int unknowns(Scene const& scene)
{
    ParticleSet const& particles = scene.particles();
    NeighbourList neighbours(scene.fluid()->neighbours().radii(), false);
    neighbours.update(particles);
    Real const radius = neighbours.radii().gradient;
    ReferenceConstants const constants = scene.fluid()->fluid().gradientConstants();
    PressureSource const source(Dictionary(), SchemeSet::Standard, particles.lattice(), radius, 1000);
    PressureEquation equation(Dictionary::fromText("tolerance 1e-6;"), source, nullptr, particles.lattice(), 1000, constants, constants);
    equation.assemble(particles, neighbours, PeriodicImages());
    return equation.unknowns();
}

} // namespace

// A column collapses: at every fifth step each wall particle is held against the fluid around it.
TEST(SpaceLabelling, wallsGetWetWhenWaterComesAndAreDryWithoutIt)
{
    RunCase run(spacing);
    column(run, 0.4, 0.8).control(0.6, 2e-3).make();
    Seen seen;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.number % 5 == 0) seen.observe(scene.particles(), step);
    });
    ASSERT_GT(seen.dry, 1000);
    ASSERT_GT(seen.near, 1000);
    expectBelow("DBL in 3-D: walls without fluid within two spacings labelled wet", seen.dryButWet, 0);
    expectBelow("DBL in 3-D: largest |p| of them [Pa]", seen.dryPressure, 0);
    expectBelow("DBL in 3-D: walls with fluid right in front labelled dry, share", Real(seen.nearButDry) / Real(seen.near), 1e-3);
    expectBelow("DBL in 3-D: wet particles of the far wall in the first 0.1 s", seen.wetAtStart, 0);
    // The front of a column on a dry floor moves at most at 2 sqrt(g h): 0.6 m take at least 0.15 s.
    expectBetween("DBL in 3-D: the water reaches the far wall at [s]", seen.reached, 0.15, 0.45);
    EXPECT_GT(seen.wetAtEnd, 10);
    expectBetween("DBL in 3-D: largest p of the far wall / rho g h", seen.endWall / (1000 * 9.81 * 0.4), 0.3, 20);
}

// A wall above the water costs no row of the pressure equation, however high it is.
TEST(SpaceLabelling, dryWallsAddNoUnknown)
{
    int count[2] = {0, 0}, walls[2] = {0, 0};
    for (int const k : {0, 1})
    {
        RunCase run(spacing);
        column(run, 1, k == 0 ? 0.8 : 3.2).fixedSteps(0.02, 2e-3).make();
        run.run();
        count[k] = unknowns(run.scene());
        walls[k] = run.particles().wall().size();
    }
    EXPECT_GT(count[0], 1000);
    EXPECT_GT(walls[1], 2 * walls[0]);
    std::printf("wall particles %d, %d; unknowns %d, %d\n", walls[0], walls[1], count[0], count[1]);
    expectBelow("DBL in 3-D: unknowns with dry walls four times as high, difference", count[1] - count[0], 0);
}

} // namespace mpsDem::test
