#include "scene/GeometryReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "boundaries/BoundaryRows.h"
#include "core/Errors.h"
#include "core/Registry.h"
#include "scene/EntryText.h"

namespace mpsDem {

namespace {

using Side = Polyline::FluidSide;

/// A surface before its fluid side is settled.
struct SurfaceShape
{
    std::vector<Vector> points;
    bool closed = false;
    std::vector<std::string> sides; ///< Words that name Left and Right, in this order.
    std::string side;               ///< The one that holds unless a wall says otherwise.
};

using ShapeRegistry = Registry<SurfaceShape, Dictionary const&, Real>;

std::vector<std::string> const alongSides{"left", "right"};
std::vector<std::string> const loopSides{"inside", "outside"}; // of a loop that is walked counter-clockwise

Vector readFlat(Dictionary const& dict, std::string const& key)
{
    Vector v = dict.get<Vector>(key);
    require(v.allFinite(), dict.where(key), key + " is not finite", "three numbers");
    v.z() = 0;
    return v;
}

std::unique_ptr<SurfaceShape> makePolyline(Dictionary const& dict, Real)
{
    auto shape = std::make_unique<SurfaceShape>();
    shape->points = readPoints(dict, "points");
    shape->closed = dict.getOr<bool>("closed", false);
    shape->sides = alongSides;
    shape->side = dict.getWordOr("fluidSide", "left", alongSides, "sides");
    return shape;
}

std::unique_ptr<SurfaceShape> makeBox(Dictionary const& dict, Real)
{
    Vector const a = readFlat(dict, "min"), b = readFlat(dict, "max");
    require(a.x() < b.x() && a.y() < b.y(), dict.where("max"), "a box whose max is not above its min", "min < max in x and y");
    auto shape = std::make_unique<SurfaceShape>();
    shape->sides = loopSides;
    shape->side = dict.getWordOr("fluidSide", "inside", loopSides, "sides");

    // Counter-clockwise from the lower left corner; side k runs from corner k to corner k + 1.
    std::array<Vector, 4> const corners{a, Vector(b.x(), a.y(), 0), b, Vector(a.x(), b.y(), 0)};
    std::vector<std::string> const names{"bottom", "right", "top", "left"};
    std::array<bool, 4> open{};
    for (std::string const& word : dict.getOr<std::vector<std::string>>("open", {}))
    {
        auto const found = std::find(names.begin(), names.end(), word);
        require(found != names.end(), dict.where("open"), "a box has no side \"" + word + "\"", knownWords("sides", word, names));
        open[static_cast<std::size_t>(found - names.begin())] = true;
    }
    auto const count = std::count(open.begin(), open.end(), true);
    shape->closed = count == 0;
    if (shape->closed)
    {
        shape->points.assign(corners.begin(), corners.end());
        return shape;
    }
    std::size_t begin = 0; // the first side that stands behind an open one
    while (begin < 4 && !(open[(begin + 3) % 4] && !open[begin])) ++begin;
    require(begin < 4, dict.where("open"), "all sides of a box are open", "one to three of left right bottom top");
    shape->points.push_back(corners[begin]);
    std::size_t passed = 0;
    for (; !open[(begin + passed) % 4]; ++passed) shape->points.push_back(corners[(begin + passed + 1) % 4]);
    require(passed == static_cast<std::size_t>(4 - count), dict.where("open"), "the sides that are left of a box do not hang together",
            "make two surfaces of them");
    return shape;
}

std::unique_ptr<SurfaceShape> makePlate(Dictionary const& dict, Real)
{
    Vector const origin = readFlat(dict, "origin");
    auto shape = std::make_unique<SurfaceShape>();
    shape->points = {origin, origin + readFlat(dict, "span")};
    shape->sides = alongSides;
    shape->side = dict.getWordOr("fluidSide", "left", alongSides, "sides");
    return shape;
}

std::unique_ptr<SurfaceShape> makeCircle(Dictionary const& dict, Vector const& centre, Real spacing)
{
    auto shape = std::make_unique<SurfaceShape>();
    shape->points = circlePoints(centre, readPositive(dict, "radius"), spacing);
    shape->closed = true;
    shape->sides = loopSides;
    shape->side = dict.getWordOr("fluidSide", "outside", loopSides, "sides");
    return shape;
}

std::unique_ptr<SurfaceShape> makeCylinder(Dictionary const& dict, Real spacing)
{
    Vector const centre = readFlat(dict, "point1");
    require((centre - readFlat(dict, "point2")).norm() < 1e-9 * (1 + centre.norm()), dict.where("point2"),
            "the axis of a cylinder is not along z", "point1 and point2 with the same x and y: a 2-D case sees the circle");
    return makeCircle(dict, centre, spacing);
}

std::unique_ptr<SurfaceShape> makeSphere(Dictionary const& dict, Real spacing)
{
    return makeCircle(dict, readFlat(dict, "centre"), spacing);
}

ShapeRegistry const& shapes()
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

struct NamedShape
{
    SurfaceShape shape;
    Location where;
};

std::map<std::string, NamedShape> readShapes(Dictionary const& geometry, Real spacing)
{
    std::map<std::string, NamedShape> all;
    for (std::string const& name : geometry.dictKeys())
    {
        Dictionary const dict = geometry.subDict(name);
        auto const shape = shapes().make(dict.get<std::string>("type"), dict.where("type"), dict, spacing);
        Location const where = dict.where(dict.found("points") ? "points" : "");
        all.emplace(name, NamedShape{*shape, where});
    }
    return all;
}

WallDefinition makeWall(std::string const& name, NamedShape const& named, std::string const& side, Location const& where, Real spacing)
{
    SurfaceShape const& shape = named.shape;
    WallDefinition wall;
    wall.where = where;
    wall.surface =
        atPlace(named.where, [&] { return Polyline(name, shape.points, shape.closed, side == shape.sides[0] ? Side::Left : Side::Right); });
    Real length = 0;
    for (auto const& segment : wall.surface.segments()) length += segment.length;
    require(length >= spacing, named.where,
            "surface \"" + name + "\" is " + shortNumber(length) + " m long, less than the spacing of " + shortNumber(spacing) + " m",
            "a smaller spacing in constant/particleProperties");
    return wall;
}

int readGhostRows(Dictionary const& dict, Real spacing, int automatic)
{
    if (!dict.found("thickness") || isWord(dict, "thickness", "auto")) return automatic;
    Real const thickness = readPositive(dict, "thickness");
    int const rows = static_cast<int>(std::min(std::ceil(thickness / spacing - 1e-9), 100.0));
    require(rows >= automatic + 1, dict.where("thickness"),
            "a wall of " + std::to_string(rows) + " rows is thinner than the kernel reaches",
            "auto, or " + shortNumber((automatic + 1) * spacing) + " m or more");
    return rows - 1;
}

} // namespace

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

std::vector<WallDefinition> readWalls(Dictionary const& setParticlesDict, Lattice const& lattice, Real radius)
{
    Dictionary const geometry = setParticlesDict.subDictOrEmpty("geometry");
    std::map<std::string, NamedShape> const surfaces = readShapes(geometry, lattice.spacing);
    int const automatic = ghostRowsFor(radius);
    std::vector<WallDefinition> walls;
    if (!setParticlesDict.found("walls"))
    {
        for (std::string const& name : geometry.dictKeys())
        {
            NamedShape const& named = surfaces.at(name);
            walls.push_back(makeWall(name, named, named.shape.side, geometry.where(name), lattice.spacing));
            walls.back().ghostRows = automatic;
        }
        return walls;
    }
    std::set<std::string> names;
    for (auto const& [word, dict] : setParticlesDict.getDictList("walls"))
    {
        auto const surface = dict.get<std::string>("surface");
        auto const found = surfaces.find(surface);
        require(found != surfaces.end(), dict.where("surface"), "surface \"" + surface + "\" is not in geometry",
                knownWords("surfaces", surface, geometry.dictKeys()));
        std::string const name = dict.getOr<std::string>("name", word.empty() ? surface : word);
        require(names.insert(name).second, dict.where("name"), "two walls have the name \"" + name + "\"", "different names");
        SurfaceShape const& shape = found->second.shape;
        std::string const side = dict.getWordOr("side", shape.side, shape.sides, "sides");
        walls.push_back(makeWall(name, found->second, side, dict.where(), lattice.spacing));
        walls.back().ghostRows = readGhostRows(dict, lattice.spacing, automatic);
    }
    return walls;
}

} // namespace mpsDem
