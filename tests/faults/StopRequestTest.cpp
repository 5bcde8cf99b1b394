#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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

/// The log of the case behind the place where it tells that controlDict was read again, after an edit at step 20.
std::string logAfterEdit(std::vector<std::pair<std::string, std::string>> const& edits, std::string const& told)
{
    WedgeCase const testCase;
    testCase.makeParticles();
    RunningProgram program("mpsDemFoam", testCase.root());
    EXPECT_TRUE(program.waitFor("\nTime = ", 20));
    std::string text = contentOf(testCase.root() / "system/controlDict");
    for (auto const& [before, after] : edits) text.replace(text.find(before), before.size(), after);
    std::ofstream(testCase.root() / "system/controlDict.new") << text; // at once: half a file would be read as one
    std::filesystem::rename(testCase.root() / "system/controlDict.new", testCase.root() / "system/controlDict");
    ProgramResult const result = program.wait();
    EXPECT_EQ(result.exitCode, done) << told << result.error;
    std::size_t const at = result.output.find("Re-read system/controlDict: " + told);
    EXPECT_NE(at, std::string::npos) << told << '\n' << result.output.substr(0, 20000) << result.error;
    return at == std::string::npos ? "" : result.output.substr(at);
}

/// Lengths of the steps that a log tells of.
std::vector<double> stepsOf(std::string const& log)
{
    std::vector<double> steps;
    std::string const key = "\ndeltaT = ";
    for (std::size_t at = log.find(key); at != std::string::npos; at = log.find(key, at + 1))
        steps.push_back(std::stod(log.substr(at + key.size(), 30)));
    return steps;
}

TEST(StopRequest, TheLengthOfStepsIsTakenWhileRunning)
{
    std::vector<double> const shorter = stepsOf(logAfterEdit({{"maxDeltaT 0.002", "maxDeltaT 0.0008"}}, "maxDeltaT = 0.0008\n"));
    ASSERT_GT(shorter.size(), 100u);
    EXPECT_LE(*std::max_element(shorter.begin(), shorter.end()), 0.0008);

    std::vector<double> const fixed = stepsOf(logAfterEdit({{"adjustTimeStep yes", "adjustTimeStep no"}, {"deltaT 0.001", "deltaT 0.0009"}},
                                                           "deltaT = 0.0009, adjustTimeStep = no\n"));
    ASSERT_GT(fixed.size(), 100u);
    EXPECT_TRUE(std::all_of(fixed.begin(), fixed.end() - 1, [](double dt) { return dt == 0.0009; })) << "the last meets the end";
}

TEST(StopRequest, WritingIsTakenWhileRunningAndWhatIsNotIsTold)
{
    std::string const log = logAfterEdit({{"purgeWrite 0;", "purgeWrite 3; redoSteps { active no; }"},
                                          {"startTime 0;", "startTime 0.001; timePrecision 4;"},
                                          {"deltaT 0.001;", "deltaT 0.0011;"},
                                          {"type energyBudget;", "type energyBudget; log no;"}},
                                         "timePrecision = 4, purgeWrite = 3, redoSteps\n");
    EXPECT_NE(log.find("    changed, but read at a start only: startTime, deltaT, functions\n"), std::string::npos) << log.substr(0, 300);
    EXPECT_NE(log.find("energyBudget energy write"), std::string::npos);
    std::size_t const last = log.rfind("\nTime = 0.2");
    ASSERT_NE(last, std::string::npos);
    EXPECT_LE(log.find('\n', last + 1) - last - std::string("\nTime = 0.").size(), 4u) << "digits after the point";
}

TEST(StopRequest, ABrokenControlDictIsNamedAndChangesNothing)
{
    WedgeCase const unbroken;
    unbroken.makeParticles();
    ASSERT_EQ(unbroken.run().exitCode, done);
    for (std::string const edit :
         {"endTime nan;", "stopAt never;", "writeControl { ", "maxPressureCo -1;", "checkpointInterval soon;",
          "redoSteps { energyRise 2; }", "maxCoo 0.1;", "functions { slide { colour red; } }", "functions { new { type nonsense; } }"})
    {
        WedgeCase const testCase;
        testCase.makeParticles();
        RunningProgram program("mpsDemFoam", testCase.root());
        ASSERT_TRUE(program.waitFor("\nTime = ", 20));
        testCase.append("system/controlDict", edit + "\n");
        ProgramResult const result = program.wait();
        EXPECT_EQ(result.exitCode, done) << edit << '\n' << result.error;
        std::string const told = "was edited but is not valid";
        std::size_t const at = result.output.find(told);
        ASSERT_NE(at, std::string::npos) << edit;
        EXPECT_EQ(result.output.find(told, at + 1), std::string::npos) << edit << ": told twice";
        EXPECT_EQ(result.output.find("Re-read"), std::string::npos) << edit;
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
