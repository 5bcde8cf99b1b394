#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// What is looked at and what is left alone at the end of a run.

namespace {

using namespace mpsDem::test;

} // namespace

TEST(FinishedRun, calledAgainWritesNothing)
{
    WedgeCase const wedge;
    wedge.setEndTime("0.05");
    wedge.makeParticles();
    ASSERT_EQ(wedge.run().exitCode, 0);
    auto const before = wedge.results();
    ProgramResult const again = wedge.run();
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_NE(again.output.find("nothing to run"), std::string::npos);
    EXPECT_TRUE(wedge.results() == before);
}

// Thirty steps: particles outside of the walls are taken out every fifty steps only, but looked for where fields are written.
TEST(FinishedRun, tellsParticlesThatFellThroughTheFloor)
{
    WedgeCase const wedge;
    wedge.replace("system/controlDict", "adjustTimeStep yes;", "adjustTimeStep no;");
    wedge.replace("system/controlDict", "deltaT ", "deltaT 0.03; // ");
    wedge.setEndTime("0.9");
    wedge.makeParticles();
    ProgramResult const run = wedge.run();
    EXPECT_EQ(run.exitCode, 7) << run.output.substr(run.output.size() > 2000 ? run.output.size() - 2000 : 0);
    EXPECT_NE(run.error.find("fluid particles were lost"), std::string::npos) << run.error;
    EXPECT_NE((run.output + run.error).find("Courant number above 1"), std::string::npos);
}
