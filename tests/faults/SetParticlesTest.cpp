#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/Errors.h"
#include "io/OutputFile.h"
#include "scene/InitialState.h"
#include "support/SmallCase.h"

namespace {

using namespace mpsDem;
using test::SmallCase;

/// One wrong file of the small case and what must be said about it. Lines count from the top of the file, the content begins at 4.
struct Fault
{
    std::string what; ///< For the name of the failure.
    std::string file, content;
    std::vector<std::string> said; ///< Pieces of the message.
};

std::string const bed = "geometry { bed { type polyline; points ((-0.2 1.2 0) (1 0 0) (2 0 0) (2 1.2 0)); } }\n";
std::string const water = "regions ( boxToParticle { box (-0.2 0 0) (2 1 0); } );\n";

std::string body(std::string const& shape, std::string const& rest = "density 2000;")
{
    return "bodies { slide { shape { " + shape + " } " + rest + " } }";
}

std::vector<Fault> const faults{
    {"negative spacing", "constant/particleProperties", "spacing -0.05;", {"constant/particleProperties:4", "spacing"}},
    {"spacing of zero", "constant/particleProperties", "spacing 0;", {"constant/particleProperties:4", "spacing"}},
    {"spacing missing", "constant/particleProperties", "thickness 1;", {"constant/particleProperties", "spacing"}},
    {"four dimensions", "constant/particleProperties", "dimensions 4; spacing 0.05;", {"constant/particleProperties:4", "dimensions 4"}},
    {"thickness in 3-D",
     "constant/particleProperties",
     "dimensions 3; spacing 0.05; thickness 1;",
     {"constant/particleProperties:4", "thickness"}},
    {"a line in 3-D", "constant/particleProperties", "dimensions 3; spacing 0.05;", {"system/setParticlesDict:4", "zRange"}},
    {"unknown key", "constant/particleProperties", "spacing 0.05; spacin 0.1;", {"constant/particleProperties:4", "spacin"}},
    {"spacing larger than the walls", "constant/particleProperties", "spacing 50;", {"system/setParticlesDict:4", "less than the spacing"}},
    {"spacing larger than the body",
     "constant/particleProperties",
     "spacing 0.45;",
     {"constant/rigidBodyProperties:4", "less than the spacing"}},
    {"density with dimensions of viscosity",
     "constant/transportProperties",
     "nu 1e-6; rho [0 2 -1 0 0 0 0] 1000;",
     {"constant/transportProperties:4"}},
    {"negative density", "constant/transportProperties", "rho -1;", {"constant/transportProperties:4", "rho is not positive"}},
    {"no density", "constant/transportProperties", "nu 1e-6;", {"constant/transportProperties", "rho"}},
    {"gravity with dimensions of velocity", "constant/g", "dimensions [0 1 -1 0 0 0 0]; value (0 -10 0);", {"constant/g:4", "m/s2"}},
    {"gravity out of the plane", "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -10);", {"constant/g:4", "x-y plane"}},
    {"wall of a raster in 2-D",
     "system/setParticlesDict",
     "geometry { bed { type rasterSurface; file bed.asc; } }\n" + water,
     {"system/setParticlesDict:4", "surface type \"rasterSurface\" in a case of two dimensions", "dimensions 3", "polyline"}},
    {"wall of an STL file in 2-D",
     "system/setParticlesDict",
     "geometry { bed { type triSurfaceMesh; file bed.stl; } }\n" + water,
     {"system/setParticlesDict:4", "surface type \"triSurfaceMesh\" in a case of two dimensions", "dimensions 3"}},
    {"strip in 2-D",
     "system/setParticlesDict",
     "geometry { bed { type polyline; points ((0 0 0) (1 0 0));\n zRange (0 1); } }\n" + water,
     {"system/setParticlesDict:5", "zRange in a case of two dimensions", "dimensions 3"}},
    {"channel in 2-D",
     "system/setParticlesDict",
     "geometry { bed { type polyline; points ((0 0 0) (1 0 0)); sideWalls yes; } }\n" + water,
     {"system/setParticlesDict:4", "sideWalls in a case of two dimensions", "dimensions 3"}},
    {"front of a box in 2-D",
     "system/setParticlesDict",
     "geometry { tank { type searchableBox; min (0 0 0); max (2 1 0); open (front); } }\n" + water,
     {"system/setParticlesDict:4", "side \"front\" in a case of two dimensions", "dimensions 3"}},
    {"region of a surface in 2-D",
     "system/setParticlesDict",
     bed + "regions ( surfaceToParticle { file water.stl; } );",
     {"system/setParticlesDict:5", "region \"surfaceToParticle\" in a case of two dimensions", "dimensions 3"}},
    {"body of an STL file in 2-D",
     "constant/rigidBodyProperties",
     body("type triSurfaceMesh; file slide.stl;"),
     {"constant/rigidBodyProperties:4", "shape \"triSurfaceMesh\" in a case of two dimensions", "dimensions 3", "polygon"}},
    {"velocity out of the plane",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0 0 0) (1 1 0); fieldValues ( volVectorFieldValue U (0 0 1) ); } );",
     {"system/setParticlesDict:5", "U leaves the x-y plane", "dimensions 3"}},
    {"velocity of a body out of the plane",
     "constant/rigidBodyProperties",
     body("type box; min (1 0.4 0); max (1.2 0.6 0);", "density 2000; velocity (0 0 1);"),
     {"constant/rigidBodyProperties:4", "velocity is against the constraints", "2-D"}},
    {"unknown region",
     "system/setParticlesDict",
     bed + "regions ( boxToPartcle { box (0 0 0) (1 1 0); } );",
     {"system/setParticlesDict:5", "boxToPartcle", "did you mean boxToParticle?"}},
    {"region without a particle",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0 0 0) (0.01 0.01 0); } );",
     {"system/setParticlesDict:5", "holds no particle"}},
    {"region behind the wall",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (-0.2 -1 0) (0 -0.5 0); } );",
     {"system/setParticlesDict:5", "within bodies or behind walls"}},
    {"region inside the body",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0.5 0.65 0) (0.58 0.75 0); } );",
     {"system/setParticlesDict:5", "within bodies or behind walls"}},
    {"region beyond all limits",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0 0 0) (1e6 1e6 0); } );",
     {"system/setParticlesDict:5", "cells of the lattice"}},
    {"NaN in a box",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0 0 0) (nan 1 0); } );",
     {"system/setParticlesDict:5", "nan"}},
    {"box of one corner",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0 0 0); } );",
     {"system/setParticlesDict:5", "box"}},
    {"unknown surface type",
     "system/setParticlesDict",
     "geometry { bed { type polylin; points ((0 0 0) (1 0 0)); } }\n" + water,
     {"system/setParticlesDict:4", "polylin", "did you mean polyline?"}},
    {"unknown surface",
     "system/setParticlesDict",
     bed + water + "walls ( { surface bedd; } );",
     {"system/setParticlesDict:6", "bedd", "did you mean bed?"}},
    {"unknown side", "system/setParticlesDict", bed + water + "walls ( { surface bed; side up; } );", {"system/setParticlesDict:6", "up"}},
    {"wall thinner than the kernel",
     "system/setParticlesDict",
     bed + water + "walls ( { surface bed; thickness 0.05; } );",
     {"system/setParticlesDict:6", "thinner than the kernel"}},
    {"two walls of one name",
     "system/setParticlesDict",
     bed + water + "walls ( { surface bed; } { surface bed; } );",
     {"system/setParticlesDict:6", "two walls"}},
    {"closed surface that crosses itself",
     "system/setParticlesDict",
     "geometry { bed { type polyline; closed true; points ((0 0 0) (2 1 0) (2 0 0) (0 1 0)); } }\n" + water,
     {"system/setParticlesDict:4", "crosses itself"}},
    {"surface of one point",
     "system/setParticlesDict",
     "geometry { bed { type polyline; points ((0 0 0)); } }\n" + water,
     {"system/setParticlesDict:4", "two or more"}},
    {"coinciding points",
     "system/setParticlesDict",
     "geometry { bed { type polyline; points ((0 0 0) (0 0 0)); } }\n" + water,
     {"system/setParticlesDict:4", "coincide"}},
    {"surface out of the plane",
     "system/setParticlesDict",
     "geometry { bed { type polyline; points ((0 0 0) (1 0 1)); } }\n" + water,
     {"system/setParticlesDict:4", "x-y plane"}},
    {"unknown entry", "system/setParticlesDict", bed + water + "regionss ();", {"system/setParticlesDict:6", "regionss"}},
    {"unknown entry of a region",
     "system/setParticlesDict",
     bed + "regions ( boxToParticle { box (0 0 0) (1 1 0); radius 1; } );",
     {"system/setParticlesDict:5", "radius"}},
    {"jitter of a spacing", "system/setParticlesDict", bed + water + "lattice { jitter 1; }", {"system/setParticlesDict:6", "jitter"}},
    {"polygon that crosses itself",
     "constant/rigidBodyProperties",
     body("type polygon; points ((1 0.4 0) (1.5 0.8 0) (1.5 0.4 0) (1 0.8 0));"),
     {"constant/rigidBodyProperties:4", "crosses itself"}},
    {"polygon without area",
     "constant/rigidBodyProperties",
     body("type polygon; points ((1 0.4 0) (1.5 0.9 0) (1.2 0.6 0));"),
     {"constant/rigidBodyProperties:4", "no area"}},
    {"unknown shape",
     "constant/rigidBodyProperties",
     body("type polygone; points ((1 0.4 0) (1.5 0.8 0) (1.5 0.4 0));"),
     {"constant/rigidBodyProperties:4", "polygone", "did you mean polygon?"}},
    {"body without mass",
     "constant/rigidBodyProperties",
     body("type box; min (1 0.4 0); max (1.2 0.6 0);", ""),
     {"constant/rigidBodyProperties:4", "mass"}},
    {"unknown key of a body",
     "constant/rigidBodyProperties",
     body("type box; min (1 0.4 0); max (1.2 0.6 0);", "density 1000; colour red;"),
     {"constant/rigidBodyProperties:4", "colour"}},
    {"body in the floor",
     "constant/rigidBodyProperties",
     body("type box; min (1.2 -0.1 0); max (1.5 0.2 0);"),
     {"constant/rigidBodyProperties:4", "reaches 0.1 m into wall \"bed\""}},
    {"floor's corner in the body",
     "constant/rigidBodyProperties",
     body("type box; min (1.9 -0.2 0); max (2.2 0.2 0);"),
     {"constant/rigidBodyProperties:4", "into wall \"bed\""}},
    {"two bodies overlap",
     "constant/rigidBodyProperties",
     "bodies { a { shape { type box; min (1.2 0.2 0); max (1.5 0.5 0); } density 2000; }\n"
     "b { shape { type box; min (1.4 0.4 0); max (1.7 0.7 0); } density 2000; } }",
     {"constant/rigidBodyProperties:5", "\"a\" and \"b\" overlap by 0.1 m"}},
    {"a copy in the place of a body",
     "constant/rigidBodyProperties",
     "bodies { a { shape { type box; min (1.2 0.2 0); max (1.5 0.5 0); } density 2000; }\n"
     "b { shape { type box; min (1.2 0.2 0); max (1.5 0.5 0); } density 2000; } }",
     {"constant/rigidBodyProperties:5", "\"a\" and \"b\" both hold the place"}},
    {"body with a wall's name",
     "constant/rigidBodyProperties",
     "bodies { bed { shape { type box; min (1.2 0.2 0); max (1.5 0.5 0); } density 2; } }",
     {"constant/rigidBodyProperties:4", "both called \"bed\""}},
    {"kernel radius of 20", "system/mpsSchemes", "kernel { laplacian 20; }", {"system/mpsSchemes:4", "laplacian"}},
};

