#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// Dictionaries that were changed after setParticles: what contradicts the state is refused with its place, what does not is taken over.

namespace {

using namespace mpsDem::test;

std::string const bodies = "constant/rigidBodyProperties", setup = "system/setParticlesDict", schemes = "system/mpsSchemes",
                  transport = "constant/transportProperties";

struct Change
{
    std::string file, before, after;
    std::vector<std::string> said; ///< Pieces of the refusal; none where the change is taken over.
};

/// The wedge after the change, read from the start or from its checkpoint.
ProgramResult changed(WedgeCase const& good, Change const& change)
{
    WedgeCase const testCase;
    testCase.copyFrom(good);
    if (change.before.empty())
        testCase.remove(change.file);
    else
        testCase.replace(change.file, change.before, change.after);
    return testCase.run({"-dry-run"});
}

void expectAnswer(WedgeCase const& good, Change const& change)
{
    ProgramResult const result = changed(good, change);
    std::string const what = change.file + ": " + change.before + " -> " + change.after + '\n' + result.error;
    EXPECT_EQ(result.exitCode, change.said.empty() ? 0 : 2) << what;
    for (std::string const& piece : change.said) EXPECT_NE(result.error.find(piece), std::string::npos) << piece << '\n' << what;
}

TEST(StartChecks, WhatContradictsTheInitialStateIsRefusedWithItsPlace)
{
    WedgeCase const good;
    good.makeParticles();
    std::string const again = "or run setParticles again";
    for (Change const& change : std::vector<Change>{
             {bodies, "(0.51 0.99 0)", "(0.61 0.99 0)", {bodies, "at line 3.", "another shape or centre of mass", "corner 1", again}},
             {bodies, "(0.01 0.99 0) ", "(0.01 0.99 0) (0.25 0.75001 0) ", {bodies, "it has 4 corners, in the saved state 3"}},
             {bodies,
              "(0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)",
              "(0.02 0.99 0) (0.52 0.49 0) (0.52 0.99 0)",
              {bodies, "centre of mass at"}},
             {bodies, "mass 140;", "mass 150;", {bodies, "at line 4.", "is 150 kg, in the saved state 140 kg", again}},
             {bodies, "mass 140;", "density 1800;", {bodies, "at line 4.", "the mass of body \"slide\" is"}},
             {bodies, "mass 140;", "mass 140; momentOfInertia (9 9 9);", {bodies, "the moment of inertia of body \"slide\""}},
             {bodies, "mass 140;", "mass 140; velocity (1 0 0);", {bodies, "at line 4.", "begins with another velocity"}},
             {bodies, "mass 140;", "mass 140; releaseTime 0.1;", {bodies, "at line 4.", "is held at the start"}},
             {bodies, "", "", {bodies, "the file is missing", "has rigid bodies"}},
             {transport, "", "", {transport, "the file is missing", "has fluid"}},
             {setup, "(1.8 0 0)", "(1.7 0 0)", {setup, "wall \"bed\" is not that of the saved state", "corner 3", again}},
             {setup, "geometry { bed", "geometry { floor", {setup, "\"floor\" is not that of the saved state, \"bed\""}},
             {setup, "type polyline;", "type polyline; fluidSide right;", {setup, "the fluid lies on its other side"}},
             {schemes, "schemeSet standard;", "kernel { laplacian 3.1; }", {schemes, "the effective radius of 3.1 spacings"}},
         })
        expectAnswer(good, change);
}

TEST(StartChecks, WhatDoesNotContradictTheInitialStateIsTakenOver)
{
    WedgeCase const good;
    good.makeParticles();
    for (Change const& change : std::vector<Change>{
             {bodies, "mass 140;", "mass 1.4e2; report yes;", {}},
             {bodies,
              "mass 140;",
              "mass 140; restraints { s { sixDoFRigidBodyMotionRestraint linearSpring; anchor (0 2 0); refAttachmentPt (0.3 0.9 0);"
              " stiffness 10; damping 0; restLength 1; } }",
              {}},
             {bodies, "mass 140;", "mass 140; constraints { a { sixDoFRigidBodyMotionConstraint orientation; } }", {}},
             {setup, "hydrostatic { surface 1; }", "hydrostatic { surface 1.1; }", {}},
             {schemes, "schemeSet standard;", "kernel { laplacian 1.9; }", {}},
             {transport, "rho 1000;", "rho 1020;", {}},
         })
        expectAnswer(good, change);
}

TEST(StartChecks, ARestartKeepsItsShapesAndTakesMassesOver)
{
    WedgeCase const good;
    good.setEndTime("0.02");
    good.makeParticles();
    ASSERT_EQ(good.run().exitCode, 0);
    for (Change const& change : std::vector<Change>{
             {bodies,
              "(0.51 0.99 0)",
              "(0.61 0.99 0)",
              {bodies, "another shape or centre of mass", "or a new run: setParticles -overwrite"}},
             {bodies, "(0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)", "(0.02 0.99 0) (0.52 0.49 0) (0.52 0.99 0)", {bodies, "it began at"}},
             {schemes, "schemeSet standard;", "kernel { laplacian 3.1; }", {schemes, "the effective radius of 3.1 spacings"}},
             {bodies, "mass 140;", "mass 140; velocity (1 0 0);", {}},
             {setup, "(1.8 0 0)", "(1.7 0 0)", {}},
         })
        expectAnswer(good, change);
    ProgramResult const heavier = changed(good, {bodies, "mass 140;", "mass 150;", {}});
    EXPECT_EQ(heavier.exitCode, 0) << heavier.error;
    EXPECT_NE(heavier.error.find(bodies + ":4: the mass of body \"slide\" is 150 kg, in the saved state 140 kg"), std::string::npos)
        << heavier.error;
}

} // namespace
