#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "boundaries/SurfaceRows.h"
#include "boundaries/TriangleTree.h"
#include "particles/CellGrid.h"
#include "particles/Kernel.h"
#include "support/Measured.h"

namespace {

using namespace mpsDem;
using test::expectBelow;
using test::expectBetween;
using Open = std::array<bool, 6>;

constexpr Real spacing = 0.02;

BoundaryRows rowsOf(std::vector<TriSurface> const& surfaces, int ghostRows = 2)
{
    return boundaryRows(surfaces, std::vector<int>(surfaces.size(), ghostRows), spacing);
}

int count(BoundaryRows const& rows, ParticleType type) { return static_cast<int>(std::count(rows.type.begin(), rows.type.end(), type)); }

/// Surface over a grid of heights z(x, y), fluid above.
template <class Height>
TriSurface raster(Vector const& low, Vector const& high, Real cell, Height height)
{
    int const nx = static_cast<int>(std::lround((high.x() - low.x()) / cell)),
              ny = static_cast<int>(std::lround((high.y() - low.y()) / cell));
    std::vector<Vector> points;
    std::vector<TriSurface::Corners> triangles;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
        {
            Real const x = low.x() + (high.x() - low.x()) * i / nx, y = low.y() + (high.y() - low.y()) * j / ny;
            points.emplace_back(x, y, height(x, y));
            int const k = j * (nx + 1) + i;
            if (i == nx || j == ny) continue;
            triangles.push_back({k, k + 1, k + nx + 2});
            triangles.push_back({k, k + nx + 2, k + nx + 1});
        }
    return TriSurface("bed", points, triangles);
}

/// Extruded along y instead of z: x-z profiles with z up.
TriSurface upright(TriSurface const& s, Real width)
{
    Tensor turn;
    turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return s.moved(turn, Vector(0, width, 0));
}

/// Distances between particles and to the surfaces.
struct Summary
{
    Real least = std::numeric_limits<Real>::infinity();      ///< Distance of two particles [spacings].
    Real shallowest = std::numeric_limits<Real>::infinity(); ///< Depth of a particle [spacings]; below zero on the fluid side.
};

Summary summaryOf(BoundaryRows const& rows, std::vector<TriSurface> const& surfaces)
{
    Summary sum;
    CellGrid grid;
    grid.build(rows.position, 1.2 * spacing, 3);
    TriangleTree const tree(surfaces);
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        sum.shallowest = std::min(sum.shallowest, -tree.distance(rows.position[i]) / spacing);
        grid.forEachWithin(rows.position[i], 1.2 * spacing, [&](int j, Vector const&, Real r2) {
            if (j != static_cast<int>(i)) sum.least = std::min(sum.least, std::sqrt(r2) / spacing);
        });
    }
    return sum;
}

/// Greatest distance from a place half a spacing behind the surface to the nearest wall particle [spacings], over places that are that
/// deep below all surfaces (near edges of the solid some are not) and that `counts(foot)`.
template <class Counts>
Real greatestHole(BoundaryRows const& rows, std::vector<TriSurface> const& surfaces, Counts counts)
{
    std::vector<Vector> walls;
    for (std::size_t i = 0; i < rows.position.size(); ++i)
        if (rows.type[i] == ParticleType::Wall) walls.push_back(rows.position[i]);
    CellGrid grid;
    grid.build(walls, 2 * spacing, 3);
    TriangleTree const tree(surfaces);
    Real hole = 0;
    for (TriSurface const& s : surfaces)
        for (auto const& t : s.triangles())
        {
            Vector const a = s.point(t, 0), ab = s.point(t, 1) - a, ac = s.point(t, 2) - a;
            int const parts = std::clamp(static_cast<int>(std::max({ab.norm(), ac.norm(), (ac - ab).norm()}) / (0.2 * spacing)), 1, 400);
            for (int i = 0; i < parts; ++i)
                for (int j = 0; i + j < parts; ++j)
                {
                    Vector const foot = a + (i + 1.0 / 3) / parts * ab + (j + 1.0 / 3) / parts * ac;
                    Vector const place = foot - 0.5 * spacing * t.normal;
                    if (!counts(foot) || std::abs(tree.distance(place) + 0.5 * spacing) > 1e-6 * spacing) continue;
                    if (tree.distance(foot + 1e-4 * spacing * t.normal) < 0) continue; // behind another surface
                    Real nearest = 2 * spacing;
                    grid.forEachWithin(place, 2 * spacing,
                                       [&](int, Vector const&, Real r2) { nearest = std::min(nearest, std::sqrt(r2)); });
                    hole = std::max(hole, nearest / spacing);
                }
        }
    return hole;
}

