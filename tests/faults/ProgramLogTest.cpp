#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

#include "io/CaseLock.h"
#include "support/ProgramRun.h"

/// What the programs tell, where they tell it, and what they leave behind.

namespace {

using namespace mpsDem;
using namespace mpsDem::test;

int countOf(std::string const& text, std::string const& piece)
{
    int count = 0;
    for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + piece.size())) ++count;
    return count;
}

/// Steps 0 to 20 of the wedge with checkpoints at 0.02 and 0.04 s.
void runShortly(WedgeCase const& testCase)
{
    testCase.replace("system/controlDict", "writeInterval 0.05", "writeInterval 0.02");
    testCase.setEndTime("0.04");
    testCase.makeParticles();
    ASSERT_EQ(testCase.run().exitCode, 0);
}

TEST(ProgramLog, AWarningStandsInTheLogAndOnStandardErrorOnce)
{
    WedgeCase const testCase;
    runShortly(testCase);
    std::string const damaged = "checkpoint/" + std::to_string(testCase.checkpoints().back());
    std::filesystem::resize_file(testCase.root() / damaged / "state.0", 100);
    testCase.setEndTime("0.05");
    ProgramResult const result = testCase.run(); // standard output and standard error are two files
    EXPECT_EQ(result.exitCode, 0) << result.error;
    for (std::string const& text : {result.output, result.error})
    {
        EXPECT_EQ(countOf(text, "--> FOAM Warning : "), 1) << text;
        EXPECT_NE(text.find(damaged + " is not used"), std::string::npos) << text;
    }
    std::string const both = (testCase.root() / "both").string();
    std::string const command = "'" + std::string(MPSDEM_BIN_DIR) + "/mpsDemFoam' -dry-run -case '" + testCase.root().string() + "'";
    std::filesystem::resize_file(testCase.root() / ("checkpoint/" + std::to_string(testCase.checkpoints().back())) / "state.0", 100);
    ASSERT_EQ(std::system((command + " > '" + both + "' 2>&1").c_str()), 0);
    EXPECT_EQ(countOf(contentOf(both), "checkpoint/" + std::to_string(testCase.checkpoints().back()) + " is not used"), 1);
}

TEST(ProgramLog, ADryRunTakesNoLockAndWritesNothing)
{
    WedgeCase const testCase;
    runShortly(testCase);
    testCase.append("system/controlDict", "startFrom startTime;\n"); // a run would begin its series of files anew
    auto const before = testCase.results();
    {
        CaseLock const lock(testCase.root());
        ProgramResult const result = testCase.run({"-dry-run"});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_EQ(testCase.run().exitCode, 4);
    }
    EXPECT_TRUE(testCase.results() == before);
    EXPECT_FALSE(std::filesystem::exists(testCase.root() / ".mpsDem.lock"));
}

TEST(ProgramLog, NoRunLeavesItsLock)
{
    WedgeCase const testCase;
    testCase.makeParticles();
    EXPECT_FALSE(std::filesystem::exists(testCase.root() / ".mpsDem.lock"));
    testCase.append("system/controlDict", "unknownKey 1;\n");
    EXPECT_EQ(testCase.run().exitCode, 2);
    EXPECT_FALSE(std::filesystem::exists(testCase.root() / ".mpsDem.lock"));
}

TEST(ProgramLog, AChangeOfTheInputIsToldAtARestart)
{
    std::string const told = "Changed since this state was saved: ";
    WedgeCase const testCase;
    runShortly(testCase);
    std::string const manifest = contentOf(testCase.root() / "checkpoint" / std::to_string(testCase.checkpoints().back()) / "MANIFEST");
    EXPECT_NE(manifest.find("inputHash system/controlDict "), std::string::npos) << manifest;
    EXPECT_EQ(testCase.run({"-dry-run"}).output.find(told), std::string::npos);

    testCase.append("constant/contactProperties", "// only a comment\n");
    testCase.setEndTime("0.0400000001"); // ten digits: more than the printed form has
    testCase.replace("constant/contactProperties", "0.01", "0.02");
    ProgramResult const changed = testCase.run({"-dry-run"});
    EXPECT_EQ(changed.exitCode, 0) << changed.error;
    EXPECT_NE(changed.output.find(told + "system/controlDict, constant/contactProperties\n"), std::string::npos) << changed.output;

    testCase.append("system/controlDict", "startFrom startTime;\n");
    testCase.append("system/setParticlesDict", "lattice { seed 2; }\n");
    std::string const initial = testCase.run({"-dry-run"}).output;
    EXPECT_NE(initial.find(told + "system/setParticlesDict\n    run setParticles again"), std::string::npos) << initial;
}

TEST(ProgramLog, AnotherSpacingThanThatOfTheParticlesIsRefused)
{
    for (char const* spacing : {"0.03", "0.04", "0.0501", "0.06", "0.2"})
    {
        WedgeCase const testCase;
        testCase.makeParticles();
        testCase.replace("constant/particleProperties", "0.05", spacing);
        ProgramResult const result = testCase.run();
        EXPECT_EQ(result.exitCode, 2) << spacing << result.output;
        EXPECT_NE(result.error.find("does not fit the particles"), std::string::npos) << spacing << result.error;
    }
}

// Not that of the first state alone: a checkpoint tells what it was made for, too.
TEST(ProgramLog, AnotherSpacingOrThicknessThanThatOfTheCheckpointIsRefused)
{
    WedgeCase const testCase;
    testCase.makeParticles();
    ASSERT_EQ(testCase.run().exitCode, 0);
    testCase.replace("constant/particleProperties", "thickness 0.5", "thickness 0.55");
    ProgramResult result = testCase.run();
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.error.find("thickness 0.55 m does not fit"), std::string::npos) << result.error;
    testCase.replace("constant/particleProperties", "thickness 0.55", "thickness 0.5");
    testCase.replace("constant/particleProperties", "spacing 0.05", "spacing 0.051");
    result = testCase.run();
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.error.find("what it was when the run began"), std::string::npos) << result.error;
}

