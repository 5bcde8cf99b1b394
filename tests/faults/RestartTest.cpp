#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/Table.h"
#include "support/ProgramRun.h"

/// A run that is broken off and continued ends with the bytes of a run that went through.

namespace {

using namespace mpsDem::test;

void print(char const* name, double value, double bound) { std::printf("%-48s %14.6g  bound %g\n", name, value, bound); }

/// Rows of all tables of one function object, header lines not among them.
std::string rowsOf(WedgeCase const& testCase, std::string const& object, std::vector<std::string> const& startTimes)
{
    std::string rows;
    for (std::string const& time : startTimes)
    {
        for (auto const& entry : std::filesystem::directory_iterator(testCase.root() / "postProcessing" / object / time))
        {
            std::istringstream text(contentOf(entry.path()));
            for (std::string line; std::getline(text, line);)
                if (!line.starts_with('#')) rows += line + '\n';
        }
    }
    return rows;
}

/// Runs to `half`, then to the end, and compares every later checkpoint with the unbroken run.
void expectContinues(WedgeCase const& unbroken, WedgeCase const& broken, std::string const& half)
{
    broken.setEndTime(half);
    ProgramResult const first = broken.run();
    ASSERT_EQ(first.exitCode, 0) << first.error;
    ASSERT_FALSE(broken.checkpoints().empty());
    int const seam = broken.checkpoints().back();
    broken.setEndTime("0.3");
    ProgramResult const second = broken.run();
    ASSERT_EQ(second.exitCode, 0) << second.error;
    EXPECT_NE(second.output.find("Reading state from checkpoint/" + std::to_string(seam)), std::string::npos);
    ASSERT_EQ(broken.checkpoints(), unbroken.checkpoints()) << "endTime " << half;
    for (int const step : unbroken.checkpoints()) expectSameState(unbroken, broken, step);
}

TEST(Restart, AtEveryWriteTimeGivesTheBytesOfTheUnbrokenRun)
{
    WedgeCase const unbroken;
    unbroken.makeParticles();
    ASSERT_EQ(unbroken.run().exitCode, 0);
    ASSERT_EQ(unbroken.checkpoints().size(), 6u);
    // 0.15 and 3 * 0.05 differ in the last bit; the latch closes between 0.25 and 0.3.
    std::vector<std::string> const halves = {"0.05", "0.1", "0.15", "0.2", "0.25"};
    for (std::string const& half : halves)
    {
        WedgeCase const broken;
        broken.makeParticles();
        expectContinues(unbroken, broken, half);
        for (char const* object : {"slide", "gauges", "energy", "momentum"})
            EXPECT_EQ(rowsOf(broken, object, {"0", half}), rowsOf(unbroken, object, {"0"})) << object << ", restart at " << half;
    }
    print("restarts compared byte by byte", static_cast<double>(halves.size()), 5);
}

TEST(Restart, AfterTheLatchKeepsItClosed)
{
    WedgeCase const unbroken, broken;
    for (WedgeCase const* testCase : {&unbroken, &broken})
    {
        testCase->replace("constant/contactProperties", "(0.56 0.44 0)", "(0.52 0.48 0)"); // hit at about 0.1 s
        testCase->makeParticles();
    }
    ProgramResult const run = unbroken.run();
    ASSERT_EQ(run.exitCode, 0) << run.error;
    ASSERT_NE(run.output.find("latch buffer: body slide locked"), std::string::npos);
    expectContinues(unbroken, broken, "0.2");
}

TEST(Restart, WithEachCouplingAndSchemeSet)
{
    for (std::string const coupling : {"weak", "lagged"})
    {
        for (std::string const scheme : {"standard", "paper"})
        {
            WedgeCase const unbroken, broken;
            for (WedgeCase const* testCase : {&unbroken, &broken})
            {
                testCase->replace("system/mpsSolution", "strong", coupling);
                testCase->replace("system/mpsSchemes", "standard", scheme);
                testCase->replace("constant/particleProperties", "0.05", "0.08");
                testCase->makeParticles();
            }
            ASSERT_EQ(unbroken.run().exitCode, 0) << coupling << ' ' << scheme;
            expectContinues(unbroken, broken, "0.15");
        }
    }
}

TEST(Restart, WithFixedStepsAndEachWriteControl)
{
    for (std::string const control : {"writeControl runTime; writeInterval 0.05;", "writeControl timeStep; writeInterval 50;"})
    {
        WedgeCase const unbroken, broken;
        for (WedgeCase const* testCase : {&unbroken, &broken})
        {
            testCase->replace("system/controlDict", "adjustTimeStep yes;", "adjustTimeStep no;");
            testCase->replace("system/controlDict", "writeInterval 0.05;", control);
            testCase->replace("constant/particleProperties", "0.05", "0.08");
            testCase->makeParticles();
        }
        ASSERT_EQ(unbroken.run().exitCode, 0);
        expectContinues(unbroken, broken, "0.15"); // 150 steps of 0.001 s add up to a little more than 0.15
    }
}

TEST(Restart, WithAlgebraicMultigrid)
{
    WedgeCase const unbroken, broken;
    for (WedgeCase const* testCase : {&unbroken, &broken})
    {
        testCase->replace("system/mpsSolution", "solver auto;", "solver PCG; preconditioner AMG;");
        testCase->replace("constant/particleProperties", "0.05", "0.08");
        testCase->makeParticles();
    }
    ProgramResult const run = unbroken.run();
    ASSERT_EQ(run.exitCode, 0) << run.error;
    ASSERT_NE(run.output.find("MueLu"), std::string::npos) << "the multigrid was not used";
    expectContinues(unbroken, broken, "0.15");
}

TEST(Restart, MayAddABudget)
{
    WedgeCase const testCase;
    std::string const budget = "    momentum { type momentumBudget; writeControl runTime; writeInterval 0.01; }\n";
    testCase.replace("system/controlDict", budget, "");
    testCase.replace("constant/particleProperties", "0.05", "0.08");
    testCase.setEndTime("0.1");
    testCase.makeParticles();
    ASSERT_EQ(testCase.run().exitCode, 0);
    testCase.replace("system/controlDict", "functions\n{\n", "functions\n{\n" + budget);
    testCase.setEndTime("0.2");
    ProgramResult const result = testCase.run();
    ASSERT_EQ(result.exitCode, 0) << result.error;
    std::filesystem::path const file = testCase.root() / "postProcessing/momentum/0.1/momentum.dat";
    EXPECT_NE(contentOf(file).find("since t = 0.1 s"), std::string::npos);
    mpsDem::Table const table = mpsDem::readTable(file);
    double largest = 0;
    for (double const share : table.column("share")) largest = std::max(largest, share);
    EXPECT_GE(table.column("share").size(), 9u);
    print("momentum budget from a restart: residual", largest, 0.02);
    EXPECT_LE(largest, 0.02);
}

TEST(Restart, InTheMiddleOfAnImpactKeepsTheContactHistory)
{
    DryWedgeCase const unbroken;
    unbroken.replace("system/controlDict", "writeInterval 0.05;", "writeInterval 0.01;");
    unbroken.makeParticles();
    ASSERT_EQ(unbroken.run().exitCode, 0);
    ASSERT_GE(unbroken.checkpoints().size(), 30u);
    // The wedge meets the ramp between 0.04 and 0.06 s, the floor between 0.22 and 0.24 s.
    for (std::string const half : {"0.04", "0.05", "0.2", "0.21", "0.22", "0.23", "0.24"})
    {
        DryWedgeCase const broken;
        broken.replace("system/controlDict", "writeInterval 0.05;", "writeInterval 0.01;");
        broken.makeParticles();
        expectContinues(unbroken, broken, half);
    }
}

TEST(Restart, InThreeDimensionsGivesTheBytesOfTheUnbrokenRun)
{
    SpaceWedgeCase const unbroken;
    unbroken.makeParticles();
    ASSERT_EQ(unbroken.run().exitCode, 0);
    ASSERT_EQ(unbroken.checkpoints().size(), 6u);
    for (std::string const half : {"0.1", "0.25"})
    {
        SpaceWedgeCase const broken;
        broken.makeParticles();
        expectContinues(unbroken, broken, half);
        for (char const* object : {"slide", "gauges", "energy", "momentum"})
            EXPECT_EQ(rowsOf(broken, object, {"0", half}), rowsOf(unbroken, object, {"0"})) << object << ", restart at " << half;
    }
}

TEST(Restart, AfterKillGoesOnFromTheNewestWholeCheckpoint)
{
    WedgeCase const unbroken;
    unbroken.makeParticles();
    ASSERT_EQ(unbroken.run().exitCode, 0);
    int const last = unbroken.checkpoints().back();
    int killed = 0;
    for (int const step : {1, 20, 26, 27, 40, 76, 77, 100, 130, 151})
    {
        WedgeCase const broken;
        broken.makeParticles();
        RunningProgram program("mpsDemFoam", broken.root());
        static_cast<void>(program.waitFor("\nTime = ", step));
        program.send(SIGKILL);
        killed += program.wait().signal == SIGKILL;
        ProgramResult const result = broken.run();
        EXPECT_EQ(result.exitCode, 0) << result.error;
        expectSameState(unbroken, broken, last);
    }
    EXPECT_GE(killed, 8);
    print("runs killed by -9 and continued bit by bit", killed, 8);
}

} // namespace
