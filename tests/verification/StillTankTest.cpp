// Water 0.5 m deep in a tank 0.4 m wide at spacing 0.02 m must stay still with p = rho g h.

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real depth = 0.5;
constexpr Real width = 0.4;
constexpr Real spacing = 0.02;

RunCase& tank(RunCase& run, Real jitter = 0)
{
    return run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.1 0) (0 0 0) (0.4 0 0) (0.4 1.1 0)); } }\n"
                                                "regions ( boxToParticle { box (0 0 0) (0.4 0.5 0); } );\n"
                                                "lattice { jitter " +
                                                    std::to_string(jitter) + "; }");
}

StillWater gauge(Real from) { return StillWater(depth, Vector(0.5 * width, 0.1 * depth, 0), from); }

std::int64_t limited(RunCase const& run) { return run.scene().fluid()->fluid().limited(); }

} // namespace

TEST(StillTank, staysStill)
{
    RunCase run(spacing);
    tank(run).fixedSteps(4, 1e-3).make();
    StillWater water = gauge(2);
    run.run([&](Scene const& scene, Step const& step) { water.observe(scene, step); });
    expectBelow("still tank: RMS of p / rho g H", water.fluid.mean(), 0.012);
    expectBelow("still tank: RMS of p on walls / rho g H", water.wall.mean(), 0.012);
    expectBelow("still tank: sensor bias", water.sensorBias(), 0.01);
    expectBelow("still tank: sensor standard deviation", water.sensorNoise(), 0.005);
    expectBelow("still tank: kinetic energy [J/m]", water.kineticEnergy.largest(), 0.1);
    expectBelow("still tank: limited accelerations", static_cast<Real>(limited(run)), 0);
}

TEST(StillTank, standsAStepOfThreeMilliseconds)
{
    RunCase run(spacing);
    tank(run).fixedSteps(4, 3e-3).make();
    StillWater water = gauge(2);
    run.run([&](Scene const& scene, Step const& step) { water.observe(scene, step); });
    expectBelow("still tank, dt 3 ms: RMS of p / rho g H", water.fluid.mean(), 0.015);
    expectBelow("still tank, dt 3 ms: limited accelerations", static_cast<Real>(limited(run)), 0);
}

TEST(StillTank, settlesFromAJitteredStart)
{
    for (Real const jitter : {0.1, 0.2, 0.3})
    {
        RunCase run(spacing);
        tank(run, jitter).fixedSteps(1.5, 1e-3).make();
        StillWater water = gauge(1);
        run.run([&](Scene const& scene, Step const& step) { water.observe(scene, step); });
        expectBelow("still tank, jitter " + std::to_string(jitter).substr(0, 4) + ": RMS of p / rho g H", water.fluid.mean(), 0.012);
    }
}

// The error of the pressure must not grow with time.
TEST(StillTankGate, doesNotGrowNoisier)
{
    RunCase run(spacing);
    tank(run).fixedSteps(10, 1e-3).make();
    StillWater early = gauge(2), late = gauge(8);
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 4) early.observe(scene, step);
        late.observe(scene, step);
    });
    expectBelow("still tank: RMS at 8-10 s over that at 2-4 s", late.fluid.mean() / early.fluid.mean(), 1.2);
    expectBelow("still tank: RMS of p / rho g H at 8-10 s", late.fluid.mean(), 0.012);
}

} // namespace mpsDem::test
