#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "boundaries/SurfaceTree.h"
#include "core/Errors.h"
#include "scene/FluidFilling.h"

namespace {

using namespace mpsDem;

Lattice const lattice{2, 0.02, 0.5};

std::vector<std::unique_ptr<Region>> regionsOf(std::string const& text)
{
    return readRegions(Dictionary::fromText("regions (" + text + ");"), lattice);
}

FluidFilling filled(std::string const& regions, std::string const& placement = "", std::vector<Surface> const& walls = {},
                    std::vector<Surface> const& bodies = {})
{
    SurfaceTree const wallTree(walls), bodyTree(bodies);
    return fillRegions(regionsOf(regions), LatticePlacement::read(Dictionary::fromText("lattice {" + placement + "}")), lattice,
                       {wallTree, bodyTree});
}

std::string messageOf(std::string const& regions)
{
    try
    {
        static_cast<void>(regionsOf(regions));
    }
    catch (CaseError const& error)
    {
        return error.what();
    }
    return {};
}

TEST(FluidRegions, BoxOfWholeCellsIsFilledExactly)
{
    auto const fluid = filled("boxToParticle { box (0 0 0) (2 1 0); }");
    EXPECT_EQ(fluid.position.size(), 100u * 50u);
    EXPECT_NEAR(fluid.volume, 2 * 1 * 0.5, 1e-12);
    EXPECT_NEAR(fluid.position.front().x(), 0.01, 1e-15);
    EXPECT_NEAR(fluid.position.front().y(), 0.01, 1e-15);
}

TEST(FluidRegions, BoxMayBeGivenByMinAndMax)
{
    auto const fluid = filled("boxToParticle { min (0 0 -1); max (0.2 0.1 1); }");
    EXPECT_EQ(fluid.position.size(), 10u * 5u);
}

TEST(FluidRegions, VolumesOfDiscAndRotatedBox)
{
    Real const disc = filled("cylinderToParticle { p1 (1 1 0); p2 (1 1 1); radius 0.3; }").volume;
    EXPECT_NEAR(disc, std::numbers::pi * 0.09 * 0.5, 3e-4 * disc);
    Real const sphere = filled("sphereToParticle { origin (1 1 0); radius 0.3; }").volume;
    EXPECT_EQ(sphere, disc);
    auto const rotated = filled("rotatedBoxToParticle { origin (0 0 0); i (0.3 0.3 0); j (-0.2 0.2 0); k (0 0 1); }");
    EXPECT_NEAR(rotated.volume, 0.12 * 0.5, 1e-3 * rotated.volume);
    EXPECT_NEAR(static_cast<Real>(rotated.position.size()) * lattice.particleVolume(), 0.06, 0.02 * 0.06);
}

TEST(FluidRegions, OverlappingRegionsAreAUnionAndTheLastOneSetsTheValues)
{
    auto const fluid = filled("boxToParticle { box (0 0 0) (0.4 0.2 0); } boxToParticle { box (0.2 0 0) (0.6 0.2 0); }");
    EXPECT_EQ(fluid.position.size(), 30u * 10u);
    EXPECT_NEAR(fluid.volume, 0.6 * 0.2 * 0.5, 1e-12);
    EXPECT_EQ(fluid.count[0], 100);
    EXPECT_EQ(fluid.count[1], 200);
}

TEST(FluidRegions, FieldValuesKeepAllDigits)
{
    auto const regions = regionsOf("boxToParticle { box (0 0 0) (1 1 0); fieldValues ( volVectorFieldValue U (0.123456789012345 -2 0) "
                                   "volScalarFieldValue p 101325.25 ); }");
    EXPECT_EQ(regions[0]->values.velocity.x(), 0.123456789012345);
    EXPECT_EQ(regions[0]->values.pressure, 101325.25);
    EXPECT_TRUE(regions[0]->values.hasVelocity && regions[0]->values.hasPressure);
}

TEST(FluidRegions, BodiesAndWallsAreCarvedOut)
{
    std::vector<Surface> const body{Polyline::outline("box", {{0.4, 0.4, 0}, {0.6, 0.4, 0}, {0.6, 0.6, 0}, {0.4, 0.6, 0}})};
    auto const fluid = filled("boxToParticle { box (0 0 0) (1 1 0); }", "", {}, body);
    EXPECT_EQ(fluid.position.size(), 2500u - 100u);
    EXPECT_NEAR(fluid.volume, (1 - 0.04) * 0.5, 1e-12);
    for (Vector const& r : fluid.position) EXPECT_GE(body[0].line().closest(r).distance, 0.45 * lattice.spacing);

    std::vector<Surface> const ramp{Polyline("ramp", {{0, 1, 0}, {1, 0, 0}}, false, Polyline::FluidSide::Left)};
    auto const above = filled("boxToParticle { box (0 0 0) (1 1 0); }", "", ramp);
    EXPECT_NEAR(above.volume, 0.25, 1e-4);
    EXPECT_EQ(above.position.size(), 49u * 50u / 2u); // lattice points above the diagonal
}

TEST(FluidRegions, OffsetShiftsTheLatticeByAFractionOfASpacing)
{
    auto const fluid = filled("boxToParticle { box (0 0 0) (0.2 0.2 0); }", "offset (0.25 0 0);");
    EXPECT_NEAR(fluid.position.front().x(), 0.75 * 0.02, 1e-12);
    EXPECT_NEAR(fluid.position.front().y(), 0.5 * 0.02, 1e-12);
}

TEST(FluidRegions, JitterIsTheSameEachTimeAndKeepsClearOfWalls)
{
    std::vector<Surface> const floor{Polyline("floor", {{-1, 0, 0}, {2, 0, 0}}, false, Polyline::FluidSide::Left)};
    std::string const box = "boxToParticle { box (0 0 0) (1 1 0); }";
    auto const even = filled(box, "", floor), first = filled(box, "jitter 0.3; seed 7;", floor),
               again = filled(box, "jitter 0.3; seed 7;", floor);
    auto const other = filled(box, "jitter 0.3; seed 8;", floor);
    ASSERT_EQ(first.position.size(), even.position.size());
    Real sum2 = 0;
    int different = 0;
    for (std::size_t i = 0; i < even.position.size(); ++i)
    {
        EXPECT_EQ(first.position[i], again.position[i]);
        if (first.position[i] != other.position[i]) ++different;
        EXPECT_GE(first.position[i].y(), 0.25 * lattice.spacing);
        Vector const moved = (first.position[i] - even.position[i]) / lattice.spacing;
        EXPECT_LE(moved.cwiseAbs().maxCoeff(), 0.3 + 1e-9);
        sum2 += moved.squaredNorm();
    }
    EXPECT_GT(different, 2000);
    // Variance of a uniform number in [-a, a] is a^2 / 3; two axes.
    EXPECT_NEAR(sum2 / static_cast<Real>(even.position.size()), 2 * 0.09 / 3, 0.05 * 0.06);
}

TEST(FluidRegions, DepthIsMeasuredThroughRegionsThatTouch)
{
    auto const regions = regionsOf("boxToParticle { box (0 0 0) (1 0.3 0); } boxToParticle { box (0 0.3 0) (0.5 0.5 0); } "
                                   "cylinderToParticle { p1 (3 0 0); p2 (3 0 1); radius 0.2; }");
    Vector const up = Vector::UnitY();
    EXPECT_NEAR(depthInRegions(regions, {0.2, 0.1, 0}, up, 0.02), 0.4, 1e-6);
    EXPECT_NEAR(depthInRegions(regions, {0.8, 0.1, 0}, up, 0.02), 0.2, 1e-6);
    EXPECT_NEAR(depthInRegions(regions, {3, 0.05, 0}, up, 0.02), 0.15, 1e-6);
    EXPECT_NEAR(depthInRegions(regions, {0.8, 0.1, 0}, Vector::UnitX(), 0.02), 0.2, 1e-6);
    EXPECT_LT(depthInRegions(regions, {2, 0.1, 0}, up, 0.02), 0);
}

TEST(FluidRegions, WrongRegionsAreRefusedByName)
{
    EXPECT_NE(messageOf("boxToParticel { box (0 0 0) (1 1 0); }").find("did you mean boxToParticle?"), std::string::npos);
    EXPECT_NE(messageOf("boxToParticle { box (0 0 0) (1 0 0); }").find("without area"), std::string::npos);
    EXPECT_NE(messageOf("boxToParticle { box (0 0 0) (1 1 0) (2 2 0); }").find("behind its end"), std::string::npos);
    EXPECT_NE(messageOf("sphereToParticle { origin (0 0 0); radius -1; }").find("radius"), std::string::npos);
    EXPECT_NE(messageOf("cylinderToParticle { p1 (0 0 0); p2 (1 0 0); radius 1; }").find("not along z"), std::string::npos);
    EXPECT_NE(messageOf("boxToParticle { box (0 0 0) (1 1 0); fieldValues ( volScalarFieldValue T 3 ); }").find("no scalar field \"T\""),
              std::string::npos);
}

} // namespace
