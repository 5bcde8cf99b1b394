#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// Every way to ask a run to stop saves the state, exits with 3 and lets the run go on later as if nothing had been.

namespace {

using namespace mpsDem::test;

int constexpr done = 0, stopped = 3, locked = 4;

/// The log tells at once that the request has come (not of nextWrite, which is no request but a time) and at the end what was saved.
void expectToldInTheLog(std::string const& log, std::string const& what, std::vector<int> const& checkpoints)
{
    ASSERT_FALSE(checkpoints.empty()) << what;
    std::string const saved = "the state of this step is saved: checkpoint/" + std::to_string(checkpoints.back());
    std::size_t const end = log.find("Stopped on request at time ");
    ASSERT_NE(end, std::string::npos) << what;
    EXPECT_NE(log.find(", step " + std::to_string(checkpoints.back()) + "; " + saved, end), std::string::npos) << what << '\n'
                                                                                                               << log.substr(end);
    if (what == "stopAt nextWrite") return;
    std::string const told = what.starts_with("signal") ? "Request by signal "
                             : what == "stop file"      ? "Request by the file stop"
                                                        : "Request by stopAt";
    std::size_t const request = log.find(told);
    ASSERT_NE(request, std::string::npos) << what;
    EXPECT_LT(request, end) << what;
    EXPECT_EQ(log.find("Request by ", request + 1), std::string::npos) << what << ": told twice";
    EXPECT_NE(log.find("will save its state and stop ", request), std::string::npos) << what;
}

/// Lets a run of the case reach its 20th step, asks it to stop, and compares what a restart gives with a run that nobody stopped.
void expectStopsAndGoesOn(
    std::string const& what, std::function<void(WedgeCase const&, RunningProgram const&)> const& ask,
    std::function<void(WedgeCase const&)> const& undo = [](WedgeCase const&) {})
{
    static WedgeCase const unbroken;
    if (unbroken.checkpoints().empty())
    {
        unbroken.makeParticles();
        ASSERT_EQ(unbroken.run().exitCode, done);
    }
    WedgeCase const testCase;
    testCase.makeParticles();
    RunningProgram program("mpsDemFoam", testCase.root());
    ASSERT_TRUE(program.waitFor("\nTime = ", 20)) << what;
    ask(testCase, program);
    ProgramResult const first = program.wait();
    EXPECT_EQ(first.exitCode, stopped) << what << '\n' << first.error;
    EXPECT_NE(first.output.find("\nEnd\n"), std::string::npos) << what;
    expectToldInTheLog(first.output, what, testCase.checkpoints());
    ASSERT_FALSE(testCase.checkpoints().empty()) << what << ": no state was saved";
    EXPECT_LT(testCase.checkpoints().back(), unbroken.checkpoints().back()) << what;
    undo(testCase);
    ProgramResult const second = testCase.run();
    EXPECT_EQ(second.exitCode, done) << what << '\n' << second.error;
    expectSameState(unbroken, testCase, unbroken.checkpoints().back());
}

TEST(StopRequest, SignalsSaveAndStop)
{
    for (int const signal : {SIGUSR2, SIGTERM, SIGINT})
        expectStopsAndGoesOn("signal " + std::to_string(signal), [&](WedgeCase const&, RunningProgram const& p) { p.send(signal); });
}

TEST(StopRequest, StopFileSavesAndStopsAndIsRemoved)
{
    expectStopsAndGoesOn(
        "stop file", [](WedgeCase const& c, RunningProgram const&) { std::ofstream(c.root() / "stop"); },
        [](WedgeCase const& c) { EXPECT_FALSE(std::filesystem::exists(c.root() / "stop")); });
}

TEST(StopRequest, StopAtOfAnEditedControlDictSavesAndStops)
{
    for (std::string const word : {"writeNow", "nextWrite"})
        expectStopsAndGoesOn(
            "stopAt " + word, [&](WedgeCase const& c, RunningProgram const&) { c.append("system/controlDict", "stopAt " + word + ";\n"); },
            [&](WedgeCase const& c) { c.replace("system/controlDict", "stopAt " + word + ";\n", ""); });
}

TEST(StopRequest, ClockTimeSavesAndStops)
{
    WedgeCase const testCase;
    testCase.setEndTime("1000");
    testCase.append("system/controlDict", "maxClockTime 1;\n");
    testCase.makeParticles();
    ProgramResult const result = testCase.run();
    EXPECT_EQ(result.exitCode, stopped) << result.error;
    ASSERT_FALSE(testCase.checkpoints().empty());
}

TEST(StopRequest, Usr1WritesAndGoesOn)
{
    WedgeCase const testCase;
    testCase.replace("system/controlDict", "writeInterval 0.05;", "writeInterval 1;");
    testCase.makeParticles();
    RunningProgram program("mpsDemFoam", testCase.root());
    ASSERT_TRUE(program.waitFor("\nTime = ", 20));
    program.send(SIGUSR1);
    ProgramResult const result = program.wait();
    EXPECT_EQ(result.exitCode, done) << result.error;
    // The end, and the next step at which a restart gives the same bytes.
    ASSERT_EQ(testCase.checkpoints().size(), 2u);
    int const asked = testCase.checkpoints().front();
    EXPECT_EQ(asked % 50, 0);
    EXPECT_NE(result.output.find("Request by signal USR1 received at time "), std::string::npos);
    EXPECT_NE(result.output.find(" s, checkpoint/" + std::to_string(asked) + "\n"), std::string::npos);
    std::string const series = contentOf(testCase.root() / "VTK/particles.vtp.series");
    EXPECT_NE(series.find("particles_000002.vtp"), std::string::npos) << "start, request and end are three files\n" << series;
}

TEST(StopRequest, ALongerEndTimeIsTakenWhileRunning)
{
    WedgeCase const testCase;
    testCase.makeParticles();
    RunningProgram program("mpsDemFoam", testCase.root());
    ASSERT_TRUE(program.waitFor("\nTime = ", 20));
    testCase.setEndTime("0.35");
    ProgramResult const result = program.wait();
    EXPECT_EQ(result.exitCode, done) << result.error;
    EXPECT_NE(result.output.find("Re-read system/controlDict: endTime = 0.35"), std::string::npos);
    EXPECT_NE(result.output.find("\nTime = 0.35\n"), std::string::npos);
}

TEST(StopRequest, ABrokenControlDictIsNamedAndChangesNothing)
{
    WedgeCase const unbroken;
    unbroken.makeParticles();
    ASSERT_EQ(unbroken.run().exitCode, done);
    for (std::string const edit : {"endTime nan;", "endTime -1;", "stopAt never;", "writeInterval -3;", "writeControl { ", "endTime;"})
    {
        WedgeCase const testCase;
        testCase.makeParticles();
        RunningProgram program("mpsDemFoam", testCase.root());
        ASSERT_TRUE(program.waitFor("\nTime = ", 20));
        testCase.append("system/controlDict", edit + "\n");
        ProgramResult const result = program.wait();
        EXPECT_EQ(result.exitCode, done) << edit << '\n' << result.error;
        EXPECT_NE((result.output + result.error).find("was edited but is not valid"), std::string::npos) << edit;
        expectSameState(unbroken, testCase, unbroken.checkpoints().back());
    }
}

TEST(StopRequest, ASecondRunIsKeptOut)
{
    WedgeCase const testCase;
    testCase.setEndTime("1000");
    testCase.makeParticles();
    RunningProgram first("mpsDemFoam", testCase.root());
    ASSERT_TRUE(first.waitFor("\nTime = ", 5));
    for (std::string const name : {"mpsDemFoam", "setParticles"})
    {
        ProgramResult const second = runProgram(name, testCase.root());
        EXPECT_EQ(second.exitCode, locked) << name << '\n' << second.error;
        EXPECT_NE(second.error.find("the case is in use by process"), std::string::npos) << name << '\n' << second.error;
    }
    first.send(SIGKILL);
    EXPECT_EQ(first.wait().signal, SIGKILL);
    testCase.setEndTime("0.01");
    EXPECT_EQ(testCase.run().exitCode, done) << "the lock of a killed run must not hold";
}

} // namespace