bool anywhere(Vector const&) { return true; }

/// Rules that hold for every set of surfaces.
void checkRules(std::string const& name, BoundaryRows const& rows, std::vector<TriSurface> const& surfaces, Real shallowest = 0.48,
                bool (*counts)(Vector const&) = anywhere)
{
    std::printf("%s: %d wall and %d ghost particles\n", name.c_str(), count(rows, ParticleType::Wall), count(rows, ParticleType::Ghost));
    Summary const sum = summaryOf(rows, surfaces);
    expectBetween(name + ": least distance", sum.least, 0.7, 1.2);
    expectBetween(name + ": least depth", sum.shallowest, shallowest - 1e-9, 0.5 + 1e-9);
    expectBelow(name + ": greatest hole of the wall row", greatestHole(rows, surfaces, counts), 0.95);
    for (std::size_t i = 0; i < rows.position.size(); ++i) ASSERT_NEAR(rows.normal[i].norm(), 1, 1e-9);
    BoundaryRows const again = boundaryRows(surfaces, std::vector<int>(surfaces.size(), 2), spacing);
    ASSERT_EQ(again.position.size(), rows.position.size());
    EXPECT_EQ(std::memcmp(again.position.data(), rows.position.data(), rows.position.size() * sizeof(Vector)), 0);
}

/// Number density over n0 of places, from fluid on a lattice and all boundary particles.
struct Density
{
    Density(std::vector<Vector> points, Real radius) : kernel{radius * spacing}
    {
        grid.build(points, kernel.re, 3);
        for (int i = -5; i <= 5; ++i)
            for (int j = -5; j <= 5; ++j)
                for (int k = -5; k <= 5; ++k)
                    if (i != 0 || j != 0 || k != 0) n0 += kernel(spacing * Vector(i, j, k).norm());
    }
    [[nodiscard]] Real at(Vector const& r) const
    {
        Real n = 0;
        grid.forEachWithin(r, kernel.re,
                           [&](int, Vector const&, Real r2) { n += r2 > 1e-12 * spacing * spacing ? kernel(std::sqrt(r2)) : 0; });
        return n / n0;
    }
    Kernel kernel;
    CellGrid grid;
    Real n0 = 0;
};

TEST(SurfaceRows, ClosedTankContinuesTheLattice)
{
    std::array<int, 3> const n{10, 7, 5};
    std::vector<TriSurface> const tank{TriSurface::box("tank", {0, 0, 0}, {10 * spacing, 7 * spacing, 5 * spacing}).flipped()};
    for (int const ghosts : {2, 4})
    {
        auto const rows = rowsOf(tank, ghosts);
        Real off = 0;
        for (Vector const& r : rows.position)
            for (int d = 0; d < 3; ++d) off = std::max(off, std::abs(r[d] / spacing - 0.5 - std::round(r[d] / spacing - 0.5)));
        expectBelow("off the lattice", off, 1e-9);
        int const b = 2 * (ghosts + 1);
        EXPECT_EQ(static_cast<int>(rows.position.size()), (n[0] + b) * (n[1] + b) * (n[2] + b) - n[0] * n[1] * n[2]);
        EXPECT_EQ(count(rows, ParticleType::Wall), 2 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]) + 4 * (n[0] + n[1] + n[2]));
        std::vector<Vector> all = rows.position, fluid;
        for (int i = 0; i < n[0]; ++i)
            for (int j = 0; j < n[1]; ++j)
                for (int k = 0; k < n[2]; ++k) fluid.push_back(spacing * (Vector(i, j, k) + Vector::Constant(0.5)));
        all.insert(all.end(), fluid.begin(), fluid.end());
        Density const density(all, ghosts == 2 ? 2.1 : 4.01);
        Real worst = 0;
        for (Vector const& r : fluid) worst = std::max(worst, std::abs(density.at(r) - 1));
        expectBelow("number density less n0", worst, 1e-3);
    }
    checkRules("closed tank", rowsOf(tank), tank);
}

