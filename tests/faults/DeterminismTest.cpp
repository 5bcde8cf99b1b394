#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// The same program run twice writes the same bytes.

namespace {

using namespace mpsDem::test;

void expectSameResults(WedgeCase const& first, WedgeCase const& second)
{
    auto const a = first.results(), b = second.results();
    EXPECT_EQ(a.size(), b.size());
    int differing = 0;
    for (auto const& [name, content] : a)
    {
        bool const same = b.count(name) != 0 && b.at(name) == content;
        EXPECT_TRUE(same) << name << " differs";
        differing += !same;
    }
    std::printf("%-48s %14.6g  bound %g\n", "files compared byte by byte", static_cast<double>(a.size()), 20.0);
    std::printf("%-48s %14.6g  bound %g\n", "files that differ", static_cast<double>(differing), 0.0);
}

/// Runs two cases that are alike.
void runBoth(WedgeCase const& first, WedgeCase const& second)
{
    for (WedgeCase const* testCase : {&first, &second})
    {
        testCase->makeParticles();
        ASSERT_EQ(testCase->run().exitCode, 0);
    }
}

TEST(Determinism, TwoRunsWithFluidWriteTheSameBytes)
{
    WedgeCase const first, second;
    runBoth(first, second);
    ASSERT_GE(first.results().size(), 20u);
    expectSameResults(first, second);
}

TEST(Determinism, TwoRunsInThreeDimensionsWriteTheSameBytes)
{
    SpaceWedgeCase const first, second;
    runBoth(first, second);
    expectSameResults(first, second);
}

TEST(Determinism, TwoDryRunsWriteTheSameBytes)
{
    DryWedgeCase const first, second;
    runBoth(first, second);
    expectSameResults(first, second);
}

TEST(Determinism, ARunOverAnOldOneWritesTheSameBytesAgain)
{
    WedgeCase const testCase;
    testCase.makeParticles();
    ASSERT_EQ(testCase.run().exitCode, 0);
    auto const before = testCase.results();
    testCase.remove("checkpoint");
    testCase.remove("postProcessing");
    ASSERT_EQ(testCase.run().exitCode, 0);
    EXPECT_TRUE(testCase.results() == before);
}

TEST(Determinism, ThreadsAskedForByTheEnvironmentChangeNothing)
{
    WedgeCase const first, second;
    first.makeParticles();
    second.makeParticles();
    ASSERT_EQ(first.run().exitCode, 0);
    ::setenv("OMP_NUM_THREADS", "4", 1);
    ::setenv("LC_ALL", "de_DE.UTF-8", 1);
    ProgramResult const result = second.run();
    ::unsetenv("OMP_NUM_THREADS");
    ::unsetenv("LC_ALL");
    ASSERT_EQ(result.exitCode, 0) << result.error;
    expectSameResults(first, second);
}

} // namespace
