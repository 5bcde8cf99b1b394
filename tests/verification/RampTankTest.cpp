// Still water 1 m deep above a ramp of 45 degrees: pressure on an oblique wall, order of convergence, independence of the time step.

#include <algorithm>
#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

RunCase& ramp(RunCase& run)
{
    return run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (2.2 0 0) (2.2 1.6 0)); } }\n"
                                                "regions ( boxToParticle { box (-0.6 0 0) (2.2 1 0); } );\n");
}

StillWater still(Real spacing, Real dt, Real endTime)
{
    RunCase run(spacing);
    ramp(run).fixedSteps(endTime, dt).make();
    StillWater water(1, Vector(1.1, 0.1, 0), 0.5 * endTime);
    run.run([&](Scene const& scene, Step const& step) { water.observe(scene, step); });
    return water;
}

} // namespace

// 12 and 25 rows of particles fill the depth exactly.
TEST(RampTank, pressureConverges)
{
    Real const coarseSpacing = 1.0 / 12, fineSpacing = 0.04;
    StillWater const coarse = still(coarseSpacing, 4e-3, 3), fine = still(fineSpacing, 2e-3, 3);
    expectBelow("ramp, spacing 0.04: RMS of p / rho g H", fine.fluid.mean(), 0.018);
    expectBelow("ramp, spacing 0.04: sensor standard deviation", fine.sensorNoise(), 0.003);
    Real const order = std::log(coarse.fluid.mean() / fine.fluid.mean()) / std::log(coarseSpacing / fineSpacing);
    expectBetween("ramp: order of RMS from 0.083 to 0.04", order, 1, 4);
}

TEST(RampTankGate, doesNotDependOnTheTimeStep)
{
    Series rms;
    for (Real const dt : {2.5e-4, 1e-3, 4e-3})
    {
        rms.add(still(0.04, dt, 3).fluid.mean());
        std::printf("    dt = %g s: mean RMS so far %g\n", dt, rms.mean());
    }
    expectBelow("ramp, dt 0.25 to 4 ms: spread of RMS over mean", (rms.largest() - rms.least()) / rms.mean(), 0.2);
}

TEST(RampTankGate, isAccurateAtTheFinestSpacing)
{
    StillWater const fine = still(0.02, 1e-3, 2);
    expectBelow("ramp, spacing 0.02: RMS of p / rho g H", fine.fluid.mean(), 0.008);
    expectBelow("ramp, spacing 0.02: sensor standard deviation", fine.sensorNoise(), 0.003);
}

} // namespace mpsDem::test
