#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "boundaries/TriangleTree.h"
#include "core/Errors.h"
#include "io/StlFile.h"
#include "scene/FluidFilling.h"
#include "scene/SurfaceColumns.h"
#include "scene/SurfaceFile.h"
#include "support/Measured.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace mpsDem;
using mpsDem::test::expectBelow;

Lattice const lattice{3, 0.02, 1};
using Regions = std::vector<std::unique_ptr<Region>>;

Regions regionsOf(std::string const& text, std::filesystem::path const& folder = {})
{
    return readRegions(Dictionary::fromText("regions (" + text + ");"), lattice, folder);
}

FluidFilling filled(Regions const& regions, std::string const& placement = "", std::vector<TriSurface> const& walls = {},
                    std::vector<TriSurface> const& bodies = {})
{
    TriangleTree const wallTree(walls), bodyTree(bodies);
    return fillRegions(regions, LatticePlacement::read(Dictionary::fromText("lattice {" + placement + "}"), 3), lattice,
                       {wallTree, bodyTree});
}

FluidFilling filled(std::string const& regions, std::string const& placement = "", std::vector<TriSurface> const& walls = {},
                    std::vector<TriSurface> const& bodies = {})
{
    return filled(regionsOf(regions), placement, walls, bodies);
}

std::string messageOf(std::string const& regions, std::filesystem::path const& folder = {})
{
    try
    {
        static_cast<void>(regionsOf(regions, folder));
    }
    catch (CaseError const& error)
    {
        return error.what();
    }
    return {};
}

/// A case folder with a surface in it.
class SpaceRegions : public ::testing::Test
{
protected:
    Regions regionOf(TriSurface const& surface, std::string const& keys = "")
    {
        writeStl(folder_ / "constant/triSurface/lake.stl", surface);
        return regionsOf("surfaceToParticle { file \"lake.stl\"; " + keys + "}", folder_.path());
    }

    TemporaryFolder folder_;
};

class Numbers
{
public:
    Real between(Real low, Real high) { return low + (high - low) * (static_cast<Real>(generator_() >> 11) * 0x1p-53); }
    Vector within(Vector const& low, Vector const& high)
    {
        return {between(low.x(), high.x()), between(low.y(), high.y()), between(low.z(), high.z())};
    }
    Vector direction() { return within({-1, -1, -1}, {1, 1, 1}).normalized(); }

private:
    std::mt19937_64 generator_{5};
};

TEST_F(SpaceRegions, BoxOfWholeCellsIsFilledExactly)
{
    auto const fluid = filled("boxToParticle { box (0 0 -0.1) (0.4 0.2 0.2); }");
    EXPECT_EQ(fluid.position.size(), 20u * 10u * 15u);
    EXPECT_NEAR(fluid.volume, 0.4 * 0.2 * 0.3, 1e-15);
    EXPECT_NEAR((fluid.position.front() - Vector(0.01, 0.01, -0.09)).norm(), 0, 1e-15);
    EXPECT_NEAR((fluid.position[1] - Vector(0.03, 0.01, -0.09)).norm(), 0, 1e-15);
    auto const moved = filled("boxToParticle { box (0 0 0) (0.2 0.2 0.2); }", "origin (0 0 1); offset (0.25 0 -0.5);");
    EXPECT_NEAR((moved.position.front() - Vector(0.015, 0.01, 0)).norm(), 0, 1e-12);
}

TEST_F(SpaceRegions, VolumesOfRoundAndSlantedRegions)
{
    auto const test = [](char const* name, std::string const& region, Real exact) {
        auto const fluid = filled(region);
        expectBelow(std::string(name) + ", volume sampled", fluid.volume / exact - 1, 1e-3);
        expectBelow(std::string(name) + ", volume of particles",
                    static_cast<Real>(fluid.position.size()) * lattice.particleVolume() / exact - 1, 0.02);
    };
    test("sphere", "sphereToParticle { origin (1 1 -2); radius 0.3; }", 4 * std::numbers::pi / 3 * 0.027);
    test("cylinder along z", "cylinderToParticle { p1 (1 1 0); p2 (1 1 0.5); radius 0.3; }", std::numbers::pi * 0.09 * 0.5);
    test("slanted cylinder", "cylinderToParticle { p1 (1 1 0); p2 (1.3 0.8 0.6); radius 0.2; }", std::numbers::pi * 0.04 * 0.7);
    test("rotated box", "rotatedBoxToParticle { origin (0 0 0); i (0.3 0.3 0); j (-0.2 0.2 0.1); k (0.1 0 0.4); }", 0.051);
}