TEST(SurfaceRows, OpenTankGoesOnAsGhostsAboveItsRim)
{
    std::vector<TriSurface> const tank{
        TriSurface::box("tank", {0, 0, 0}, {10 * spacing, 7 * spacing, 5 * spacing}, {false, false, false, false, false, true}).flipped()};
    auto const rows = rowsOf(tank);
    EXPECT_EQ(static_cast<int>(rows.position.size()), 16 * 13 * 3 + (16 * 13 - 10 * 7) * (5 + 4));
    EXPECT_EQ(count(rows, ParticleType::Wall), 10 * 7 + 2 * (10 + 7) * 6 + 4 * 5);
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        bool const above = rows.position[i].z() > 5 * spacing;
        EXPECT_FALSE(above && rows.type[i] == ParticleType::Wall);
    }
    checkRules("open tank", rows, tank);
}

TEST(SurfaceRows, SidesOfATankAsSurfacesOfTheirOwnJoinLikeOne)
{
    std::vector<TriSurface> sides;
    for (std::size_t k = 0; k < 6; ++k)
    {
        Open open{true, true, true, true, true, true};
        open[k] = false;
        sides.push_back(TriSurface::box("side", {0, 0, 0}, {10 * spacing, 7 * spacing, 5 * spacing}, open).flipped());
    }
    auto const one = rowsOf({TriSurface::box("tank", {0, 0, 0}, {10 * spacing, 7 * spacing, 5 * spacing}).flipped()}), six = rowsOf(sides);
    ASSERT_EQ(one.position.size(), six.position.size());
    EXPECT_EQ(count(one, ParticleType::Wall), count(six, ParticleType::Wall));
    CellGrid grid;
    grid.build(one.position, spacing, 3);
    for (Vector const& r : six.position)
    {
        int found = 0;
        grid.forEachWithin(r, 1e-6 * spacing, [&](int, Vector const&, Real) { ++found; });
        ASSERT_EQ(found, 1);
    }
}

TEST(SurfaceRows, RampAndFloorBetweenSideWalls)
{
    Real const width = 8 * spacing, length = 40 * spacing, height = 16 * spacing;
    std::vector<Vector> const profile{{0, height, 0}, {height, 0, 0}, {length, 0, 0}, {length, height, 0}};
    TriSurface const closed = TriSurface::prism("tank", profile, 0, width).flipped();
    std::vector<TriSurface> const tank{upright(closed, width)};
    checkRules("ramp, floor and side walls", rowsOf(tank), tank);
}

TEST(SurfaceRows, RampThroughABox)
{
    Vector const size(40 * spacing, 8 * spacing, 16 * spacing);
    TriSurface const box = TriSurface::box("tank", {0, 0, 0}, size, {false, false, false, false, false, true}).flipped();
    for (Real const beyond : {0.0, 3.3 * spacing})
    {
        std::vector<Vector> const chain{{-beyond, 12 * spacing + beyond, 0}, {12 * spacing + beyond, -beyond, 0}};
        std::vector<TriSurface> const surfaces{
            box, upright(TriSurface::extruded("ramp", chain, false, -beyond, size.y() + beyond, true), size.y())};
        auto const rows = rowsOf(surfaces);
        checkRules(beyond > 0 ? "ramp that cuts a box" : "ramp that ends at a box", rows, surfaces);
        // Behind the ramp only its own rows and what fills the corners: nothing 4.5 spacings behind it.
        for (Vector const& r : rows.position)
            EXPECT_GT((r.x() + r.z() - 12 * spacing) / std::sqrt(2.0), -4.5 * spacing) << r.transpose() / spacing;
    }
}

