// Hard cases of the fluid: large steps, a disordered start, clusters in flight, no free surface. Each must stay in bounds to its end.

#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

struct DamBreak
{
    std::string name, control;
    Real dt, jitter, energy, redone, momentum;
    std::string set = "standard";
};

void damBreak(DamBreak const& c)
{
    RunCase run(0.02);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (1.6 0 0) (1.6 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.6 0.3 0); } );\nlattice { jitter " +
                                             std::to_string(c.jitter) + "; }");
    run.write("system/mpsSchemes", "schemeSet " + c.set + ";");
    run.control(1.5, c.dt, c.control + budgetEntry).make();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
    expectInBand(c.name, run, watch, {.height = 0.3, .energy = c.energy, .redone = c.redone, .momentum = c.momentum});
}

// H7: single particles, a pair and a disc fly above the tank and fall into it. They have no row of eq 8, or a group of their own.
void throwClusters(std::string const& set, Real largestRise)
{
    RunCase run(0.02);
    run.write("system/mpsSchemes", "schemeSet " + set + ";");
    run.write("system/setParticlesDict",
              "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (1 0 0) (1 1.2 0)); } }\n"
              "regions ( boxToParticle { box (0 0 0) (1 0.2 0); }\n"
              " boxToParticle { box (0.2 0.5 0) (0.22 0.52 0); fieldValues ( volVectorFieldValue U (0.5 1 0) ); }\n"
              " boxToParticle { box (0.5 0.5 0) (0.54 0.52 0); fieldValues ( volVectorFieldValue U (0 1 0) ); }\n"
              " sphereToParticle { origin (0.75 0.6 0); radius 0.08; fieldValues ( volVectorFieldValue U (-0.5 0 0) ); } );");
    run.control(1, 2e-3, budgetEntry).make();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
    expectInBand("clusters in flight, " + set, run, watch, {.height = 0.6, .energy = largestRise});
}

// H13: full of water, disordered at the start, and shaken by nothing but its own noise.
void shakeFullBox(std::string const& set, Real largestEnergy)
{
    RunCase run(0.025);
    run.write("system/mpsSchemes", "schemeSet " + set + ";");
    run.write("system/setParticlesDict", "geometry { box { type searchableBox; min (0 0 0); max (0.5 0.5 0); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.5 0.5 0); } );\nlattice { jitter 0.3; }");
    run.control(2, 2e-3, budgetEntry).make();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
    std::string const name = "full box, jitter 0.3, " + set;
    expectBelow(name + ": kinetic energy at 2 s [J]", kineticEnergy(run.scene()), largestEnergy);
    expectBelow(name + ": largest speed [m/s]", watch.fastest, 2);
    expectInBand(name, run, watch, {.height = 0.5});
}

} // namespace

// The case beside which the hard ones are to be seen: its energy never rises by more than 0.5 %.
DamBreak const plain{"dam break", "", 2e-3, 0, 0.005, 0, 0.04};
TEST(ViolentFlow, damBreaks) { damBreak(plain); }

// H10: the limits of the step twice and four times as wide as by default. Energy rises by 0.9 and 1.3 % (set waves: 0.08 and 0.12 %). Without
// redo of steps, 9 of 12 runs with the longest steps and columns of 0.48 to 0.7 m lost particles through the wall; with it 2 do.
DamBreak const twice{"dam break, dt x 2", "maxCo 0.5; maxPressureCo 0.5;", 4e-3, 0, 0.02, 0.02, 0.06};
DamBreak const fourTimes{"dam break, dt x 4", "maxCo 1; maxPressureCo 1;", 8e-3, 0, 0.02, 0.15, 0.1};
TEST(ViolentFlow, standsStepsTwiceAsLong) { damBreak(twice); }
TEST(ViolentFlow, standsStepsFourTimesAsLong) { damBreak(fourTimes); }
TEST(ViolentFlow, standsLongStepsWithSetWaves)
{
    for (DamBreak one : {twice, fourTimes})
    {
        one.name += ", waves";
        one.set = "waves";
        one.energy = 0.005;
        one.momentum = one.dt > twice.dt ? 0.1 : 0.02;
        damBreak(one);
    }
}

// Measured: 0.9 and 1.3 %, of the swelling of bounds.md and of the length of the step.
TEST(ViolentFlow, DISABLED_standsLongStepsWithoutGainOfEnergy)
{
    for (DamBreak one : {twice, fourTimes})
    {
        one.energy = 0.005;
        damBreak(one);
    }
}

// H17. Energy rises by 0.4 %.
DamBreak const disordered{"dam break, jitter 0.3", "", 2e-3, 0.3, 0.005, 0, 0.04};
TEST(ViolentFlow, startsFromDisorder) { damBreak(disordered); }

TEST(ViolentFlow, startsFromDisorderWithSetWaves)
{
    DamBreak one = disordered;
    one.name += ", waves";
    one.set = "waves";
    one.momentum = 0.02;
    damBreak(one);
}

// Measured: 0.037, 0.055, 0.085 and 0.036 in 1.5 s (0.035, 0.049, 0.067 and 0.033 before the walls' collisions were counted). The surge along the floor and its run-up at the far wall are layers of a few particles:
// the forces that the corrected gradient gives them are not those that the walls' pressures sum to.
TEST(ViolentFlow, DISABLED_damBreaksKeepMomentum)
{
    for (DamBreak one : {plain, twice, fourTimes, disordered})
    {
        one.momentum = 0.02;
        damBreak(one);
    }
}

TEST(ViolentFlow, clustersFlyAndFallBack) { throwClusters("standard", 0.05); }
TEST(ViolentFlow, clustersFlyAndFallBackWithSetWaves) { throwClusters("waves", 0.005); }

// Measured: 0.024 (0.019 with `grad(p) hybrid`): where a disc hits the water, its surface gains energy for some steps, however long they
// are.
TEST(ViolentFlow, DISABLED_clustersFlyAndFallBackWithoutGainOfEnergy) { throwClusters("standard", 0.005); }

// Root mean square speed below 2 % of sqrt(g H).
TEST(ViolentFlow, fullBoxComesToRest) { shakeFullBox("standard", 0.5 * 250 * 0.02 * 0.02 * 9.81 * 0.5); }

// Measured: 0.17 J with the relaxation time of 0.05 s, 0.11 J with 0.1 s: without a free surface the density has nowhere to relax to.
TEST(ViolentFlow, DISABLED_fullBoxComesToCompleteRest) { shakeFullBox("standard", 0.1); }
TEST(ViolentFlow, fullBoxComesToCompleteRestWithSetWaves) { shakeFullBox("waves", 0.1); }

} // namespace mpsDem::test
