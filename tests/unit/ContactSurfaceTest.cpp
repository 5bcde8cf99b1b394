#include <gtest/gtest.h>

#include "core/Errors.h"
#include "dem/ContactPoints.h"
#include "dem/PolylineSurface.h"
#include "dem/SimpleSurfaces.h"

namespace mpsDem {
namespace {

constexpr Real depth = 0.02;

std::vector<ContactFeature> touch(ContactSurface const& surface, Vector const& centre, Real radius)
{
    std::vector<ContactFeature> features;
    std::vector<Sphere> const spheres = {{centre, radius}};
    surface.collect(spheres, 0, features);
    return features;
}

/// Wall down the line x = 0, floor along y = 0: free for x, y > 0.
PolylineSurface valley() { return {Polyline("valley", {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}}, false, Polyline::FluidSide::Left), depth}; }

/// Solid box [-1, 0] x [-1, 0] with a ridge at the origin.
PolylineSurface box() { return {Polyline::outline("box", {{-1, -1, 0}, {0, -1, 0}, {0, 0, 0}, {-1, 0, 0}}), depth}; }

} // namespace

TEST(ContactSurface, faceGivesOverlapAndNormal)
{
    auto const found = touch(valley(), {0.5, 0.009, 0}, 0.01);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].gap, -0.001, 1e-15);
    EXPECT_NEAR((found[0].normal - Vector::UnitY()).norm(), 0, 1e-15);
}

TEST(ContactSurface, valleyKeepsBothSides)
{
    EXPECT_EQ(touch(valley(), {0.009, 0.0095, 0}, 0.01).size(), 2u);
    // A corner of a body, radius 0, that has sunk into both sides: beyond the end of each.
    auto const corner = touch(valley(), {-1e-5, -2e-5, 0}, 0);
    ASSERT_EQ(corner.size(), 2u);
    EXPECT_NEAR(corner[0].gap + corner[1].gap, -3e-5, 1e-15);
    EXPECT_EQ(touch(valley(), {1e-5, -2e-5, 0}, 0).size(), 1u);
    EXPECT_EQ(touch(valley(), {1e-5, 1e-9, 0}, 0).size(), 0u);
}

TEST(ContactSurface, ridgeTouchesOnce)
{
    for (Real const angle : {-0.2, 0.0, 0.3, 0.7853981633974483, 1.2, 1.5707963267948966, 1.8})
    {
        Vector const centre = 0.009 * Vector(std::cos(angle), std::sin(angle), 0);
        EXPECT_EQ(touch(box(), centre, 0.01).size(), 1u) << angle;
    }
    auto const found = touch(box(), {0.006, 0.006, 0}, 0.01);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].gap, 0.006 * std::sqrt(2.0) - 0.01, 1e-15);
}

// Inside a ridge a point belongs to the nearer side only.
TEST(ContactSurface, pointBehindARidgeTouchesOnce)
{
    auto const found = touch(box(), {-1e-4, -2e-4, 0}, 0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].gap, -1e-4, 1e-15);
    EXPECT_NEAR((found[0].normal - Vector::UnitX()).norm(), 0, 1e-15);
}