TEST(ProgramLog, EachEffectIsListedWithItsReason)
{
    WedgeCase const testCase;
    testCase.append("system/mpsSchemes", "collisionSchemes { type none; }\n");
    testCase.makeParticles();
    std::istringstream log(testCase.run({"-dry-run"}).output);
    std::string line;
    while (std::getline(log, line) && line != "Effects of this scene")
    {}
    int lines = 0;
    for (; std::getline(log, line) && !line.empty(); ++lines) EXPECT_GE(line.size(), 30 + 5 + 5) << line;
    EXPECT_GE(lines, 9);
    std::string const text = log.str();
    for (char const* piece :
         {"constant/rigidBodyProperties names slide", "off  mpsSchemes/collisionSchemes: type none", "default of schemeSet standard",
          "controlDict/functions names slide, gauges, energy, momentum", "on   constant/g gives (0 -9.81 0) m/s2",
          "off  default of schemeSet standard", "constant/transportProperties gives rho 1000 kg/m3"})
        EXPECT_NE(text.find(piece), std::string::npos) << piece << '\n' << text;
}

TEST(ProgramLog, FunctionObjectsTellWhatTheyWriteUnlessToldNotTo)
{
    WedgeCase const testCase;
    testCase.replace("system/controlDict", "type energyBudget;", "type energyBudget; log no;");
    testCase.setEndTime("0.02");
    testCase.makeParticles();
    std::string const log = testCase.run().output;
    EXPECT_EQ(countOf(log, "interfaceHeight gauges write: eta0 = "), 2) << log; // at 0.01 and 0.02 s
    EXPECT_EQ(countOf(log, "sixDoFRigidBodyState slide write: slide "), 4);
    EXPECT_EQ(countOf(log, "energyBudget"), 0);
    EXPECT_LT(log.rfind("\nTime = 0.02\n"), log.rfind("interfaceHeight gauges write: ")) << "it stands behind its step";
}

TEST(ProgramLog, AnEditedControlDictIsLeftAloneWhereTheRunIsNotModifiable)
{
    WedgeCase const testCase;
    testCase.append("system/controlDict", "runTimeModifiable no;\n");
    testCase.makeParticles();
    RunningProgram program("mpsDemFoam", testCase.root());
    ASSERT_TRUE(program.waitFor("\nTime = ", 5));
    testCase.setEndTime("0.06");
    testCase.append("system/controlDict", "stopAt writeNow;\n");
    ProgramResult const result = program.wait();
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.output.find("\nTime = 0.3\n"), std::string::npos);
    EXPECT_EQ(result.output.find("Re-read"), std::string::npos);
}

TEST(ProgramLog, TheBillTellsClockAndProcessorApart)
{
    WedgeCase const testCase;
    testCase.setEndTime("0.02");
    testCase.makeParticles();
    std::string const log = testCase.run().output;
    std::istringstream bill(log.substr(log.find("Cost of the time loop")));
    std::string line;
    double clock = 0, processor = 0, share = 0, sum = 0;
    while (std::getline(bill, line) && line.find("effect ") == std::string::npos)
    {
        std::istringstream numbers(line.substr(std::min<std::size_t>(44, line.size())));
        if (!(numbers >> clock >> processor >> share)) continue;
        EXPECT_LE(processor, clock + 0.011) << line;
        if (line.find(" total ") == std::string::npos) sum += share;
    }
    EXPECT_NE(log.find("clock s   processor s   share %"), std::string::npos) << log.substr(log.find("Cost of"));
    EXPECT_GT(processor, 0) << "of the line `total`, the last";
    EXPECT_EQ(share, 100);
    EXPECT_NEAR(sum, 100, 0.2) << "of stages and the rest";
}

TEST(ProgramLog, OptionsOfOpenFoamThatAreNotThereTellWhatToDoInstead)
{
    WedgeCase const testCase;
    for (auto const& [option, instead] : {std::pair{"-parallel", "runs on one rank"},
                                          {"-time", "startFrom and startTime of system/controlDict"},
                                          {"-latestTime", "startFrom and startTime of system/controlDict"},
                                          {"-postProcess", "name them in system/controlDict"}})
    {
        ProgramResult const result = testCase.run({option});
        EXPECT_EQ(result.exitCode, 2) << option;
        EXPECT_NE(result.error.find(std::string("Invalid option: ") + option + "\n"), std::string::npos) << result.error;
        EXPECT_NE(result.error.find(instead), std::string::npos) << result.error;
    }
}

TEST(ProgramLog, AFileThatIsNotThereHasOneExitCode)
{
    WedgeCase const testCase;
    EXPECT_EQ(runProgram("postGauges", testCase.root()).exitCode, 2); // no system/postGaugesDict
    EXPECT_EQ(runProgram("setParticles", testCase.root(), {"-dict", "system/nope"}).exitCode, 2);
    EXPECT_EQ(runProgram("mpsDictionary", testCase.root(), {"nope"}).exitCode, 2);
    testCase.remove("constant/particleProperties");
    EXPECT_EQ(testCase.run().exitCode, 2);
}

TEST(ProgramLog, TimesThatAreNoneAreRefusedBeforeAnythingIsDrawn)
{
    WedgeCase const testCase;
    testCase.write("system/postGaugesDict", "plots { a { type curves; } }\n");
    ProgramResult const result = runProgram("postGauges", testCase.root(), {"-time", "abc"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.error.find("-time: \"abc\" in \"abc\" is no time"), std::string::npos) << result.error;
}

} // namespace
