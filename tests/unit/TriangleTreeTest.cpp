#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "boundaries/TriangleTree.h"
#include "core/TriSurface.h"
#include "support/Measured.h"

namespace {

using namespace mpsDem;
using test::expectBelow;
using Side = std::array<bool, 6>;

TriangleTree treeOf(std::vector<TriSurface> const& surfaces) { return TriangleTree(surfaces); }

/// Surface over a grid of heights z(x, y), fluid above.
template <class Height>
TriSurface raster(Real length, int cells, Height height)
{
    std::vector<Vector> points;
    std::vector<TriSurface::Corners> triangles;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i)
        {
            Real const x = length * i / cells, y = length * j / cells;
            points.emplace_back(x, y, height(x, y));
            int const k = j * (cells + 1) + i;
            if (i == cells || j == cells) continue;
            triangles.push_back({k, k + 1, k + cells + 2});
            triangles.push_back({k, k + cells + 2, k + cells + 1});
        }
    return TriSurface("bed", points, triangles);
}

/// Distance from a triangle by its plane, its sides and its corners, without the tree's code.
Real distanceToTriangle(Vector const& a, Vector const& b, Vector const& c, Vector const& r)
{
    Vector const n = (b - a).cross(c - a).normalized();
    bool inside = true;
    Real least = std::numeric_limits<Real>::infinity();
    for (auto const& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
    {
        inside = inside && n.dot((q - p).cross(r - p)) >= 0;
        Real const t = std::clamp((r - p).dot(q - p) / (q - p).squaredNorm(), Real(0), Real(1));
        least = std::min(least, (r - p - t * (q - p)).norm());
    }
    return inside ? std::abs(n.dot(r - a)) : least;
}

Real distanceToSurface(TriSurface const& s, Vector const& r)
{
    Real least = std::numeric_limits<Real>::infinity();
    for (auto const& t : s.triangles()) least = std::min(least, distanceToTriangle(s.point(t, 0), s.point(t, 1), s.point(t, 2), r));
    return least;
}

class Places
{
public:
    Places(Vector const& low, Vector const& high) : low_(low), size_(high - low) {}
    Vector operator()()
    {
        Real const x = next(), y = next(), z = next();
        return low_ + size_.cwiseProduct(Vector(x, y, z));
    }

private:
    Real next() { return static_cast<Real>(generator_()) / 4294967296.0; }
    std::mt19937 generator_{7};
    Vector low_, size_;
};

TEST(TriangleTree, AgreesWithASearchOverAllTriangles)
{
    std::vector<TriSurface> const surfaces{
        raster(2, 20, [](Real x, Real y) { return 0.3 * std::sin(4 * x) * std::cos(5 * y) + 0.05 * std::sin(31 * x + 17 * y); })};
    auto const tree = treeOf(surfaces);
    Places places({-0.5, -0.5, -0.8}, {2.5, 2.5, 0.8});
    Real worst = 0, off = 0;
    for (int k = 0; k < 3000; ++k)
    {
        Vector const r = places();
        auto const near = tree.nearest(r);
        worst = std::max(worst, std::abs(std::abs(near.distance) - distanceToSurface(surfaces[0], r)));
        off = std::max(off, std::abs((near.point - r).norm() - std::abs(near.distance)));
        auto const& t = surfaces[0].triangles()[static_cast<std::size_t>(near.triangle)];
        off = std::max(off, distanceToTriangle(surfaces[0].point(t, 0), surfaces[0].point(t, 1), surfaces[0].point(t, 2), near.point));
        if (!near.atRim && r.x() > 0.4 && r.x() < 1.6 && r.y() > 0.4 && r.y() < 1.6)
        {
            ASSERT_LT((near.normal - t.normal).norm(), 1e-15);
        }
    }
    expectBelow("distance against all triangles", worst, 1e-14);
    expectBelow("nearest point off its triangle", off, 1e-14);
}

TEST(TriangleTree, SignOfABoxIsRightAtFacesEdgesAndCorners)
{
    auto const tree = treeOf({TriSurface::box("cube", {0, 0, 0}, {1, 1, 1})});
    Places places({-0.7, -0.7, -0.7}, {1.7, 1.7, 1.7});
    for (int k = 0; k < 5000; ++k)
    {
        Vector const r = places();
        Vector const out = (-r).cwiseMax(r - Vector::Ones()).cwiseMax(Vector::Zero());
        Real const inside = std::min(r.minCoeff(), (Vector::Ones() - r).minCoeff());
        ASSERT_NEAR(tree.distance(r), inside > 0 ? -inside : out.norm(), 1e-14) << r.transpose();
    }
    EXPECT_FALSE(tree.nearest({2, 2, 2}).atRim);
}

TEST(TriangleTree, SignOfAKnifeEdgeDoesNotDependOnTheFaceThatIsAsked)
{
    // Tip of 20 degrees at the origin: places before it and below one face's plane are outside all the same.
    Real const half = 10 * std::numbers::pi / 180;
    std::vector<Vector> const corners{{0, 0, 0}, {std::cos(half), std::sin(half), 0}, {std::cos(half), -std::sin(half), 0}};
    auto const prism = TriSurface::prism("knife", corners, 0, 1);
    // The same with upper, lower and other sides as three surfaces, the lower one meshed finer: rims meet without common points.
    std::vector<TriSurface> pieces{TriSurface::extruded("upper", {corners[0], corners[1]}, false, 0, 1, true)};
    std::vector<Vector> points;
    std::vector<TriSurface::Corners> triangles;
    for (int i = 0; i <= 1; ++i)
        for (int k = 0; k <= 7; ++k) points.emplace_back(i * corners[2].x(), i * corners[2].y(), k / 7.0);
    for (int k = 0; k < 7; ++k)
    {
        triangles.push_back({k, 8 + k, 8 + k + 1});
        triangles.push_back({k, 8 + k + 1, k + 1});
    }
    pieces.push_back(TriSurface("lower", points, triangles));
    if (pieces[1].triangles()[0].normal.y() > 0) pieces[1] = pieces[1].flipped();
    auto const one = treeOf({prism}), many = treeOf(pieces);
    for (int k = -80; k <= 80; ++k)
    {
        Real const angle = k * std::numbers::pi / 180;
        Vector const r(-0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.41);
        EXPECT_NEAR(one.distance(r), 0.3, 1e-14) << k;
        EXPECT_NEAR(many.distance(r), 0.3, 1e-14) << k;
    }
    EXPECT_LT(many.distance({0.5, 0, 0.41}), 0);
    EXPECT_GT(many.distance({0.5, 0.5, 0.41}), 0);
}

TEST(TriangleTree, FloorAndWallAsTwoSurfacesJoin)
{
    std::vector<Vector> const chain{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
    auto const one = treeOf({TriSurface::extruded("both", chain, false, 0, 1, true)});
    auto const two = treeOf({TriSurface::extruded("wall", {chain[0], chain[1]}, false, 0, 1, true),
                             TriSurface::extruded("floor", {chain[1], chain[2]}, false, 0, 1, true)});
    Places places({-0.4, -0.4, 0.1}, {0.9, 0.9, 0.9});
    for (int k = 0; k < 3000; ++k)
    {
        Vector const r = places();
        ASSERT_NEAR(two.distance(r), one.distance(r), 1e-14) << r.transpose();
        ASSERT_EQ(two.distance(r) > 0, r.x() > 0 && r.y() > 0) << r.transpose();
    }
    EXPECT_FALSE(two.nearest({-0.2, -0.2, 0.5}).atRim);
    EXPECT_TRUE(two.nearest({1.2, -0.2, 0.5}).atRim);
    EXPECT_EQ(two.nearest({0.5, -0.2, 0.5}).surface, 1);
}

TEST(TriangleTree, ConvexEdgeOfTwoSurfacesIsFluidOnBothSides)
{
    std::vector<TriSurface> sides;
    for (std::size_t k = 0; k < 6; ++k)
    {
        Side open{true, true, true, true, true, true};
        open[k] = false;
        sides.push_back(TriSurface::box("side", {0, 0, 0}, {1, 1, 1}, open));
    }
    auto const one = treeOf({TriSurface::box("cube", {0, 0, 0}, {1, 1, 1})}), six = treeOf(sides);
    Places places({-0.5, -0.5, -0.5}, {1.5, 1.5, 1.5});
    for (int k = 0; k < 3000; ++k)
    {
        Vector const r = places();
        ASSERT_NEAR(six.distance(r), one.distance(r), 1e-14) << r.transpose();
    }
}

TEST(TriangleTree, BehindARampAcrossABoxIsSolid)
{
    auto const box = TriSurface::box("tank", {0, 0, 0}, {3, 1, 1}, {false, false, false, false, false, true}).flipped();
    // From the wall x = 0 at height 0.8 down to the floor at x = 1.6, ending there or cutting through everything.
    for (Real const beyond : {0.0, 0.1})
    {
        Vector const a(-beyond, 0.8 + beyond / 2, 0), b(1.6 + beyond, -beyond / 2, 0);
        TriSurface ramp = TriSurface::extruded("ramp", {a, b}, false, -beyond, 1 + beyond, true);
        Tensor upright; // x y z -> x -z y, that is z up
        upright << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        ramp = ramp.moved(upright, Vector(0, 1, 0));
        auto const tree = treeOf({box, ramp});
        Places places({0, 0, 0}, {3, 1, 1});
        for (int k = 0; k < 4000; ++k)
        {
            Vector const r = places();
            Real const above = (r.z() - (0.8 - r.x() / 2)) * 2 / std::sqrt(5.0);
            Real const fromBox = std::min({r.x(), 3 - r.x(), r.y(), 1 - r.y(), r.z()});
            if (above > 0)
            {
                Real const onRamp = r.x() - above / std::sqrt(5.0); // foot on the plane of the ramp
                bool const footOnRamp = onRamp < 1.6 && onRamp > 0;
                Real const expected = footOnRamp ? std::min(fromBox, above) : fromBox;
                ASSERT_NEAR(tree.distance(r), expected, 1e-13) << r.transpose();
            }
            else
                ASSERT_LT(tree.distance(r), 1e-14) << r.transpose() << " " << above;
        }
        // Below the floor under the ramp the way out leads to the ramp.
        EXPECT_NEAR(tree.distance({0.8, 0.5, -0.1}), -0.5 * 2 / std::sqrt(5.0), 1e-13);
        EXPECT_FALSE(tree.nearest({0.8, 0.01, 0.41}).atRim);
    }
}

TEST(TriangleTree, RocksOnAFloorAreSolid)
{
    std::vector<TriSurface> const surfaces{TriSurface::box("tank", {0, 0, 0}, {2, 1, 1}).flipped(),
                                           TriSurface::box("rock", {0.5, 0.3, 0}, {0.9, 0.6, 0.3}),
                                           TriSurface::sphere("ball", {1.5, 0.5, 0.1}, 0.2, 0.02)}; // half sunk
    auto const tree = treeOf(surfaces);
    Places places({-0.1, -0.1, -0.1}, {2.1, 1.1, 1.1});
    for (int k = 0; k < 4000; ++k)
    {
        Vector const r = places();
        Real const fromBall = (r - Vector(1.5, 0.5, 0.1)).norm() - 0.2;
        if (std::abs(fromBall) < 1e-3) continue; // facets
        bool const inTank = r.minCoeff() > 0 && r.x() < 2 && r.y() < 1 && r.z() < 1;
        bool const inRock = r.x() > 0.5 && r.x() < 0.9 && r.y() > 0.3 && r.y() < 0.6 && r.z() < 0.3;
        ASSERT_EQ(tree.distance(r) > 0, inTank && !inRock && fromBall > 0) << r.transpose();
    }
}

TEST(TriangleTree, NothingIsInfinitelyFarFromNoSurface)
{
    TriangleTree const tree(std::span<TriSurface const>{});
    EXPECT_TRUE(tree.empty());
    EXPECT_EQ(tree.distance({1, 2, 3}), std::numeric_limits<Real>::infinity());
    EXPECT_THROW(static_cast<void>(tree.nearest({0, 0, 0})), std::logic_error);
}

/// Of the processor, not of a busy machine.
Real seconds(std::clock_t ticks) { return static_cast<Real>(ticks) / CLOCKS_PER_SEC; }

TEST(TriangleTree, QueryTakesMicroseconds)
{
    for (int const cells : {71, 707})
    {
        auto const bed = raster(10, cells, [](Real x, Real y) { return 0.3 * std::sin(4 * x) * std::cos(5 * y); });
        auto const start = std::clock();
        auto const tree = treeOf({bed});
        Real const building = seconds(std::clock() - start);
        std::string const size = std::to_string(bed.triangles().size()) + " triangles";
        expectBelow("build of " + size + " [s]", building, 60);
        // As particles are set: in the order of a lattice, near the surface.
        int const side = 50;
        Real sum = 0;
        auto const begin = std::clock();
        for (int k = 0; k < side * side * side; ++k)
            sum += tree.distance({3 + 0.02 * (k % side), 3 + 0.02 * (k / side % side), -0.5 + 0.02 * (k / side / side)});
        Real const asking = seconds(std::clock() - begin);
        EXPECT_TRUE(std::isfinite(sum));
        expectBelow("query of " + size + " [us]", asking / (side * side * side) * 1e6, 100); // a search over all takes 1e5
    }
}

} // namespace