// The underside of a plate thinner than the depth must not push what lies on its top, nor what is above it.
TEST(ContactSurface, thinPlateHasNoFarSide)
{
    PolylineSurface const plate(Polyline::outline("plate", {{-1, -0.01, 0}, {1, -0.01, 0}, {1, 0, 0}, {-1, 0, 0}}), depth);
    auto const found = touch(plate, {0.3, -1e-4, 0}, 0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(found[0].normal.y(), 0.99);
    EXPECT_EQ(touch(plate, {0.3, 1e-4, 0}, 0).size(), 0u);
    EXPECT_EQ(touch(plate, {0.3, 0.009, 0}, 0.01).size(), 1u);
}

// A valley of one degree: two sides with nearly the same normal are one contact.
TEST(ContactSurface, nearlyStraightValleyIsOneContact)
{
    Real const rise = std::tan(3.14159265 / 180);
    PolylineSurface const surface(Polyline("bed", {{-1, 0, 0}, {0, 0, 0}, {1, rise, 0}}, false, Polyline::FluidSide::Left), depth);
    EXPECT_EQ(touch(surface, {0, 0.009, 0}, 0.01).size(), 1u);
}

TEST(ContactSurface, collinearPiecesBecomeOneSide)
{
    std::vector<Vector> points;
    for (int i = 0; i <= 20000; ++i) points.emplace_back(1e-4 * i, -1.7e-4 * i, 0);
    points.emplace_back(4.0, -3.4, 0);
    std::vector<Facet> const sides = facetsOf(Polyline("ramp", points, false, Polyline::FluidSide::Left));
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_NEAR(sides[0].length, std::hypot(2.0, 3.4), 1e-12);
    EXPECT_EQ(sides[0].jointB, Facet::Joint::Concave);
}

// The grid must find what a search through all sides finds: a circle of 1000 sides, touched from inside and outside at 700 places.
TEST(ContactSurface, gridMissesNothing)
{
    std::vector<Vector> points;
    for (int i = 0; i < 1000; ++i) points.emplace_back(std::cos(2e-3 * 3.14159265358979 * i), std::sin(2e-3 * 3.14159265358979 * i), 0);
    PolylineSurface const circle(Polyline::outline("circle", points), 0.01);
    for (int i = 0; i < 700; ++i)
    {
        Vector const direction(std::cos(0.009 * i), std::sin(0.009 * i), 0);
        ASSERT_EQ(touch(circle, 1.004 * direction, 0.005).size(), 1u) << i;
        ASSERT_EQ(touch(circle, 0.999 * direction, 0).size(), 1u) << i;
        ASSERT_EQ(touch(circle, 1.006 * direction, 0.005).size(), 0u) << i;
    }
}

TEST(ContactSurface, planeAndDisc)
{
    auto const onPlane = touch(PlaneSurface({0, 1, 0}, {0, 2, 0}), {5, 1.009, 0}, 0.01);
    ASSERT_EQ(onPlane.size(), 1u);
    EXPECT_NEAR(onPlane[0].gap, -0.001, 1e-15);
    auto const onDisc = touch(DiscSurface(0.5), {0.3, 0.4, 0}, 0.01);
    ASSERT_EQ(onDisc.size(), 1u);
    EXPECT_NEAR(onDisc[0].gap, -0.01, 1e-15);
    EXPECT_EQ(onDisc[0].radius, 0.5);
}

// The areas of a side's points sum to its area for every spacing, and every point touches the outline from inside.
TEST(ContactPoints, areasSumAndSurfaceIsTheOutline)
{
    Polyline const wedge = Polyline::outline("wedge", {{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}});
    for (Real const spacing : {0.04, 0.02, 0.0071})
    {
        ContactPointSet const set(ContactShape::polygon(wedge), spacing, 0.55);
        Real area = 0;
        int corners = 0;
        for (ContactPoint const& point : set.points())
        {
            area += point.area * (point.radius > 0 ? 1 : 2); // a corner counts on two sides
            corners += point.radius == 0;
            EXPECT_NEAR(-wedge.closest(point.centre).distance, point.radius, 1e-9);
        }
        EXPECT_NEAR(area, (1 + std::sqrt(0.5)) * 0.55, 1e-12);
        EXPECT_EQ(corners, 3);
        EXPECT_NEAR(set.largestSide(), std::sqrt(0.5) * 0.55, 1e-12);
    }
}

TEST(ContactPoints, openOutlineIsRefused)
{
    Polyline const open("open", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, false, Polyline::FluidSide::Left);
    EXPECT_THROW(ContactPointSet(ContactShape::polygon(open), 0.1, 1), CaseError);
}

} // namespace mpsDem