TEST_F(SpaceRegions, RegionsLieWithinTheirBoxesAndEndWhereTheySay)
{
    TriSurface const ring = TriSurface::prism("ring", {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}}, -0.5, 1);
    writeStl(folder_ / "constant/triSurface/ring.stl", ring);
    auto const regions =
        regionsOf("boxToParticle { box (0 0 0) (1 2 3); } rotatedBoxToParticle { origin (0 0 0); i (1 1 0); j (-1 1 0.5); "
                  "k (0.2 0 1); } cylinderToParticle { p1 (1 1 0); p2 (2 0 1); radius 0.5; } sphereToParticle { origin (1 2 3); "
                  "radius 0.7; } surfaceToParticle { file \"ring.stl\"; }",
                  folder_.path());
    Numbers numbers;
    for (auto const& region : regions)
    {
        Vector const low = region->low(), high = region->high(), margin = 0.3 * (high - low);
        int within = 0;
        for (int k = 0; k < 4000; ++k)
        {
            Vector const r = numbers.within(low - margin, high + margin);
            if (!region->contains(r)) continue;
            ++within;
            EXPECT_TRUE((r.array() >= low.array() - 1e-9).all() && (r.array() <= high.array() + 1e-9).all()) << region->type;
            Vector const up = k % 2 == 0 ? Vector::Unit(k / 2 % 3) : numbers.direction();
            Real const way = region->exitDistance(r, up);
            if (k > 400 && region->type == "surfaceToParticle" && k % 2 == 1) continue; // each new direction costs a sorting
            EXPECT_GT(way, 0);
            EXPECT_TRUE(region->contains(r + (way - 1e-7) * up)) << region->type;
            EXPECT_TRUE(region->contains(r + 0.5 * way * up)) << region->type;
            EXPECT_FALSE(region->contains(r + (way + 1e-7) * up)) << region->type << " along " << up.transpose();
        }
        EXPECT_GT(within, 200) << region->type;
    }
}

TEST_F(SpaceRegions, ASurfaceHoldsTheSameParticlesAsTheBoxItDescribes)
{
    auto const box = filled("boxToParticle { box (0.25 0.25 0) (0.75 0.5 0.25); }", "offset (0 0 0.5);");
    auto const surface = filled(regionOf(TriSurface::box("box", {0.25, 0.25, 0}, {0.75, 0.5, 0.25})), "offset (0 0 0.5);");
    EXPECT_EQ(box.position.size(), 25u * 13u * 13u);
    EXPECT_EQ(surface.position, box.position) << "points on the sides count on both alike";
    EXPECT_NEAR(surface.volume, box.volume, 1e-3 * box.volume);
    auto const millimetres = regionOf(TriSurface::box("box", {0, 0, 0}, {200, 100, 60}), "scale 0.001; ");
    EXPECT_NEAR(filled(millimetres).volume, 0.0012, 1e-12);
}

TEST_F(SpaceRegions, InsideOfASurfaceIsWhereItsDistanceIsNegative)
{
    TriSurface const ball = TriSurface::sphere("ball", {0, 0, 0}, 1, 0.3);
    std::vector<TriSurface> const shapes{
        ball.moved(Eigen::AngleAxisd(0.4, Vector(1, 2, 3).normalized()).toRotationMatrix(), {0.1, 0.2, 0.3}),
        TriSurface::prism("ring", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0.1, -0.5, 0}, {-1, 1, 0}}, -0.5, 1),
        TriSurface::cylinder("rod", {-1, -1, 0}, {1, 0.5, 0.2}, 0.4, 24), TriSurface::box("box", {-1, -1, -1}, {1, 1, 1})};
    Numbers numbers;
    int checked = 0;
    for (TriSurface const& shape : shapes)
    {
        TriangleTree const tree(std::span(&shape, 1));
        for (Vector const& direction : {Vector(0, 0, 1), Vector(0, 1, 0), Vector(1, 2, -2).normalized().eval()})
        {
            SurfaceColumns const columns(shape, direction);
            for (int k = 0; k < 3000; ++k)
            {
                Vector r = numbers.within({-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2});
                if (k % 3 == 0) r = (r * 10).array().round() / 10; // in line with corners and edges
                Real const distance = tree.distance(r);
                if (std::abs(distance) < 1e-9) continue;
                ++checked;
                ASSERT_EQ(columns.inside(r), distance < 0) << shape.name() << " at " << r.transpose() << ", distance " << distance;
            }
        }
    }
    EXPECT_GT(checked, 30000);
}

