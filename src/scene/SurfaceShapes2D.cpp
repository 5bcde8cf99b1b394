#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "scene/EntryText.h"
#include "scene/SurfaceShapes.h"

namespace mpsDem {

namespace {

using Side = Polyline::FluidSide;

std::vector<std::string> const alongSides{"left", "right"};
std::vector<std::string> const loopSides{"inside", "outside"}; // of a loop that is walked counter-clockwise

Vector readFlat(Dictionary const& dict, std::string const& key)
{
    Vector v = dict.get<Vector>(key);
    require(v.allFinite(), dict.where(key), key + " is not finite", "three numbers");
    v.z() = 0;
    return v;
}

std::unique_ptr<SurfaceShape> lineShape(Dictionary const& dict, std::vector<Vector> points, bool closed,
                                        std::vector<std::string> const& sides, std::string const& side)
{
    auto shape = std::make_unique<SurfaceShape>();
    shape->make = [points = std::move(points), closed](std::string const& name, bool first) {
        return Surface(Polyline(name, points, closed, first ? Side::Left : Side::Right));
    };
    shape->sides = sides;
    shape->side = dict.getWordOr("fluidSide", side, sides, "sides");
    return shape;
}

std::unique_ptr<SurfaceShape> makePolyline(Dictionary const& dict, GeometryContext const&)
{
    refuseInPlane(dict, {"zRange", "sideWalls"});
    return lineShape(dict, readPoints(dict, "points"), dict.getOr<bool>("closed", false), alongSides, "left");
}

std::unique_ptr<SurfaceShape> makeBox(Dictionary const& dict, GeometryContext const& context)
{
    Vector const a = readFlat(dict, "min"), b = readFlat(dict, "max");
    Real const depth = dict.get<Vector>("max").z() - dict.get<Vector>("min").z();
    warnOfDepth(dict.where("max"), "the box", std::abs(depth), context.lattice, false);
    require(a.x() < b.x() && a.y() < b.y(), dict.where("max"), "a box whose max is not above its min", "min < max in x and y");

    // Counter-clockwise from the lower left corner; side k runs from corner k to corner k + 1.
    std::array<Vector, 4> const corners{a, Vector(b.x(), a.y(), 0), b, Vector(a.x(), b.y(), 0)};
    std::vector<bool> const open = readOpenSides(dict, {"bottom", "right", "top", "left"});
    auto const count = std::count(open.begin(), open.end(), true);
    if (count == 0) return lineShape(dict, {corners.begin(), corners.end()}, true, loopSides, "inside");
    std::size_t begin = 0; // the first side that stands behind an open one
    while (begin < 4 && !(open[(begin + 3) % 4] && !open[begin])) ++begin;
    std::vector<Vector> points{corners[begin]};
    std::size_t passed = 0;
    for (; !open[(begin + passed) % 4]; ++passed) points.push_back(corners[(begin + passed + 1) % 4]);
    require(passed == static_cast<std::size_t>(4 - count), dict.where("open"), "the sides that are left of a box do not hang together",
            "make two surfaces of them");
    return lineShape(dict, points, false, loopSides, "inside");
}

std::unique_ptr<SurfaceShape> makePlate(Dictionary const& dict, GeometryContext const&)
{
    Vector const origin = readFlat(dict, "origin");
    return lineShape(dict, {origin, origin + readFlat(dict, "span")}, false, alongSides, "left");
}

std::unique_ptr<SurfaceShape> makeCircle(Dictionary const& dict, Vector const& centre, Real spacing)
{
    return lineShape(dict, circlePoints(centre, readPositive(dict, "radius"), spacing), true, loopSides, "outside");
}

std::unique_ptr<SurfaceShape> makeCylinder(Dictionary const& dict, GeometryContext const& context)
{
    Vector const centre = readFlat(dict, "point1");
    require((centre - readFlat(dict, "point2")).norm() < 1e-9 * (1 + centre.norm()), dict.where("point2"),
            "the axis of a cylinder is not along z", "point1 and point2 with the same x and y: a 2-D case sees the circle");
    return makeCircle(dict, centre, context.lattice.spacing);
}

std::unique_ptr<SurfaceShape> makeSphere(Dictionary const& dict, GeometryContext const& context)
{
    return makeCircle(dict, readFlat(dict, "centre"), context.lattice.spacing);
}

} // namespace

ShapeRegistry const& shapes2D()
{
    static ShapeRegistry const registry = [] {
        ShapeRegistry made("surface type", "surface types");
        made.add("polyline", makePolyline);
        made.add("searchableBox", makeBox);
        made.add("searchablePlate", makePlate);
        made.add("searchableCylinder", makeCylinder);
        made.add("searchableSphere", makeSphere);
        return made;
    }();
    return registry;
}

std::vector<bool> readOpenSides(Dictionary const& dict, std::vector<std::string> const& names)
{
    std::vector<bool> open(names.size(), false);
    for (std::string const& word : dict.getOr<std::vector<std::string>>("open", {}))
    {
        auto const found = std::find(names.begin(), names.end(), word);
        refuseInPlane(dict.where("open"), "side", word, names, {"back", "front"});
        require(found != names.end(), dict.where("open"), "a box has no side \"" + word + "\"", knownWords("sides", word, names));
        open[static_cast<std::size_t>(found - names.begin())] = true;
    }
    std::string all;
    for (std::string const& name : names) all += " " + name;
    require(std::find(open.begin(), open.end(), false) != open.end(), dict.where("open"), "all sides of a box are open", "some of" + all);
    return open;
}

std::vector<Vector> circlePoints(Vector const& centre, Real radius, Real spacing)
{
    Real const sides = std::numbers::pi / std::sqrt(2 * 0.005 * spacing / radius);
    int const count = 4 * static_cast<int>(std::ceil(std::clamp(sides, 64.0, 4096.0) / 4));
    std::vector<Vector> points;
    for (int k = 0; k < count; ++k)
    {
        Real const angle = 2 * std::numbers::pi * k / count;
        points.emplace_back(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle), 0);
    }
    return points;
}

} // namespace mpsDem
