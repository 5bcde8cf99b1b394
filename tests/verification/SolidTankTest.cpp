// Still water in 3-D: a channel with a ramp of 45 degrees.

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

void writeTank(RunCase& run)
{
    run.threeDimensions();
    run.write("system/setParticlesDict",
              "geometry { basin { type polyline; points ((-0.3 1 0) (0.7 0 0) (1.4 0 0) (1.4 1 0)); zRange (0 0.4); sideWalls yes; } }\n"
              "regions ( boxToParticle { box (-0.3 0 0) (1.4 0.6 0.4); } );\n");
}

/// Root mean square of the error of the pressure over the last half of 0.6 s, over rho g H.
StillWater rampTank(Real spacing)
{
    RunCase run(spacing);
    writeTank(run);
    run.fixedSteps(0.6, 0.04 * spacing).make();
    StillWater water(0.6, {1.0, 0.2, 0.2}, 0.3);
    run.run([&](Scene const& scene, Step const& step) { water.observe(scene, step); });
    return water;
}

} // namespace

TEST(SolidTank, holdsTheHydrostaticPressure)
{
    StillWater const coarse = rampTank(0.1), fine = rampTank(0.05);
    expectBelow("3-D tank with ramp, 6 rows: pressure RMS", coarse.fluid.mean(), 0.05);
    expectBelow("3-D tank with ramp, 12 rows: pressure RMS", fine.fluid.mean(), 0.015);
    expectBelow("3-D tank with ramp, 12 rows: wall pressure RMS", fine.wall.mean(), 0.02);
    Real const order = std::log2(coarse.fluid.mean() / fine.fluid.mean());
    expectBetween("3-D tank with ramp: observed order", order, 0.7, 3);
}

// The rows of the start dissolve along the ramp within a second; the water must neither swell nor shrink by it.
TEST(SolidTank, keepsItsVolumeWhenTheLatticeDissolves)
{
    RunCase run(0.05);
    writeTank(run);
    run.fixedSteps(1.2, 2.5e-3).make();
    Real const before = potentialEnergy((run.start(), run.scene()));
    Series after;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time > 0.6) after.add(potentialEnergy(scene));
    });
    expectBelow("3-D tank with ramp, 12 rows: change of its potential energy", after.mean() / before - 1, 0.003);
}

} // namespace mpsDem::test
