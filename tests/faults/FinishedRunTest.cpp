#include <gtest/gtest.h>

#include "core/Errors.h"
#include "support/ProgramRun.h"
#include "support/RunCase.h"

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
    EXPECT_EQ(again.output.find("Cost of the time loop"), std::string::npos) << "a bill of zeros";
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

// Of 800 particles, of which a thousandth is less than one: two may be lost, a third ends the run.
TEST(FinishedRun, goesOnWithoutTwoParticlesAndEndsWithoutThree)
{
    for (int const lost : {2, 3})
    {
        RunCase run(0.01);
        run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.8 0) (0 0 0) (0.4 0 0) (0.4 0.8 0)); } }\n"
                                             "regions ( boxToParticle { box (0 0 0) (0.4 0.2 0); } );\nhydrostatic { surface 0.2; }");
        run.control(0.06, 1e-3).make([&](mpsDem::ParticleSet& particles) {
            for (int k = 0; k < lost; ++k) particles.r[particles.fluid().first + 100 * k].y() = -1; // far below the floor
        });
        if (lost == 2)
        {
            run.run();
            EXPECT_EQ(run.scene().fluid()->escaped(), 2);
            continue;
        }
        try
        {
            run.run();
            ADD_FAILURE() << lost << " particles were lost";
        }
        catch (mpsDem::CaseError const& error)
        {
            EXPECT_EQ(error.code(), mpsDem::ExitCode::Solver);
            EXPECT_NE(std::string(error.what()).find("3 of 800 fluid particles were lost"), std::string::npos) << error.what();
        }
    }
}