TEST(SetParticlesFaults, EachWrongEntryIsNamedWithItsPlace)
{
    for (Fault const& fault : faults)
    {
        SmallCase const testCase;
        testCase.write(fault.file, fault.content, fault.file == "constant/g" ? "uniformDimensionedVectorField" : "dictionary");
        std::string message = "accepted";
        ExitCode code = ExitCode::Done;
        try
        {
            SceneDefinition const definition = readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
            static_cast<void>(makeInitialScene(definition));
        }
        catch (CaseError const& error)
        {
            message = error.what();
            code = error.code();
        }
        EXPECT_EQ(code, ExitCode::BadInput) << fault.what;
        for (std::string const& piece : fault.said)
            EXPECT_NE(message.find(piece), std::string::npos) << fault.what << "\n  " << piece << "\n" << message;
        EXPECT_FALSE(std::filesystem::exists(testCase.root() / "0")) << fault.what;
    }
    std::printf("%-48s %14.6g  bound %g\n", "wrong inputs named with their place", static_cast<double>(faults.size()), 40.0);
}

TEST(SetParticlesFaults, MissingFilesAreNamed)
{
    for (char const* file :
         {"constant/particleProperties", "constant/transportProperties", "system/setParticlesDict", "system/controlDict"})
    {
        SmallCase const testCase;
        testCase.remove(file);
        try
        {
            static_cast<void>(readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict"));
            ADD_FAILURE() << file;
        }
        catch (CaseError const& error)
        {
            EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
        }
    }
}

TEST(SetParticlesFaults, AbsentEffectsAreNoFaults)
{
    SmallCase const testCase;
    testCase.remove("constant/rigidBodyProperties");
    testCase.remove("constant/g");
    SceneDefinition const definition = readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
    EXPECT_EQ(makeInitialScene(definition).particles.p[0], 0);

    SmallCase const dry;
    dry.remove("constant/transportProperties");
    dry.write("system/setParticlesDict", bed);
    EXPECT_EQ(makeInitialScene(readSceneDefinition(CaseFolder(dry.root()), "system/setParticlesDict")).particles.fluid().size(), 0);
}

/// Exit code of the application in a case.
int runApplication(SmallCase const& testCase, std::string const& options = "")
{
    std::string const command = std::string("'") + MPSDEM_BIN_DIR + "/setParticles' -case '" + testCase.root().string() + "' " + options +
                                " > '" + (testCase.root() / "log").string() + "' 2>&1";
    int const status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(SetParticlesFaults, ParticlesThatWouldNotFitACheckpointAreRefused)
{
    SmallCase const testCase;
    ASSERT_EQ(runApplication(testCase), 0);
    std::string const before = readBytes(testCase.root() / "0" / "state.0");
    ASSERT_EQ(runApplication(testCase), 0); // again, as setFields
    EXPECT_EQ(readBytes(testCase.root() / "0" / "state.0"), before);

    std::filesystem::create_directories(testCase.root() / "checkpoint" / "10");
    testCase.write("constant/particleProperties", "spacing 0.1;");
    EXPECT_EQ(runApplication(testCase), 2);
    EXPECT_EQ(readBytes(testCase.root() / "0" / "state.0"), before);
    EXPECT_EQ(runApplication(testCase, "-overwrite"), 0);
    EXPECT_NE(readBytes(testCase.root() / "0" / "state.0"), before);
    EXPECT_FALSE(std::filesystem::exists(testCase.root() / "checkpoint"));
}

TEST(SetParticlesFaults, WhatDoesNotFitIntoTheMemoryIsRefusedBeforeItIsLaidOut)
{
    SmallCase const fine;
    fine.write("constant/particleProperties", "spacing 1e-6;");
    EXPECT_EQ(runApplication(fine), 8);
    std::string const log = readBytes(fine.root() / "log");
    EXPECT_NE(log.find("particles (fluid 1.5e+12, "), std::string::npos) << log; // 2 m2 less the ramp's 0.5
    EXPECT_NE(log.find("file: constant/particleProperties.spacing at line 4."), std::string::npos) << log;
    EXPECT_FALSE(std::filesystem::exists(fine.root() / "0"));
}

TEST(SetParticlesFaults, ARegionThatReachesOutOfTheTankIsWarnedOf)
{
    SmallCase const testCase;
    testCase.write("system/setParticlesDict", bed + "regions ( boxToParticle { box (-0.2 0 0) (6 1 0); } );");
    EXPECT_EQ(runApplication(testCase), 0);
    std::string const log = readBytes(testCase.root() / "log"); // 6.2 m2, a spacing beside the wall belongs to it
    EXPECT_NE(log.find("reach out of the walls: of about 3.1 m3, 1.9"), std::string::npos) << log;
    EXPECT_EQ(log.find("Warning"), log.rfind("Warning"));

    SmallCase const ramp; // takes a quarter of the region, and that is meant
    EXPECT_EQ(runApplication(ramp), 0);
    EXPECT_EQ(readBytes(ramp.root() / "log").find("reach out"), std::string::npos);
}

TEST(SetParticlesFaults, WallsInMillimetresAmongMetresAreWarnedOf)
{
    std::string const question = "are the lengths of geometry and regions in the same unit, metres?";
    auto const logOf = [](std::string const& points, std::string const& region) {
        SmallCase const testCase;
        testCase.remove("constant/rigidBodyProperties");
        testCase.write("system/setParticlesDict", "geometry { bed { type polyline; points (" + points + "); } }\n" +
                                                      "regions ( boxToParticle { box (0 0 0) (" + region + " 0); } );");
        EXPECT_EQ(runApplication(testCase), 0);
        return readBytes(testCase.root() / "log");
    };
    std::string const huge = logOf("(0 1200 0) (0 0 0) (2000 0 0) (2000 1200 0)", "2 1");
    EXPECT_NE(huge.find("times as large as the fluid: " + question), std::string::npos) << huge;
    std::string const large = logOf("(0 90 0) (0 0 0) (90 0 0) (90 90 0)", "1 1");
    EXPECT_NE(large.find("times those of the fluid, 400: " + question), std::string::npos) << large;
    EXPECT_EQ(logOf("(0 1.2 0) (0 0 0) (2 0 0) (2 1.2 0)", "2 1").find(question), std::string::npos);
    EXPECT_EQ(logOf("(0 1.2 0) (0 0 0) (20 0 0) (20 1.2 0)", "0.4 0.4").find(question), std::string::npos) << "a long dry flume";
}

// What mpsDemFoam would refuse is refused before anything is written, with the place; a dictionary that is absent is no fault.
TEST(SetParticlesFaults, DictionariesOfTheRunAreCheckedBeforeAnythingIsWritten)
{
    for (auto const& [file, content, said] : std::vector<std::array<std::string, 3>>{
             {"constant/transportProperties", "nuu 1e-6; rho 1000;", "did you mean nu?"},
             {"constant/transportProperties", "nu nan; rho 1000;", "nan"},
             {"constant/transportProperties", "nu -1; rho 1000;", "nu is negative"},
             {"constant/contactProperties", "mu -1;", "mu"},
             {"system/controlDict", "endTime 1; deltaT -1;", "deltaT"},
             {"system/controlDict", "endTime 1; deltaT 1e-3; functions { a { type proves; } }", "did you mean probes?"},
             {"system/mpsSchemes", "kernell { }", "did you mean kernel?"},
             {"system/mpsSolution", "solvers { p { tolerance 0; } }", "tolerance"}})
    {
        SmallCase const testCase;
        testCase.write(file, content);
        EXPECT_EQ(runApplication(testCase), 2) << file << ": " << content;
        std::string const log = readBytes(testCase.root() / "log");
        for (std::string const& piece : {said, "file: " + file, std::string("at line 4.")})
            EXPECT_NE(log.find(piece), std::string::npos) << piece << '\n' << log;
        EXPECT_FALSE(std::filesystem::exists(testCase.root() / "0")) << file;
        EXPECT_FALSE(std::filesystem::exists(testCase.root() / "postProcessing")) << file;
    }
}

TEST(SetParticlesFaults, AFullDiskLeavesNothingBehind)
{
    SmallCase const testCase;
    for (char const* blocks : {"1", "60"}) // of 512 bytes: in the state, in the files for ParaView
    {
        std::string const command = std::string("ulimit -f ") + blocks + "; exec '" + MPSDEM_BIN_DIR + "/setParticles' -case '" +
                                    testCase.root().string() + "' > /dev/null 2>&1";
        int const status = std::system(command.c_str());
        EXPECT_EQ(WEXITSTATUS(status), 5) << blocks;
        for (char const* left : {"0", "0.part", ".mpsDem.lock"})
            EXPECT_FALSE(std::filesystem::exists(testCase.root() / left)) << left << blocks;
    }
}

TEST(SetParticlesFaults, AWrongCaseLeavesTheOldState)
{
    SmallCase const testCase;
    ASSERT_EQ(runApplication(testCase), 0);
    std::string const before = readBytes(testCase.root() / "0" / "state.0");
    testCase.write("system/setParticlesDict", bed + "regions ( boxToParticle { box (0 0 0) (0.01 0.01 0); } );");
    EXPECT_EQ(runApplication(testCase), 2);
    EXPECT_EQ(readBytes(testCase.root() / "0" / "state.0"), before);
    std::string const log = readBytes(testCase.root() / "log");
    EXPECT_NE(log.find("--> FOAM FATAL IO ERROR: "), std::string::npos);
    EXPECT_NE(log.find("file: system/setParticlesDict.regions"), std::string::npos) << log;
    EXPECT_NE(log.find("at line 5."), std::string::npos) << log;
    EXPECT_EQ(runApplication(testCase, "-foo"), 2);
    EXPECT_EQ(runApplication(testCase, "-help"), 0);
}

} // namespace
