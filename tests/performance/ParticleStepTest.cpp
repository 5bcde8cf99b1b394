// Cost of a particle-step of the standard schemes in 2-D and 3-D: a column of water that has collapsed for a while, one core.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

#include "core/Timers.h"
#include "support/Optimised.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Column of 2 a x a with a = 0.6 m, about `particles` of them, in a tank of 4 a.
void writeColumn(RunCase& run, Real spacing)
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (2.4 0 0) (2.4 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\nhydrostatic { surface 0.6; }");
    run.control(10, 0.2 * spacing).make();
}

/// The same in a channel half as wide as the column is high, of the length given [m].
void writeColumnInSpace(RunCase& run, Real spacing, std::string const& length)
{
    run.threeDimensions();
    run.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (" + length +
                                             " 1.2 0.3); open (top); } }\n"
                                             "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0.3); } );\nhydrostatic { surface 0.6; }");
    run.control(10, 0.2 * spacing).make();
}

/// Largest memory that the program had so far [bytes]; 0 where the system does not tell.
double peakMemory()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:")
        {
            double kilobytes = 0;
            status >> kilobytes;
            return 1024 * kilobytes;
        }
    return 0;
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
void measure(RunCase& run, std::string const& name, int warmUp, int windows, int steps, Real bound)
{
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

void expectCost(std::string const& name, int particles, int warmUp, int windows, int steps, Real bound)
{
    if (!optimised) GTEST_SKIP() << "this build is made for other things than speed";
    Real const spacing = std::sqrt(0.72 / particles);
    RunCase run(spacing);
    writeColumn(run, spacing);
    measure(run, name, warmUp, windows, steps, bound);
}

/// A column of 1.2 m in a channel of the length given.
void expectCostInSpace(std::string const& name, std::string const& length, int warmUp, int windows)
{
    if (!optimised) GTEST_SKIP() << "this build is made for other things than speed";
    Real const spacing = std::cbrt(1.2 * 0.6 * 0.3 / 2e5);
    double const before = peakMemory();
    RunCase run(spacing);
    writeColumnInSpace(run, spacing, length);
    measure(run, name, warmUp, windows, 5, 8);
    double const taken = peakMemory() - before;
    if (taken <= 0) GTEST_SKIP() << "the peak of memory is that of an earlier test: run this one alone";
    std::printf("    %-44s %14.6g\n", "memory [kB per fluid particle]", 1e-3 * taken / run.particles().fluid().size());
    expectBelow(name + ": memory [kB per particle]", 1e-3 * taken / run.particles().owned().size(), 1.5);
}

} // namespace

TEST(ParticleStep, costsLittleAtTenThousand) { expectCost("dam break", 10000, 150, 5, 20, 3); }

TEST(ParticleStepGate, costsLittleAtAHundredThousand) { expectCost("dam break", 100000, 100, 5, 10, 3); }

TEST(ParticleStepGate, costsLittleInSpaceAtTwoHundredThousand) { expectCostInSpace("dam break in 3-D", "2.4", 40, 4); }

TEST(ParticleStepGate, takesLittleMemoryInATankOfFewWalls) { expectCostInSpace("full tank in 3-D", "1.2", 5, 1); }

} // namespace mpsDem::test