TEST(SurfaceRows, CubeHasShellsOfTheLattice)
{
    std::vector<TriSurface> const cube{TriSurface::box("cube", {0, 0, 0}, Vector::Constant(10 * spacing))};
    auto const rows = rowsOf(cube);
    EXPECT_EQ(count(rows, ParticleType::Wall), 1000 - 512);
    EXPECT_EQ(count(rows, ParticleType::Ghost), 512 - 64);
    expectBetween("cube: least distance", summaryOf(rows, cube).least, 1 - 1e-9, 1 + 1e-9);
    checkRules("cube", rows, cube);
}

TEST(SurfaceRows, WedgeIsSampledIntoItsTips)
{
    std::vector<TriSurface> const wedge{TriSurface::prism("slide", {{0.01, 0.99, 0}, {0.51, 0.49, 0}, {0.51, 0.99, 0}}, 0, 10 * spacing)};
    auto const rows = rowsOf(wedge);
    checkRules("wedge", rows, wedge, 0.2);
    for (Vector const& tip : {Vector(0.01, 0.99, 5 * spacing), Vector(0.51, 0.49, 5 * spacing)})
    {
        Real nearest = std::numeric_limits<Real>::infinity();
        for (std::size_t i = 0; i < rows.position.size(); ++i)
            if (rows.type[i] == ParticleType::Wall) nearest = std::min(nearest, (rows.position[i] - tip).norm() / spacing);
        expectBelow("wedge: nearest to a tip", nearest, 1.8); // 1.7 in the plane, half a spacing along the edge
    }
}

TEST(SurfaceRows, SphereHasEvenRows)
{
    Real const radius = 6 * spacing;
    for (Real const edge : {0.3, 1.5})
    {
        std::vector<TriSurface> const ball{TriSurface::sphere("ball", {0.3, 0.2, 0.1}, radius, edge * spacing)};
        auto const rows = rowsOf(ball, 5);
        std::vector<int> number(6, 0);
        for (Vector const& r : rows.position)
        {
            Real const row = (radius - (r - Vector(0.3, 0.2, 0.1)).norm()) / spacing - 0.5;
            ASSERT_TRUE(std::lround(row) >= 0 && std::lround(row) < 6) << row;
            ++number[static_cast<std::size_t>(std::lround(row))];
        }
        for (int k = 0; k < 4; ++k)
        {
            Real const r = radius / spacing - k - 0.5;
            expectBetween("sphere: particles of row " + std::to_string(k) + " over its area",
                          number[static_cast<std::size_t>(k)] / (4 * std::numbers::pi * r * r), k < 3 ? 0.94 : 0.9, k < 3 ? 1.06 : 1.1);
        }
        checkRules("sphere", rowsOf(ball), ball);
    }
}

TEST(SurfaceRows, CylinderHasEvenRows)
{
    Real const radius = 5 * spacing, length = 12 * spacing;
    std::vector<TriSurface> const body{TriSurface::cylinder("log", {0, 0, 0}, {0, 0, length}, radius, 60)};
    auto const rows = rowsOf(body);
    Real const r = radius / spacing - 0.5, h = length / spacing - 1;
    expectBetween("cylinder: wall particles over area", count(rows, ParticleType::Wall) / (2 * std::numbers::pi * r * (h + r)), 0.94, 1.08);
    checkRules("cylinder", rows, body);
}

bool inMiddle(Vector const& r) { return r.x() > 2 * spacing && r.x() < 46 * spacing && r.y() > 2 * spacing && r.y() < 46 * spacing; }

