#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// The log of a run is one that programs for OpenFOAM's logs read, etc/tools/foamLog among them.

namespace {

using namespace mpsDem;
using namespace mpsDem::test;

std::vector<std::string> linesOf(std::string const& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// The log of some steps of the wedge, in the file `log` of the case.
std::string makeLog(WedgeCase const& testCase)
{
    testCase.setEndTime("0.04");
    testCase.makeParticles();
    ProgramResult const result = testCase.run();
    EXPECT_EQ(result.exitCode, 0) << result.error;
    std::ofstream(testCase.root() / "log") << result.output;
    return result.output;
}

int foamLog(WedgeCase const& testCase, std::string const& arguments)
{
    std::string const command = "cd '" + testCase.root().string() + "' && '" + MPSDEM_ETC + "/tools/foamLog' " + arguments + " > told 2>&1";
    return std::system(command.c_str());
}

TEST(FoamLog, EachStepHasTheLinesOfOpenFoamOnce)
{
    WedgeCase const testCase;
    std::vector<std::string> const lines = linesOf(makeLog(testCase));
    auto const count = [&](char const* pattern) {
        std::regex const form(pattern);
        return std::count_if(lines.begin(), lines.end(), [&](std::string const& line) { return std::regex_match(line, form); });
    };
    auto const steps = count("Time = [0-9.e+-]+");
    EXPECT_GE(steps, 20);
    for (char const* pattern :
         {"Courant Number mean: [0-9.e+-]+ max: [0-9.e+-]+", "deltaT = [0-9.e+-]+",
          "[A-Za-z]+:  Solving for p, Initial residual = [0-9.e+-]+, Final residual = [0-9.e+-]+, No Iterations [0-9]+",
          "time step continuity errors : sum local = [0-9.e+-]+, global = [0-9.e+-]+, cumulative = [0-9.e+-]+",
          "ExecutionTime = [0-9.e+-]+ s  ClockTime = [0-9.e+-]+ s"})
        EXPECT_EQ(count(pattern), steps) << pattern;
}

TEST(FoamLog, MakesATableOfEachQuantity)
{
    WedgeCase const testCase;
    std::string const log = makeLog(testCase);
    ASSERT_EQ(foamLog(testCase, "log"), 0) << contentOf(testCase.root() / "told");
    std::vector<std::string> const times = linesOf(contentOf(testCase.root() / "logs/Time_0"));
    EXPECT_GE(times.size(), 20u);
    for (std::string const name : {"deltaT", "CourantMean", "CourantMax", "p", "pFinalRes", "pIters", "contLocal", "contGlobal",
                                   "contCumulative", "executionTime", "clockTime"})
    {
        std::vector<std::string> const rows = linesOf(contentOf(testCase.root() / ("logs/" + name + "_0")));
        ASSERT_EQ(rows.size(), times.size()) << name;
        std::string const value = rows.back().substr(rows.back().find('\t') + 1);
        EXPECT_EQ(rows.back().substr(0, rows.back().find('\t')), "0.04") << name;
        EXPECT_NE(log.find(value), std::string::npos) << name << ' ' << value;
    }
}

TEST(FoamLog, RefusesWhatIsNoLog)
{
    WedgeCase const testCase;
    EXPECT_NE(foamLog(testCase, "missing"), 0);
    EXPECT_NE(contentOf(testCase.root() / "told").find("no file missing"), std::string::npos);
    EXPECT_NE(foamLog(testCase, "system/controlDict"), 0);
    EXPECT_NE(contentOf(testCase.root() / "told").find("no step"), std::string::npos);
    EXPECT_NE(foamLog(testCase, "-x log"), 0);
}

} // namespace
