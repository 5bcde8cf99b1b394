#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/Checkpoint.h"
#include "support/ProgramRun.h"

/// A number that is not finite stops the run within a step, names the particle or body and its place, and spoils no checkpoint.

namespace {

using namespace mpsDem;
using namespace mpsDem::test;

struct Poke
{
    std::string block;
    std::size_t index; ///< Of the number within the block.
    Real value;
    std::vector<std::string> said;
};

/// Saved states of the small wedge at 0.05 s.
WedgeCase const& sample()
{
    static WedgeCase const testCase;
    if (testCase.checkpoints().empty())
    {
        testCase.setEndTime("0.05");
        testCase.makeParticles();
        EXPECT_EQ(testCase.run().exitCode, 0);
        testCase.setEndTime("0.1");
    }
    return testCase;
}

void pokeCheckpoint(WedgeCase const& testCase, Poke const& poke)
{
    int const step = testCase.checkpoints().back();
    Checkpoint checkpoint = readCheckpoint(testCase.root() / "checkpoint" / std::to_string(step));
    State::Reals values = checkpoint.state.reals(poke.block);
    ASSERT_LT(poke.index, values.size());
    values[poke.index] = poke.value;
    checkpoint.state.set(poke.block, std::span<Real const>(values));
    writeCheckpoint(testCase.root() / "checkpoint", std::to_string(step), checkpoint.state, checkpoint.info, 0);
}

TEST(NotFinite, OneNumberOfTheStateStopsTheRunWithinAStep)
{
    Real const nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
    State const state = readCheckpoint(sample().root() / "checkpoint" / std::to_string(sample().checkpoints().back())).state;
    std::size_t const particles = state.reals("particles/pressure").size(), fluid = particles - 20;
    std::string const id = std::to_string(state.integers("particles/id")[fluid]);
    std::string const named = "particle " + id;
    std::vector<Poke> const pokes = {
        {"particles/velocity", 3 * fluid, nan, {named, "velocity"}},
        {"particles/velocity", 3 * fluid + 1, infinity, {named, "velocity"}},
        {"particles/pressure", fluid, nan, {named, "pressure"}},
        {"particles/pressure", fluid, -infinity, {named, "pressure"}},
        {"particles/position", 3 * fluid, nan, {named, "position"}},
        {"particles/position", 3 * fluid + 1, infinity, {named, "position"}},
        {"particles/position", 0, nan, {"particle", "position"}},
        {"body/slide/centre", 0, nan, {"body slide"}},
        {"body/slide/motion", 1, nan, {"body slide"}},
        {"body/slide/orientation", 0, nan, {"body slide"}},
        {"body/slide/motion", 6, infinity, {"body slide"}},
    };
    int caught = 0;
    for (Poke const& poke : pokes)
    {
        WedgeCase const testCase;
        testCase.copyFrom(sample());
        pokeCheckpoint(testCase, poke);
        auto const before = testCase.results();
        ProgramResult const result = testCase.run();
        std::string const what = poke.block + "[" + std::to_string(poke.index) + "] = " + std::to_string(poke.value);
        EXPECT_EQ(result.exitCode, 6) << what << ", signal " << result.signal << '\n' << result.error;
        EXPECT_EQ(result.output.find("\nTime = "), std::string::npos) << what << ": a step was finished";
        for (std::string const& piece : poke.said) EXPECT_NE(result.error.find(piece), std::string::npos) << what << '\n' << result.error;
        EXPECT_EQ(testCase.checkpoints(), sample().checkpoints()) << what;
        auto after = testCase.results();
        for (auto const& [name, content] : before)
            EXPECT_TRUE(!name.starts_with("checkpoint/") || after[name] == content) << what << ": " << name << " was changed";
        caught += result.exitCode == 6;
    }
    std::printf("%-48s %14.6g  bound %g\n", "pokes that end with exit code 6", static_cast<double>(caught),
                static_cast<double>(pokes.size()));
}

TEST(NotFinite, SpeedThatCannotBeSummedStopsTheRun)
{
    WedgeCase const testCase;
    testCase.copyFrom(sample());
    std::size_t const particles = readCheckpoint(testCase.root() / "checkpoint" / std::to_string(testCase.checkpoints().back()))
                                      .state.reals("particles/pressure")
                                      .size();
    pokeCheckpoint(testCase, {"particles/velocity", 3 * (particles - 20), 1e200, {}});
    ProgramResult const result = testCase.run();
    EXPECT_TRUE(result.exitCode == 6 || result.exitCode == 7) << result.exitCode << ", signal " << result.signal << '\n' << result.error;
    EXPECT_EQ(testCase.checkpoints(), sample().checkpoints());
}

TEST(SolverFailure, OneIterationAllowedEndsWithTheCause)
{
    WedgeCase const testCase;
    testCase.replace("system/mpsSolution", "tolerance 1e-6;", "tolerance 1e-6; maxIter 1;");
    testCase.makeParticles();
    ProgramResult const result = testCase.run();
    EXPECT_EQ(result.exitCode, 7) << result.error;
    for (char const* piece : {"pressure equation: no convergence", "a larger maxIter or tolerance", "particle", "at ("})
        EXPECT_NE(result.error.find(piece), std::string::npos) << piece << '\n' << result.error;
    EXPECT_TRUE(testCase.checkpoints().empty());

    // The case is as good as before: more iterations, and it runs.
    testCase.replace("system/mpsSolution", "maxIter 1;", "maxIter 500;");
    testCase.setEndTime("0.01");
    EXPECT_EQ(testCase.run().exitCode, 0);
}

} // namespace