TEST(SurfaceRows, WavyBathymetryHasEvenRows)
{
    Vector const low(0, 0, -0.1), high(48 * spacing, 48 * spacing, 0.1);
    for (Real const cell : {0.6, 2.0})
    {
        std::vector<TriSurface> const bed{raster(low, high, cell * spacing, [](Real x, Real y) {
            return 3 * spacing * std::sin(x / (6 * spacing)) * std::cos(y / (7 * spacing));
        })};
        auto const rows = rowsOf(bed);
        checkRules("wavy bed", rows, bed, 0.48, inMiddle);
        int walls = 0;
        for (std::size_t i = 0; i < rows.position.size(); ++i) walls += rows.type[i] == ParticleType::Wall ? 1 : 0;
        expectBetween("wavy bed: wall particles over area", walls * spacing * spacing / bed[0].area(), 0.95, 1.05);
    }
}

TEST(SurfaceRows, BathymetryBetweenTheWallsOfABox)
{
    // The bed goes on past the walls, or ends at them.
    Vector const size(30 * spacing, 20 * spacing, 20 * spacing);
    TriSurface const box = TriSurface::box("tank", {0, 0, 0}, size, {false, false, false, false, false, true}).flipped();
    for (Real const beyond : {0.0, 3.5 * spacing})
    {
        Vector const past(beyond, beyond, 0);
        std::vector<TriSurface> const surfaces{box, raster(-past, size + past, 0.7 * spacing, [](Real x, Real y) {
                                                   return 8 * spacing +
                                                          2 * spacing * std::sin(x / (5 * spacing)) * std::cos(y / (6 * spacing));
                                               })};
        auto const rows = rowsOf(surfaces);
        checkRules(beyond > 0 ? "bed past the walls" : "bed up to the walls", rows, surfaces);
        Real deepest = 0;
        for (Vector const& r : rows.position) deepest = std::max(deepest, 6 - r.z() / spacing);
        expectBelow("depth of particles below the lowest bed", deepest, 5);
    }
}

TEST(SurfaceRows, SpreadRowsGiveTheFluidItsNumberDensity)
{
    // A floor rough by a hundredth of a spacing: no plane, so that particles are spread and not laid in lines.
    Real const side = 40 * spacing;
    std::vector<TriSurface> const bed{raster({0, 0, 0}, {side, side, 0}, 0.8 * spacing,
                                             [](Real x, Real y) { return 0.01 * spacing * std::sin(7e3 * x * y + 3e2 * x + 5e2 * y); })};
    auto const rows = rowsOf(bed);
    std::vector<Vector> all = rows.position, asked;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j)
            for (int k = 0; k < 4; ++k)
            {
                all.push_back(spacing * (Vector(i, j, k) + Vector::Constant(0.5)));
                if (k == 0 && std::min({i, j, 39 - i, 39 - j}) >= 3) asked.push_back(all.back());
            }
    for (Real const radius : {2.1, 3.1})
    {
        Density const density(all, radius);
        Real sum = 0, squares = 0;
        for (Vector const& r : asked)
        {
            sum += density.at(r) - 1;
            squares += std::pow(density.at(r) - 1, 2);
        }
        Real const mean = sum / static_cast<Real>(asked.size());
        expectBelow("rough floor: mean number density less n0", mean, 0.02);
        expectBelow("rough floor: its spread", std::sqrt(squares / static_cast<Real>(asked.size()) - mean * mean), 0.05);
    }
}

TEST(SurfaceRows, ValleysAndRidgesHaveNeitherHolesNorPairs)
{
    for (Real const degrees : {90.0, 60.0, 135.0})
        for (Real const sign : {1.0, -1.0})
        {
            Real const slope = std::tan((90 - degrees / 2) * std::numbers::pi / 180);
            std::vector<TriSurface> const bed{raster({0, 0, 0}, {48 * spacing, 48 * spacing, 0}, 0.8 * spacing,
                                                     [&](Real x, Real) { return sign * slope * std::abs(x - 24 * spacing); })};
            std::string const name = (sign > 0 ? "valley of " : "ridge of ") + std::to_string(static_cast<int>(degrees)) + " degrees";
            checkRules(name, rowsOf(bed), bed, degrees < 90 && sign < 0 ? 0.2 : 0.48, inMiddle);
        }
}

} // namespace