TEST_F(SpaceRegions, ShellsThatOverlapCountOnceAndDisjointOnesBoth)
{
    {
        FacetSoup soup;
        for (TriSurface const& box : {TriSurface::box("one", {0, 0, 0}, {1, 1, 1}), TriSurface::box("two", {0.5, 0.5, 0.5}, {2, 2, 2})})
            for (auto const& t : box.triangles()) soup.facets.push_back({box.point(t, 0), box.point(t, 1), box.point(t, 2)});
        TriSurface const both = joinFacets(soup, "both", Skin::Closed);
        SurfaceColumns const columns(both, Vector::UnitY());
        EXPECT_TRUE(columns.inside({0.7, 0.7, 0.7}));
        EXPECT_TRUE(columns.inside({0.2, 0.2, 0.2}));
        EXPECT_FALSE(columns.inside({1.5, 0.2, 0.2}));
        EXPECT_NEAR(columns.exitDistance({0.7, 0.1, 0.7}), 1.9, 1e-12) << "through both";
        EXPECT_NEAR(columns.exitDistance({0.2, 0.1, 0.2}), 0.9, 1e-12);
        EXPECT_EQ(columns.exitDistance({0.2, -0.1, 0.2}), 0);
    }
}

TEST_F(SpaceRegions, BodiesAndWallsAreCarvedOut)
{
    TriSurface const tank = TriSurface::box("tank", {0, 0, 0}, {1, 0.5, 0.6}, {false, false, false, true, false, false}).flipped();
    TriSurface const box = TriSurface::box("box", {0.4, 0.1, 0.2}, {0.6, 0.3, 0.4});
    auto const fluid = filled("boxToParticle { box (-0.1 -0.1 -0.1) (1.1 0.4 0.7); }", "", {tank}, {box});
    EXPECT_EQ(fluid.position.size(), 50u * 20u * 30u - 1000u);
    EXPECT_EQ(fluid.count[0], 60 * 25 * 40);
    EXPECT_NEAR(fluid.volume, 0.24 - 0.008, 1e-12);
    TriangleTree const walls(std::span(&tank, 1)), bodies(std::span(&box, 1));
    for (Vector const& r : fluid.position)
    {
        EXPECT_GE(walls.distance(r), 0.45 * lattice.spacing);
        EXPECT_GE(bodies.distance(r), 0.45 * lattice.spacing);
    }
    TriSurface const turned = TriSurface::box("box", {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1})
                                  .moved(Eigen::AngleAxisd(0.6, Vector(1, 2, 3).normalized()).toRotationMatrix(), {0.5, 0.2, 0.3});
    auto const around = filled("boxToParticle { box (0 0 0) (1 0.4 0.6); }", "", {tank}, {turned});
    expectBelow("turned box in a tank, error of the volume in volumes of the box", (around.volume - 0.232) / 0.008, 0.02);
    TriSurface const ball = TriSurface::sphere("ball", {0.5, 0.2, 0.3}, 0.15, 0.01);
    auto const outside = filled("boxToParticle { box (0 0 0) (1 0.4 0.6); }", "", {tank}, {ball});
    expectBelow("ball in a tank, error of the volume in volumes of the ball", (outside.volume - 0.24 + ball.volume()) / ball.volume(),
                0.02);
}

