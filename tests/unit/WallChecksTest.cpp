// What setParticles says of walls that do not hold the fluid.

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/WallChecks.h"
#include "support/SmallCase.h"

namespace mpsDem::test {

namespace {

std::string const water = "regions ( boxToParticle { box (0 0 0) (1 0.5 0.5); } );";
std::string const sides = "sides { type searchableBox; min (0 -0.5 0); max (1 1 0.5); open (bottom top); }";

/// Findings in a case of `dimensions`, spacing 0.05 m.
std::vector<std::string> findings(int dimensions, std::string const& geometry, std::string const& regions = water,
                                  std::string const& g = "(0 -10 0)")
{
    SmallCase made;
    made.remove("constant/rigidBodyProperties");
    made.write("constant/particleProperties", "spacing 0.05; dimensions " + std::to_string(dimensions) + ";");
    made.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value " + g + ";", "uniformDimensionedVectorField");
    made.write("system/setParticlesDict", "geometry { " + geometry + " } " + regions);
    SceneDefinition const definition = readSceneDefinition(CaseFolder(made.root()), "system/setParticlesDict");
    return doubtfulWalls(definition, makeInitialScene(definition));
}

/// A floor of two plates in the plane y = 0 with a gap of `gap` between them.
std::string plates(Real gap)
{
    return "one { type searchablePlate; origin (-0.5 0 -0.5); span (" + std::to_string(1 - gap / 2) +
           " 0 1.5); fluidSide positive; } two { type searchablePlate; origin (" + std::to_string(0.5 + gap / 2) +
           " 0 -0.5); span (1 0 1.5); fluidSide positive; } ";
}

std::string polyline(std::string const& points, std::string const& rest = "")
{
    return "bed { type polyline; points (" + points + "); " + rest + " }";
}

} // namespace

TEST(WallChecks, saysNothingOfTanksThatHoldTheirWater)
{
    EXPECT_TRUE(findings(3, plates(0) + sides).empty());
    EXPECT_TRUE(findings(3, "tank { type searchableBox; min (0 0 0); max (1 1 0.5); open (top); }").empty());
    EXPECT_TRUE(findings(2, polyline("(-0.2 1.2 0) (0 0 0) (1 0 0) (1 1.2 0)")).empty());
    std::string const sill = "sill { type searchableBox; min (0.4 0 0); max (0.6 0.06 0.5); fluidSide outside; } ";
    EXPECT_TRUE(findings(3, sill + plates(0) + sides).empty()) << "water does not get below it";
    EXPECT_TRUE(findings(3, plates(0) + sides, "regions ( boxToParticle { box (0.4 0.6 0.2) (0.6 0.8 0.4); } );").empty())
        << "a falling drop";
}

TEST(WallChecks, findsFluidOverAGap)
{
    auto const found = findings(3, plates(0.2) + sides);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("400 of 2000 fluid particles have no wall below them, the lowest at (0.425 0.025 0.025) m"), std::string::npos)
        << found[0];
    EXPECT_EQ(findings(2, polyline("(0 1.2 0) (0 0 0) (0.8 0 0) (0.8 -0.1 0) (1.2 -0.1 0) (1.2 1.2 0)")).size(), 0u);
    EXPECT_EQ(findings(2, polyline("(0 1.2 0) (0 0 0) (0.8 0 0)")).size(), 2u) << "the right side is open, too";
    EXPECT_TRUE(findings(3, plates(0.2) + sides, water, "(0 0 0)").empty()) << "nothing falls";
}

TEST(WallChecks, refusesWaterWithoutAnyFloor)
{
    try
    {
        findings(2, polyline("(0 1.2 0) (0 -0.2 0)") + " end { type polyline; points ((1 -0.2 0) (1 1.2 0)); }");
        FAIL() << "all of the water falls";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        EXPECT_NE(std::string(error.what()).find("200 of 200 fluid particles have no wall below them"), std::string::npos) << error.what();
    }
}

TEST(WallChecks, findsFluidBesideWhichThereIsNoWall)
{
    std::string const channel = "(0 1.2 0) (0 0 0) (1 0 0) (1 1.2 0)";
    auto const found = findings(3, polyline(channel, "zRange (0 0.5);"));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NE(found[0].find("has no wall beside it along (0 0 1), nor has it elsewhere (2000 of 2000 particles asked)"), std::string::npos)
        << found[0];
    EXPECT_TRUE(findings(3, polyline(channel, "zRange (0 0.5); sideWalls yes;")).empty());
    EXPECT_EQ(findings(2, polyline("(0 1.2 0) (0 0 0) (2 0 0)")).size(), 1u) << "a dam that is no dam";
}

TEST(WallChecks, findsWallsThatTurnTheirBackOnTheFluid)
{
    auto const lower = "regions ( boxToParticle { box (0 -0.1 0) (1 0.5 0.5); } );";
    try
    {
        findings(2, polyline("(-0.2 1.2 0) (0 0 0) (1 0 0) (1 1.2 0)", "fluidSide right;"), lower);
        FAIL() << "all that is left lies below the wall";
    }
    catch (CaseError const& error)
    {
        EXPECT_NE(std::string(error.what()).find("wall \"bed\" turns its back on the fluid: it faces down"), std::string::npos)
            << error.what();
    }
    EXPECT_TRUE(
        findings(3, plates(0) + "lid { type searchablePlate; origin (-0.5 0.5 -0.5); span (2 0 1.5); fluidSide negative; } " + sides)
            .empty())
        << "a lid on the water";
}

TEST(WallChecks, findsWallsThinnerThanTwoSpacings)
{
    auto const baffle = [](std::string const& to) {
        return "baffle { type searchableBox; min (0.475 -0.2 -0.2); max (" + to + " 0.8 0.7); fluidSide outside; } ";
    };
    auto const found = findings(3, baffle("0.48") + plates(0) + sides);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("wall \"baffle\" is 0.1 spacings thick"), std::string::npos) << found[0];
    EXPECT_TRUE(findings(3, baffle("0.58") + plates(0) + sides).empty());
    EXPECT_EQ(
        findings(2,
                 polyline("(0 1.2 0) (0 0 0) (1 0 0) (1 1.2 0)") +
                     " baffle { type polyline; closed yes; fluidSide right; points ((0.5 0.2 0) (0.56 0.2 0) (0.56 0.8 0) (0.5 0.8 0)); }")
            .size(),
        1u);
}

} // namespace mpsDem::test
