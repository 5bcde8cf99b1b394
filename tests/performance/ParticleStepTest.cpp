// Cost of a particle-step of the standard scheme in 2-D: a column of water that has collapsed for a while, one core.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "core/Timers.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
constexpr bool optimised = true;
#else
constexpr bool optimised = false;
#endif

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Column of 2 a x a with a = 0.6 m, about `particles` of them, in a tank of 4 a.
void writeColumn(RunCase& run, Real spacing)
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (2.4 0 0) (2.4 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\nhydrostatic { surface 0.6; }");
    run.control(10, 0.2 * spacing).make();
}

/// Share of each stage: their clock counts other programs as well, so that shares say more than seconds.
void printStages()
{
    double sum = 0;
    for (Timers::Stage const& stage : Timers::all()) sum += stage.seconds;
    for (Timers::Stage const& stage : Timers::all())
        if (stage.calls > 0) std::printf("    %-44s %14.3g  %% of the stages\n", stage.name.c_str(), 100 * stage.seconds / sum);
}

/// Microseconds per fluid particle and step, processor time: the best of several windows, for others may use the machine as well.
void expectCost(std::string const& name, int particles, int warmUp, int windows, int steps, Real bound)
{
    if (!optimised) GTEST_SKIP() << "this build is made for other things than speed";
    Real const spacing = std::sqrt(0.72 / particles);
    RunCase run(spacing);
    writeColumn(run, spacing);
    Timers::clear();
    run.start();
    for (int k = 0; k < warmUp; ++k) run.step();
    int const count = run.particles().fluid().size();
    Real best = 1e300;
    for (int window = 0; window < windows; ++window)
    {
        double const begin = processorSeconds();
        for (int k = 0; k < steps; ++k) run.step();
        best = std::min(best, 1e6 * (processorSeconds() - begin) / (static_cast<double>(count) * steps));
    }
    printStages();
    expectBelow(name + ", " + std::to_string(count) + " particles [us per particle-step]", best, bound);
}

} // namespace

TEST(ParticleStep, costsLittleAtTenThousand) { expectCost("dam break", 10000, 150, 5, 20, 3); }

TEST(ParticleStepGate, costsLittleAtAHundredThousand) { expectCost("dam break", 100000, 100, 5, 10, 3); }

} // namespace mpsDem::test