TEST_F(SpaceRegions, BlocksOfCellsAgreeWithACellByCellSearch)
{
    TriSurface const slope = TriSurface::prism("slope", {{-0.5, -0.5, 0}, {0.9, -0.5, 0}, {0.2, 0.35, 0}, {-0.5, 0.35, 0}}, -0.5, 1.5);
    TriSurface const tank = TriSurface::box("tank", {0, 0, 0}, {1.2, 0.6, 0.5}).flipped();
    TriSurface const rod = TriSurface::cylinder("rod", {0.9, 0.1, 0.1}, {1, 0.5, 0.4}, 0.06, 32);
    std::vector<TriSurface> const walls{slope, tank}, bodies{rod};
    auto const regions = regionsOf("boxToParticle { box (0 0 0) (1.2 0.3 0.5); } sphereToParticle { origin (0.9 0.3 0.2); radius 0.2; }");
    auto const fluid = filled(regions, "offset (0.1 0.2 0.3);", walls, bodies);
    TriangleTree const wallTree(walls), bodyTree(bodies);
    Field<Vector> wanted;
    Vector const origin = lattice.spacing * Vector(0.1, 0.2, 0.3);
    for (int k = -5; k < 40; ++k)
        for (int j = -5; j < 40; ++j)
            for (int i = -5; i < 70; ++i)
            {
                Vector const r = origin + lattice.spacing * Vector(i + 0.5, j + 0.5, k + 0.5);
                bool const within = regions[0]->contains(r) || regions[1]->contains(r);
                if (within && std::min(wallTree.distance(r), bodyTree.distance(r)) >= (0.45 - 1e-9) * lattice.spacing) wanted.push_back(r);
            }
    EXPECT_GT(wanted.size(), 5000u);
    Field<Vector> onLattice, pushed;
    for (Vector const& r : fluid.position)
    {
        Vector const cells = (r - origin) / lattice.spacing - Vector::Constant(0.5);
        bool const even = (cells.array() - cells.array().round()).abs().maxCoeff() < 1e-9;
        (even ? onLattice : pushed).push_back(r);
    }
    EXPECT_EQ(onLattice, wanted);
    // Where walls cut cells, as many particles as their free shares add up to, clear of walls and of each other.
    Real const cell = std::pow(lattice.spacing, 3);
    EXPECT_GT(pushed.size(), 100u);
    expectBelow("clear cells only: error of the volume", static_cast<Real>(wanted.size()) * cell / fluid.volume - 1, 0.2);
    expectBelow("with those at walls: error of the volume", static_cast<Real>(fluid.position.size()) * cell / fluid.volume - 1, 0.02);
    Real clear = 1, apart = 1;
    for (Vector const& r : pushed)
    {
        clear = std::min(clear, std::min(wallTree.distance(r), bodyTree.distance(r)) / lattice.spacing);
        for (Vector const& q : fluid.position)
            if (q != r) apart = std::min(apart, (q - r).norm() / lattice.spacing);
    }
    test::expectBetween("least distance from walls [spacings]", clear, 0.35, 0.45 + 1e-9);
    test::expectBetween("least distance from others [spacings]", apart, 0.55, 1);
}

TEST_F(SpaceRegions, JitterGoesInThreeDirectionsAndKeepsClearOfWalls)
{
    TriSurface const tank = TriSurface::box("tank", {0, 0, 0}, {0.4, 0.4, 0.4}).flipped();
    std::string const box = "boxToParticle { box (0 0 0) (0.4 0.4 0.4); }";
    auto const even = filled(box, "", {tank}), first = filled(box, "jitter 0.3; seed 7;", {tank});
    auto const again = filled(box, "jitter 0.3; seed 7;", {tank}), other = filled(box, "jitter 0.3; seed 8;", {tank});
    ASSERT_EQ(even.position.size(), 8000u);
    ASSERT_EQ(first.position.size(), 8000u);
    EXPECT_EQ(first.position, again.position);
    EXPECT_NE(first.position, other.position);
    TriangleTree const tree(std::span(&tank, 1));
    Vector sum2 = Vector::Zero();
    for (std::size_t i = 0; i < even.position.size(); ++i)
    {
        Vector const moved = (first.position[i] - even.position[i]) / lattice.spacing;
        EXPECT_LE(moved.cwiseAbs().maxCoeff(), 0.3 + 1e-9);
        EXPECT_GE(tree.distance(first.position[i]), 0.25 * lattice.spacing);
        sum2 += moved.cwiseAbs2();
    }
    // Variance of a uniform number in [-a, a] is a^2 / 3; a few particles at the walls stay.
    for (Real const s : sum2) EXPECT_NEAR(s / 8000, 0.03, 0.1 * 0.03);
}

