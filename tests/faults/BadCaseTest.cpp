#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/ProgramRun.h"

/// A wrong case is refused by the program with exit code 2; the message names file and line, and nothing is written.

namespace {

using namespace mpsDem::test;

/// One edit of the small wedge case.
struct Fault
{
    std::string file, before, after; ///< `before` empty: `after` is the whole content; both empty: the file is missing.
    int line;                        ///< Named in the message, counted from the header; 0: the file alone.
    std::string said;                ///< A piece of the message.
};

std::string const control = "system/controlDict", schemes = "system/mpsSchemes", solution = "system/mpsSolution",
                  particles = "constant/particleProperties", transport = "constant/transportProperties", gravity = "constant/g",
                  bodies = "constant/rigidBodyProperties", contact = "constant/contactProperties";

std::string const keep = "schemeSet standard;";
std::string const p = "tolerance 1e-6;";

std::vector<Fault> const faults{
    // Files that every case has.
    {control, "", "", 0, "controlDict"},
    {particles, "", "", 0, "missing"},
    // Dictionaries that cannot be read.
    {control, "endTime 0.3;", "endTime 0.3", 3, ""},
    {control, "endTime 0.3;", "endTime {", 3, ""},
    {control, "endTime 0.3;", "endTime 0.3; }", 3, ""},
    {control, "endTime 0.3;", "endTime 0.3; endTime 0.4;", 3, "endTime"},
    {schemes, keep, "schemeSet \"standard;", 2, ""},
    {schemes, keep, "kernel { type zhang;", 2, ""},
    {solution, p, "tolerance (1e-6;", 2, ""},
    {contact, "mu 0.01;", "mu 0.01; }", 2, ""},
    {transport, "nu 1e-6;", "nu 1e-6; /*", 2, ""},
    {bodies, "mass 140;", "mass 140; #calc", 4, ""},
    {particles, "spacing 0.05;", "#include \"/etc/passwd\"", 2, ""},
    // Words that nobody knows.
    {control, "endTime 0.3;", "endTime 0.3; endTim 1;", 3, "endTim"},
    {control, "endTime 0.3;", "endTime 0.3; writeControl sometimes;", 3, "sometimes"},
    {control, "endTime 0.3;", "endTime 0.3; startFrom latesTime;", 3, "did you mean latestTime?"},
    {control, "endTime 0.3;", "endTime 0.3; stopAt never;", 3, "never"},
    {control, "adjustTimeStep yes;", "adjustTimeStep maybe;", 5, "maybe"},
    {control, "type interfaceHeight;", "type interfaceHeigth;", 13, "did you mean interfaceHeight?"},
    {control, "locations ((1.2 0 0) (1.6 0 0));", "location ((1.2 0 0));", 13, "locations"},
    {control, "type energyBudget;", "type energyBudget; colour red;", 14, "colour"},
    {control, "type sixDoFRigidBodyState;", "type sixDoFRigidBodyState; bodies (slid);", 12, "slid"},
    {control, "type sixDoFRigidBodyState;", "type coded;", 12, "coded"},
    {control, "type momentumBudget; writeControl runTime;", "type momentumBudget; writeControl runtime;", 15, "did you mean runTime?"},
    {control, "endTime 0.3;", "endTime 0.3; libs (\"libFoo.so\");", 3, "libs"},
    {schemes, keep, "schemeSet standart;", 2, "did you mean standard?"},
    {schemes, keep, "kernell { }", 2, "did you mean kernel?"},
    {schemes, keep, "kernel { type wendland; }", 2, "wendland"},
    {schemes, keep, "kernel { radius 2.1; }", 2, "radius"},
    {schemes, keep, "cyclic { min (0 0 0); max (1 0 0); }", 2, "periodic borders in a case with fluid and rigid bodies"},
    {schemes, keep, "gradSchemes { grad(p) central; }", 2, "central"},
    {schemes, keep, "sourceSchemes { type mixt; }", 2, "did you mean mixed?"},
    {schemes, keep, "sourceSchemes { type density; divergence corrected; }", 2, "type density has no divergence"},
    {schemes, keep, "sourceSchemes { type divergence; density smooth; }", 2, "type divergence has no density"},
    {schemes, keep, "freeSurfaceSchemes { type cones; }", 2, "did you mean cone?"},
    {schemes, keep, "shiftingSchemes { type fick; }", 2, "fick"},
    {schemes, keep, "collisionSchemes { type pair; }", 2, "pair"},
    {schemes, keep, "viscositySchemes { type exlicit; }", 2, "did you mean explicit?"},
    {schemes, keep, "boundarySchemes { labelling dynamik; }", 2, "did you mean dynamic?"},
    {schemes, keep, "limiters { negativePressure clip; }", 2, "clip"},
    {solution, "solver auto;", "solver GAMG;", 2, "GAMG"},
    {solution, "solver auto;", "solver auto; preconditioner DIC;", 2, "DIC"},
    {solution, p, p + " toleranc 1;", 2, "toleranc"},
    {solution, "type strong;", "type stron;", 3, "did you mean strong?"},
    {solution, "contactFace dry;", "contactFace wet;", 3, "wet"},
    {solution, "contactFace dry;", "contactFace vented; faceReach 0;", 3, "faceReach"},
    {contact, "e 0.2;", "e 0.2; law hertz;", 3, "hertz"},
    {contact, "e 0.2;", "e 0.2; restitution 0.2;", 3, "restitution"},
    {contact, "e 0.2;", "e 0.2; stiffness soft;", 3, "soft"},
    {contact, "e 0.2;", "e 0.2; pairs { \"slide:bedd\" { mu 0.1; } }", 3, "bedd"},
    {contact, "normal (-1 1 0)", "normal (-1 1 1)", 4, "normal leaves the x-y plane"},
    {contact, "type latch;", "type latsch;", 4, "latch"},
    {contact, "body slide;", "body slied;", 4, "slied"},
    {transport, "nu 1e-6;", "transportModel Bingham; nu 1e-6;", 2, "Bingham"},
    {transport, "nu 1e-6;", "nu 1e-6; rhoo 1;", 2, "rhoo"},
    {bodies, "mass 140;", "mass 140; colour red;", 4, "colour"},
    {bodies, "mass 140;", "mass 140; constraints { a { sixDoFRigidBodyMotionConstraint lin; } }", 4, "lin"},
    {bodies, "mass 140;", "mass 140; restraints { a { sixDoFRigidBodyMotionRestraint spring; } }", 4, "spring"},
    // Keywords that are needed, misspelt: the line and the hint are those of the misspelt one.
    {particles, "spacing 0.05;", "spaceing 0.05;", 2, "did you mean spacing?"},
    {transport, "rho 1000;", "roh 1000;", 3, "rho"},
    {bodies, "mass 140;", "masss 140;", 4, "did you mean mass?"},
    {contact, "e 0.2;", "e 0.2; law linearSpring;", 3, "did you mean linearSpringDashpot?"},
    // Wrong dimensions.
    {particles, "spacing 0.05;", "spacing [0 1 0 0 0 0 0] 0.05;", 2, "takes no dimensions"},
    {gravity, "(0 -9.81 0)", "(0 -9.81)", 3, "3 numbers, not 2"},
    {transport, "nu 1e-6;", "nu [1 -3 0 0 0 0 0] 1e-6;", 2, "nu has the wrong dimensions"},
    {transport, "nu 1e-6;", "nu [0 2 -1 0 0 0 0 1e-6;", 2, "an exponent of the dimensions, as in [0 2 -1 0 0 0 0], is expected"},
    {transport, "nu 1e-6;", "nu 0 2] 1e-6;", 2, "nu has more than one value: 0 2 ]"},
    {transport, "nu 1e-6;", "nu #{ 1e-6 #};", 2, "nu: a number is expected, not #{ 1e-6 #}"},
    {transport, "rho 1000;", "rho [0 2 -1 0 0 0 0] 1000;", 3, "rho"},
    {gravity, "[0 1 -2 0 0 0 0]", "[0 1 -1 0 0 0 0]", 2, ""},
    // Numbers out of range, not finite or no numbers.
    {control, "endTime 0.3;", "endTime -1;", 3, "endTime"},
    {control, "endTime 0.3;", "endTime nan;", 3, "nan"},
    {control, "endTime 0.3;", "", 0, "endTime"},
    {control, "startTime 0;", "startTime 0.5;", 3, "endTime lies before startTime"},
    {control, "deltaT 0.001;", "deltaT -0.001;", 4, "deltaT"},
    {control, "deltaT 0.001;", "deltaT 0;", 4, "deltaT"},
    {control, "maxCo 0.25;", "maxCo -1;", 6, "maxCo"},
    {control, "maxDeltaT 0.002;", "maxDeltaT 0;", 7, "maxDeltaT"},
    {control, "writeInterval 0.05;", "writeInterval -0.05;", 8, "writeInterval"},
    {control, "purgeWrite 0;", "purgeWrite -1;", 9, "purgeWrite"},
    {particles, "spacing 0.05;", "spacing -0.05;", 2, "spacing is -0.05\n"},
    {particles, "spacing 0.05;", "spacing 1e400;", 2, ""},
    {particles, "thickness 0.5;", "thickness 0;", 3, "thickness"},
    {particles, "thickness 0.5;", "dimensions 4;", 3, "dimensions"},
    {particles, "thickness 0.5;", "dimensions 3;", 0, "the particles are those of a 2-D case"},
    {transport, "rho 1000;", "rho -1000;", 3, "rho"},
    {transport, "rho 1000;", "rho nan;", 3, "nan"},
    {transport, "nu 1e-6;", "nu -1e-6;", 2, "nu"},
    {gravity, "(0 -9.81 0)", "(0 nan 0)", 3, "nan"},
    {contact, "mu 0.01;", "mu -0.01;", 2, "mu"},
    {contact, "mu 0.01;", "", 0, "mu <number>;"},
    {contact, "e 0.2;", "e 1.2;", 3, "e"},
    {contact, "normal (-1 1 0)", "normal (0 0 0)", 4, "normal"},
    {bodies, "mass 140;", "mass -140;", 4, "mass"},
    {bodies, "mass 140;", "mass 140; density 2000;", 4, "density"},
    {schemes, keep, "kernel { gradient 0.5; }", 2, "gradient"},
    {schemes, keep, "collisionSchemes { restitution 2; }", 2, "restitution"},
    {solution, p, "tolerance 0;", 2, "tolerance"},
    {solution, p, "tolerance 1e-6; maxIter -5;", 2, "maxIter"},
};

/// The program has refused the case with exit code 2 and these pieces in its message.
void expectRefusal(ProgramResult const& result, std::string const& what, std::vector<std::string> const& pieces)
{
    EXPECT_EQ(result.exitCode, 2) << what << ", signal " << result.signal << '\n' << result.error;
    for (std::string const& piece : pieces)
        EXPECT_NE(result.error.find(piece), std::string::npos) << what << ", " << piece << '\n' << result.error;
}

/// Edits one file after the other of the small case and expects each to be refused by `mpsDemFoam -dry-run`.
void expectRefused(std::vector<std::string> const& files)
{
    WedgeCase const good;
    good.makeParticles();
    int refused = 0, tried = 0;
    for (Fault const& fault : faults)
    {
        if (std::find(files.begin(), files.end(), fault.file) == files.end()) continue;
        std::string const what = fault.file + ", " + fault.before + " -> " + fault.after;
        WedgeCase const testCase;
        testCase.copyFrom(good);
        if (fault.before.empty())
            testCase.remove(fault.file);
        else
            testCase.replace(fault.file, fault.before, fault.after);
        auto const before = testCase.results();
        ProgramResult const result = testCase.run({"-dry-run"});
        std::string const place = fault.line > 0 ? "at line " + std::to_string(fault.line) + "." : "";
        expectRefusal(result, what, {fault.file, fault.said, place});
        EXPECT_TRUE(testCase.results() == before) << what << ": something was written";
        refused += result.exitCode == 2;
        ++tried;
    }
    std::printf("%-48s %14.6g  bound %g\n", "wrong cases refused", static_cast<double>(refused), static_cast<double>(tried));
}

TEST(BadCase, EachFaultOfControlDictIsRefusedWithItsPlace) { expectRefused({control}); }

TEST(BadCase, EachFaultOfSchemesAndSolutionIsRefusedWithItsPlace) { expectRefused({schemes, solution}); }

TEST(BadCase, EachFaultOfBodiesAndContactsIsRefusedWithItsPlace) { expectRefused({bodies, contact}); }

TEST(BadCase, EachFaultOfParticlesFluidAndGravityIsRefusedWithItsPlace) { expectRefused({particles, transport, gravity}); }

TEST(BadCase, TheTableHoldsSixtyFaultsOfKnownFiles)
{
    std::size_t known = 0;
    for (std::string const& file : {control, schemes, solution, bodies, contact, particles, transport, gravity})
        known += static_cast<std::size_t>(std::count_if(faults.begin(), faults.end(), [&](Fault const& f) { return f.file == file; }));
    EXPECT_EQ(known, faults.size());
    EXPECT_GE(known, 60u);
}

TEST(BadCase, WithoutAnInitialStateSetParticlesIsNamed)
{
    WedgeCase const testCase;
    expectRefusal(testCase.run(), "no initial state", {"run setParticles first"});
    EXPECT_TRUE(testCase.results().empty());
}

TEST(BadCase, ANewBodyDoesNotFitAnOldState)
{
    WedgeCase const testCase;
    testCase.makeParticles();
    testCase.replace("constant/rigidBodyProperties", "slide {", "slider {");
    ProgramResult const result = testCase.run();
    EXPECT_TRUE(result.exitCode == 2 || result.exitCode == 5) << result.exitCode << ", signal " << result.signal;
    EXPECT_FALSE(result.error.empty());
}

TEST(BadCase, AFolderWithoutACaseIsRefused)
{
    mpsDem::TemporaryFolder const empty;
    for (std::string const name : {"setParticles", "mpsDemFoam"})
    {
        expectRefusal(runProgram(name, empty.path()), name, {"is no case"});
        expectRefusal(runProgram(name, empty / "missing"), name, {"does not exist"});
        EXPECT_TRUE(std::filesystem::is_empty(empty.path())) << name;
    }
    expectRefusal(runProgram("postGauges", empty / "missing"), "postGauges", {"does not exist"});
}

} // namespace
