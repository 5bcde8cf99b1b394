#include <cmath>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "io/MachineMemory.h"
#include "io/StlFile.h"
#include "scene/SizeEstimate.h"
#include "support/RunCase.h"
#include "support/SmallCase.h"

namespace {

using namespace mpsDem;
using test::expectBelow;
using test::SmallCase;

SceneDefinition definitionOf(SmallCase const& testCase)
{
    return readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
}

TEST(SizeEstimate, AgreesWithTheParticlesThatAreLaidOut)
{
    SmallCase const testCase;
    testCase.write("constant/particleProperties", "spacing 0.02; thickness 0.5;");
    SceneDefinition const definition = definitionOf(testCase);
    SizeEstimate const size = estimateSize(definition);
    ParticleSet const particles = makeInitialScene(definition).particles;
    int onBody = 0;
    for (int const body : particles.body) onBody += body >= 0 ? 1 : 0;
    Real const displaced = 0.08 / (0.02 * 0.02); // the wedge's area
    expectBelow("estimated fluid, relative error", size.fluid / (particles.fluid().size() + displaced) - 1, 0.05);
    expectBelow("estimated walls, relative error", size.wall / (particles.boundary().size() - onBody) - 1, 0.1);
    expectBelow("estimated body, relative error", size.body / onBody - 1, 0.1);
}

TEST(SizeEstimate, TakesEachPlaceOnceAndKnowsWhatLiesOutOfTheTank)
{
    SmallCase const testCase;
    // Two regions over each other, 3 x 1 m; 2 m of the length within the walls, of which the ramp takes 0.5 m2; thickness 0.5 m.
    testCase.write("system/setParticlesDict",
                   "geometry { bed { type polyline; points ((-0.2 1.2 0) (1 0 0) (2 0 0) (2 1.2 0)); } }\n"
                   "regions ( boxToParticle { box (0 0 0) (3 1 0); } boxToParticle { box (0 0 0) (1 1 0); } );\n");
    SceneDefinition const definition = definitionOf(testCase);
    SurfaceTree const walls({definition.walls[0].surface});
    RegionVolume const volume = sampleRegions(definition.regions, walls, definition.lattice);
    expectBelow("volume of the regions - 1.5 m3", volume.all - 1.5, 0.01);
    expectBelow("volume in front of the walls - 0.75 m3", volume.free - 0.75, 0.01);
    expectBelow("volume out of the tank - 0.475 m3", volume.beyond - 0.475, 0.01); // a spacing beside the wall belongs to it
}

TEST(SizeEstimate, WhatDoesNotFitIsRefusedWithTheNumbers)
{
    SizeEstimate size;
    size.fluid = 1e6;
    Lattice const lattice{2, 0.01, 1};
    EXPECT_NO_THROW(requireRoom(size, lattice, {}, 100'000'000'000));
    try
    {
        requireRoom(size, lattice, Location{"constant/particleProperties", 11, "spacing"}, 100'000'000);
        FAIL() << "550 MB in 100 MB";
    }
    catch (CaseError const& error)
    {
        std::string const text = error.what();
        EXPECT_EQ(error.code(), ExitCode::Memory);
        for (char const* piece : {"constant/particleProperties:11", "1e+06 particles", "0.55 GB", "0.1 GB", "0.0235 m"})
            EXPECT_NE(text.find(piece), std::string::npos) << piece << '\n' << text;
    }
    size.fluid = 1e12; // no memory makes up for numbers of 32 bits
    EXPECT_THROW(requireRoom(size, lattice, {}, std::uint64_t(1) << 60), CaseError);
}

TEST(SizeEstimate, ABodyInMillimetresIsNamedWithTheEntryThatMendsIt)
{
    SmallCase const testCase;
    testCase.write("constant/particleProperties", "dimensions 3; spacing 0.05;");
    testCase.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (2 1 1); open (top); } }\n"
                                              "regions ( boxToParticle { box (0 0 0) (2 0.5 1); } );");
    testCase.write("constant/rigidBodyProperties", "bodies { slide { shape { type triSurfaceMesh; file \"slide.stl\"; } density 2000; } }");
    std::filesystem::create_directories(testCase.root() / "constant/triSurface");
    writeStl(testCase.root() / "constant/triSurface/slide.stl", TriSurface::box("slide", {800, 200, 300}, {1200, 600, 700}));
    try
    {
        definitionOf(testCase);
        FAIL() << "400 m with 0.05 m fit into no machine";
    }
    catch (CaseError const& error)
    {
        std::string const text = error.what();
        for (char const* piece : {"body \"slide\" (constant/rigidBodyProperties:4)", "measures 400 m", "millimetres (scale 0.001)?"})
            EXPECT_NE(text.find(piece), std::string::npos) << piece << '\n' << text;
    }

    testCase.write("constant/rigidBodyProperties",
                   "bodies { slide { shape { type triSurfaceMesh; file \"slide.stl\"; scale 0.001; } density 2000; } }");
    SceneDefinition const inMetres = definitionOf(testCase);
    EXPECT_EQ(largeSurface(inMetres, estimateSize(inMetres)), "");
}

TEST(SizeEstimate, TheMachineHasSomeMemory)
{
    std::uint64_t const bytes = availableMemory();
    EXPECT_GT(bytes, 1'000'000u);
    EXPECT_LT(bytes, std::uint64_t(1) << 50);
}

} // namespace
