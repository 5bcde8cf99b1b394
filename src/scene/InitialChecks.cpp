#include "scene/InitialChecks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <sstream>

#include "boundaries/SurfaceTree.h"
#include "core/Errors.h"
#include "particles/CellGrid.h"

namespace mpsDem {

namespace {

constexpr Real deepestInWall = 0.5;  ///< Greatest overlap of a body and a wall, in spacings.
constexpr Real deepestInBody = 0.05; ///< Of two bodies.

std::string text(Real value)
{
    std::ostringstream out;
    out << value;
    return out.str();
}

/// Points of the surface, corners among them.
std::vector<Vector> samplesOf(Surface const& surface, Real spacing)
{
    std::vector<Vector> samples;
    if (surface.flat())
    {
        for (auto const& segment : surface.line().segments())
        {
            int const parts = std::max(1, static_cast<int>(std::ceil(segment.length / (0.25 * spacing))));
            for (int i = 0; i < parts; ++i) samples.push_back(segment.a + (segment.length * i / parts) * segment.tangent);
        }
        return samples;
    }
    TriSurface const& triangles = surface.triangles();
    for (auto const& t : triangles.triangles())
    {
        Vector const a = triangles.point(t, 0), b = triangles.point(t, 1) - a, c = triangles.point(t, 2) - a;
        Real const longest = std::max({b.norm(), c.norm(), (b - c).norm()});
        int const parts = std::clamp(static_cast<int>(std::ceil(longest / (0.5 * spacing))), 1, 500);
        for (int j = 0; j <= parts; ++j)
            for (int i = 0; i + j <= parts; ++i) samples.push_back(a + (Real(i) / parts) * b + (Real(j) / parts) * c);
    }
    return samples;
}

std::string text(Vector const& r) { return "(" + text(r.x()) + " " + text(r.y()) + " " + text(r.z()) + ")"; }

} // namespace

Gap gapTo(Surface const& outline, std::vector<Surface> const& surfaces, Real spacing, Vector const& up)
{
    Gap gap;
    gap.distance = std::numeric_limits<Real>::infinity();
    if (surfaces.empty()) return gap;
    SurfaceTree const tree(surfaces), own({outline});
    Real const equal = 1e-6 * spacing;
    auto const keep = [&](Real distance, Vector const& place, Vector const& normal, int other) {
        bool const higher = distance < gap.distance + equal && up.dot(normal) > up.dot(gap.normal) + 1e-9;
        bool const nearer = distance < gap.distance && !(distance > gap.distance - equal && up.dot(normal) < up.dot(gap.normal) - 1e-9);
        if (higher || nearer) gap = {distance, place, normal, other};
    };
    for (Vector const& q : samplesOf(outline, spacing))
    {
        auto const near = tree.nearest(q);
        keep(near.atRim ? std::abs(near.distance) : near.distance, q, near.normal, near.surface);
    }
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        for (Vector const& corner : surfaces[k].points())
        {
            auto const near = own.nearest(corner);
            keep(near.distance, corner, -near.normal, static_cast<int>(k));
        }
    return gap;
}

Real boxDistance(Surface const& a, Surface const& b)
{
    SurfaceTree const first({a}), second({b});
    return (first.low() - second.high()).cwiseMax(second.low() - first.high()).cwiseMax(Vector::Zero()).norm();
}

/// A place that lies deeper than `depth` in both of two closed outlines. gapTo looks at outlines alone: a body on a copy of itself seems to touch it.
std::optional<Vector> placeInBoth(Surface const& first, Surface const& second, Real depth, Real spacing)
{
    SurfaceTree const a({first}), b({second});
    for (Vector const& q : samplesOf(first, spacing))
    {
        Vector const within = q - 2 * depth * a.nearest(q).normal;
        if (a.nearest(within).distance < -depth && b.nearest(within).distance < -depth) return within;
    }
    return std::nullopt;
}

void checkPlacement(SceneDefinition const& definition, std::vector<Surface> const& surfaces, std::vector<Surface> const& bodies)
{
    Real const spacing = definition.lattice.spacing;
    for (std::size_t k = 0; k < bodies.size(); ++k)
    {
        Location const& where = definition.shapes[k].where;
        Gap const toWall = gapTo(bodies[k], surfaces, spacing);
        if (toWall.other >= 0)
            require(toWall.distance >= -deepestInWall * spacing, where,
                    "body \"" + bodies[k].name() + "\" reaches " + text(-toWall.distance) + " m into wall \"" +
                        surfaces[static_cast<std::size_t>(toWall.other)].name() + "\" at " + text(toWall.place),
                    "no more than half a spacing, " + text(deepestInWall * spacing) + " m");
        for (std::size_t other = 0; other < k; ++other)
        {
            if (boxDistance(bodies[k], bodies[other]) > 0) continue;
            Gap const between = gapTo(bodies[k], {bodies[other]}, spacing);
            require(between.distance >= -deepestInBody * spacing, where,
                    "bodies \"" + bodies[other].name() + "\" and \"" + bodies[k].name() + "\" overlap by " + text(-between.distance) +
                        " m at " + text(between.place),
                    "no more than " + text(deepestInBody * spacing) + " m");
            auto const both = placeInBoth(bodies[k], bodies[other], deepestInBody * spacing, spacing);
            require(!both, where,
                    "bodies \"" + bodies[other].name() + "\" and \"" + bodies[k].name() + "\" both hold the place " +
                        (both ? text(*both) : std::string()),
                    "bodies that touch at most; a copy needs another place");
        }
    }
}

void checkFilling(SceneDefinition const& definition, FluidFilling const& fluid)
{
    Field<int> left(definition.regions.size(), 0);
    for (int const region : fluid.region) ++left[static_cast<std::size_t>(region)];
    for (std::size_t k = 0; k < definition.regions.size(); ++k)
    {
        Region const& region = *definition.regions[k];
        require(fluid.count[k] > 0, region.where, region.type + " holds no particle",
                "a region wider than the spacing of " + text(definition.lattice.spacing) + " m that is not covered by those behind it");
        require(left[k] > 0, region.where,
                "all " + std::to_string(fluid.count[k]) + " particles of " + region.type + " lie within bodies or behind walls",
                "a region with fluid outside of solids; see fluidSide of the walls");
    }
}

std::vector<Real> nearestDistances(std::span<Vector const> points, Range const& of, Real reach, int dimensions)
{
    CellGrid grid;
    grid.build(points, reach, dimensions);
    std::vector<Real> result;
    for (int const i : of)
    {
        Real nearest2 = std::numeric_limits<Real>::infinity();
        grid.forEachWithin(points[static_cast<std::size_t>(i)], reach, [&](int j, Vector const&, Real r2) {
            if (j != i) nearest2 = std::min(nearest2, r2);
        });
        result.push_back(std::sqrt(nearest2));
    }
    return result;
}

} // namespace mpsDem