TEST_F(SpaceRegions, DepthIsMeasuredThroughRegionsThatTouch)
{
    writeStl(folder_ / "constant/triSurface/pond.stl", TriSurface::sphere("pond", {5, 5, 5}, 1, 0.1));
    auto const regions = regionsOf("boxToParticle { box (0 0 0) (1 1 0.3); } boxToParticle { box (0 0 0.3) (0.5 1 0.5); } "
                                   "surfaceToParticle { file \"pond.stl\"; }",
                                   folder_.path());
    Vector const up = Vector::UnitZ();
    EXPECT_NEAR(depthInRegions(regions, {0.2, 0.1, 0.1}, up, 0.02), 0.4, 1e-6);
    EXPECT_NEAR(depthInRegions(regions, {0.8, 0.1, 0.1}, up, 0.02), 0.2, 1e-6);
    EXPECT_NEAR(depthInRegions(regions, {5, 5, 5.2}, up, 0.02), 0.8, 1e-2);
    EXPECT_LT(depthInRegions(regions, {2, 0.1, 0.1}, up, 0.02), 0);
}

TEST_F(SpaceRegions, RastersOfHeightsAreSurfacesToo)
{
    std::filesystem::create_directories(folder_ / "constant/triSurface");
    std::ofstream(folder_ / "constant/triSurface/bed.ASC") << "ncols 3\nnrows 2\nxllcenter 100\nyllcenter 200\ncellsize 10\n4 5 6\n1 2 3\n";
    auto const read = [&](std::string const& keys) {
        return readSurfaceFile(Dictionary::fromText("file \"bed.ASC\"; " + keys), folder_.path(), "bed", Skin::Open, 0);
    };
    // The cells reach half a cell beyond their middles, and so does the surface, in a line with the outermost two heights.
    EXPECT_EQ(read("up z;").low(), Vector(95, 195, -1));
    EXPECT_EQ(read("up z;").high(), Vector(125, 215, 8));
    TriSurface const bed = read("origin (100 200 0); scale 0.1; up y;");
    EXPECT_NEAR((bed.high() - Vector(2.5, 0.8, 0.5)).norm(), 0, 1e-15);
    EXPECT_NEAR((bed.low() - Vector(-0.5, -0.1, -1.5)).norm(), 0, 1e-15);
    EXPECT_THROW(read("every 0;"), CaseError);
    EXPECT_THROW(read("up x;"), CaseError);
}

TEST_F(SpaceRegions, WrongRegionsAreRefusedByName)
{
    EXPECT_NE(messageOf("boxToParticle { box (0 0 0) (1 0 1); }").find("without volume"), std::string::npos);
    EXPECT_NE(messageOf("rotatedBoxToParticle { origin (0 0 0); i (1 0 0); j (0 1 0); k (1 1 0); }").find("without volume"),
              std::string::npos);
    EXPECT_NE(messageOf("rotatedBoxToParticle { origin (0 0 0); i (1 0 0); j (0 1 0); }").find("k"), std::string::npos);
    EXPECT_NE(messageOf("cylinderToParticle { p1 (0 0 0); p2 (0 0 0); radius 1; }").find("without length"), std::string::npos);
    EXPECT_NE(messageOf("surfaceToParticle { file \"../../etc/passwd\"; }").find("outside of the case"), std::string::npos);
    EXPECT_NE(messageOf("surfaceToParticle { file \"no.stl\"; }", folder_.path()).find("file \"no.stl\" is not in constant/triSurface"),
              std::string::npos);
    writeStl(folder_ / "constant/triSurface/open.stl", TriSurface::box("open", {0, 0, 0}, {1, 1, 1}, {true}));
    EXPECT_NE(messageOf("surfaceToParticle { file \"open.stl\"; }", folder_.path()).find("open: 4 edges"), std::string::npos);
    EXPECT_NE(messageOf("surfaceToParticle { file \"lake.obj\"; }").find("unknown kind"), std::string::npos);
    EXPECT_NE(messageOf("surfaceToParticle { file \"bed.asc\"; }").find("no closed surface"), std::string::npos);
    auto const inPlane = [] {
        static_cast<void>(readRegions(Dictionary::fromText("regions ( surfaceToParticle { file \"a.stl\"; } );"), Lattice{2, 0.02, 1}));
    };
    EXPECT_THROW(inPlane(), CaseError);
    EXPECT_THROW(filled("boxToParticle { box (0 0 0) (100 100 100); }"), CaseError) << "too many cells";
}

} // namespace
