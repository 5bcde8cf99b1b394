// Contact points of bodies that are triangle surfaces.

#include <numbers>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "dem/ContactPoints.h"
#include "dem/MeshSurface.h"
#include "dem/SurfaceLines.h"
#include "support/SolidScene.h"

namespace mpsDem::test {

namespace {

/// Area of all points that touch the plane through `point` with that outward normal [m2].
Real areaOn(ContactPointSet const& set, Vector const& point, Vector const& normal)
{
    Real sum = 0;
    for (ContactPoint const& p : set.points())
        if (std::abs((p.centre - point).dot(normal) + p.radius) < 1e-9) sum += p.area;
    return sum;
}

/// Largest part of a sphere that stands out of the surface, and the farthest that one stays away from it [m].
std::pair<Real, Real> misfit(ContactPointSet const& set, TriSurface const& surface)
{
    MeshSurface const skin(surface, 1);
    Real out = 0, away = 0;
    std::vector<ContactFeature> features;
    for (ContactPoint const& p : set.points())
    {
        features.clear();
        std::vector<Sphere> const sphere{{p.centre, 0}};
        skin.collect(sphere, 0.01, features);
        Real least = 1e300;
        for (ContactFeature const& f : features) least = std::min(least, std::abs(f.gap));
        out = std::max(out, p.radius - least);
        away = std::max(away, least - p.radius);
    }
    return {out, away};
}

TriSurface wedge() { return TriSurface::prism("wedge", {{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}}, -0.275, 0.275); }

} // namespace

TEST(SurfacePoints, areasOfEachFaceSumForEverySpacing)
{
    Vector const size(0.3, 0.2, 0.1);
    for (Real const spacing : {0.05, 0.02, 0.0071})
    {
        ContactPointSet const box(ContactShape::mesh(TriSurface::box("box", -0.5 * size, 0.5 * size)), spacing, spacing);
        for (int axis = 0; axis < 3; ++axis)
            for (Real const sign : {-1.0, 1.0})
            {
                Vector const normal = sign * Vector::Unit(axis);
                EXPECT_NEAR(areaOn(box, 0.5 * size[axis] * normal, normal) * size[axis] / size.prod(), 1, 1e-9);
            }
        EXPECT_NEAR(box.largestSide(), 0.06, 1e-15);
        ContactPointSet const slide(ContactShape::mesh(wedge()), spacing, spacing);
        Real const c = std::numbers::sqrt2 / 2;
        EXPECT_NEAR(areaOn(slide, {0, 0, 0}, {-c, c, 0}), 0.55 * 0.5 / c, 1e-9);
        EXPECT_NEAR(areaOn(slide, {0, 0, 0}, {0, -1, 0}), 0.55 * 0.5, 1e-9);
        EXPECT_NEAR(areaOn(slide, {0, 0, 0.275}, {0, 0, 1}), 0.125, 1e-9);
        EXPECT_NEAR(slide.largestSide(), 0.55 * 0.5 / c, 1e-12);
    }
}

TEST(SurfacePoints, everyPointTouchesTheSurfaceFromInside)
{
    for (TriSurface const& surface :
         {wedge(), TriSurface::box("box", {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}),
          TriSurface::cylinder("rod", {0, 0, -0.2}, {0, 0, 0.2}, 0.1, 48), TriSurface::sphere("ball", Vector::Zero(), 0.1, 0.02)})
    {
        ContactPointSet const set(ContactShape::mesh(surface), 0.02, 0.02);
        auto const [out, away] = misfit(set, surface);
        expectBelow(surface.name() + ": sphere outside of its surface [m]", out, 1e-9);
        expectBelow(surface.name() + ": sphere away from its surface [m]", away, 1e-9);
        EXPECT_GT(set.points().size(), 100u);
    }
}

// A face of a cube has a regular grid, four corners and points along its edges; the cuts of its mesh do not matter.
TEST(SurfacePoints, regularOnPlaneFaces)
{
    ContactPointSet const cube(ContactShape::mesh(TriSurface::box("cube", -0.1 * Vector::Ones(), 0.1 * Vector::Ones())), 0.02, 0.02);
    int spheres = 0, edges = 0;
    for (ContactPoint const& p : cube.points())
    {
        (p.radius > 0 ? spheres : edges) += 1;
        EXPECT_LE(p.radius, 0.01);
    }
    EXPECT_EQ(spheres, 600);
    EXPECT_EQ(edges, 8 + 12 * 10);
    EXPECT_EQ(sharpCorners(wedge()).size(), 6u);
}

// Of a curved surface each point stands for about dx^2, and the whole for its area.
TEST(SurfacePoints, curvedSurfacesHavePointsOfEqualArea)
{
    TriSurface const ball = TriSurface::sphere("ball", Vector::Zero(), 0.1, 0.01);
    ContactPointSet const set(ContactShape::mesh(ball), 0.02, 0.02);
    Real sum = 0, least = 1, most = 0;
    Vector moment = Vector::Zero();
    for (ContactPoint const& p : set.points())
    {
        sum += p.area;
        moment += p.area * p.centre;
        least = std::min(least, p.area);
        most = std::max(most, p.area);
        EXPECT_GT(p.radius, 0);
    }
    EXPECT_NEAR(sum / ball.area(), 1, 1e-12);
    expectBelow("ball: centre of the areas / radius", moment.norm() / sum / 0.1, 1e-3);
    expectBetween("ball: least area of a point / dx^2", least / 4e-4, 0.3, 1);
    expectBetween("ball: largest area of a point / dx^2", most / 4e-4, 1, 3);
    EXPECT_EQ(set.largestSide(), 4e-4);
}

// The rim of a cylinder of 48 sides is one sharp line, not 48.
TEST(SurfacePoints, linesRunThroughTheCutsOfAMesh)
{
    TriSurface const rod = TriSurface::cylinder("rod", {0, 0, -0.2}, {0, 0, 0.2}, 0.1, 48);
    auto const points = pointsOnSharpLines(rod, 0.02);
    Real length = 0;
    for (LinePoint const& point : points) length += point.length;
    EXPECT_NEAR(length, 2 * 48 * 0.2 * std::sin(std::numbers::pi / 48), 1e-12);
    EXPECT_EQ(points.size(), 62u);
    EXPECT_TRUE(sharpCorners(rod).empty());
    TriSurface const cone("cone", {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}});
    EXPECT_EQ(sharpCorners(cone).size(), 5u);
}

TEST(SurfacePoints, openSurfaceIsRefused) { EXPECT_THROW(ContactPointSet(ContactShape::mesh(floorMesh()), 0.1, 0.1), CaseError); }

} // namespace mpsDem::test
