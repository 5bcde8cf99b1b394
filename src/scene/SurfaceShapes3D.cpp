#include <algorithm>
#include <array>
#include <cmath>

#include "core/Errors.h"
#include "scene/EntryText.h"
#include "scene/SurfaceFile.h"
#include "scene/SurfaceShapes.h"

namespace mpsDem {

namespace {

std::vector<std::string> const alongSides{"left", "right"};
std::vector<std::string> const solidSides{"outside", "inside"}; // of shapes whose normals point outwards
std::vector<std::string> const plateSides{"positive", "negative"};
std::vector<std::string> const heightSides{"above", "below"};
std::vector<std::string> const windingSides{"normal", "reverse"}; // of an open surface from a file

Vector readFinite(Dictionary const& dict, std::string const& key)
{
    Vector const v = dict.get<Vector>(key);
    require(v.allFinite(), dict.where(key), key + " is not finite", "three numbers");
    return v;
}

/// @param build  Makes the surface with the fluid on the first side.
std::unique_ptr<SurfaceShape> shapeOf(Dictionary const& dict, std::function<TriSurface(std::string const&)> build,
                                      std::vector<std::string> const& sides, std::string const& side)
{
    auto shape = std::make_unique<SurfaceShape>();
    shape->make = [build = std::move(build)](std::string const& name, bool first) {
        TriSurface made = build(name);
        return Surface(first ? std::move(made) : made.flipped());
    };
    shape->sides = sides;
    shape->side = dict.getWordOr("fluidSide", side, sides, "sides");
    return shape;
}

std::unique_ptr<SurfaceShape> makePolyline(Dictionary const& dict, GeometryContext const&)
{
    auto const points = readPoints(dict, "points");
    bool const closed = dict.getOr<bool>("closed", false);
    auto const [low, high] = readZRange(dict);
    if (dict.getOr<bool>("sideWalls", false))
    {
        require(!closed, dict.where("sideWalls"), "side walls of a closed polyline", "sideWalls no, or closed no");
        return shapeOf(
            dict, [=, low = low, high = high](std::string const& name) { return TriSurface::channel(name, points, low, high); }, {"inside"},
            "inside");
    }
    return shapeOf(
        dict, [=, low = low, high = high](std::string const& name) { return TriSurface::extruded(name, points, closed, low, high, true); },
        alongSides, "left");
}

std::unique_ptr<SurfaceShape> makeBox(Dictionary const& dict, GeometryContext const&)
{
    Vector const a = readFinite(dict, "min"), b = readFinite(dict, "max");
    requireBoxInSpace(a, b, dict.where("max"));
    std::vector<bool> const words = readOpenSides(dict, {"left", "right", "bottom", "top", "back", "front"});
    std::array<bool, 6> open{};
    std::copy(words.begin(), words.end(), open.begin());
    return shapeOf(
        dict, [=](std::string const& name) { return TriSurface::box(name, a, b, open); }, solidSides, "inside");
}

std::unique_ptr<SurfaceShape> makePlate(Dictionary const& dict, GeometryContext const&)
{
    Vector const origin = readFinite(dict, "origin"), span = readFinite(dict, "span");
    int const flat = static_cast<int>((span.array() == 0).count());
    require(flat == 1, dict.where("span"), "a plate whose span has " + std::to_string(flat) + " components of zero",
            "one: the plate is normal to that axis");
    int axis = 0;
    while (span[axis] != 0) ++axis;
    Vector const e1 = Vector::Unit((axis + 1) % 3) * span[(axis + 1) % 3], e2 = Vector::Unit((axis + 2) % 3) * span[(axis + 2) % 3];
    bool const turned = span[(axis + 1) % 3] * span[(axis + 2) % 3] < 0;
    auto const build = [=](std::string const& name) {
        TriSurface const made(name, {origin, origin + e1, origin + e1 + e2, origin + e2}, {{0, 1, 2}, {0, 2, 3}});
        return turned ? made.flipped() : made;
    };
    return shapeOf(dict, build, plateSides, "positive");
}

std::unique_ptr<SurfaceShape> makeCylinder(Dictionary const& dict, GeometryContext const& context)
{
    Vector const a = readFinite(dict, "point1"), b = readFinite(dict, "point2");
    Real const radius = readPositive(dict, "radius");
    int const sides = static_cast<int>(circlePoints(a, radius, context.lattice.spacing).size());
    return shapeOf(
        dict, [=](std::string const& name) { return TriSurface::cylinder(name, a, b, radius, sides); }, solidSides, "outside");
}

std::unique_ptr<SurfaceShape> makeSphere(Dictionary const& dict, GeometryContext const& context)
{
    Vector const centre = readFinite(dict, "centre");
    Real const radius = readPositive(dict, "radius"), edge = sphereEdge * context.lattice.spacing;
    return shapeOf(
        dict, [=](std::string const& name) { return TriSurface::sphere(name, centre, radius, edge); }, solidSides, "outside");
}

std::unique_ptr<SurfaceShape> makeSurfaceFile(Dictionary const& dict, GeometryContext const& context)
{
    TriSurface const surface = readSurfaceFile(dict, context.root, dict.get<std::string>("file"), Skin::Open, context.lattice.spacing);
    auto const build = [surface](std::string const& name) { return surface.renamed(name); };
    if (!surface.closed()) return shapeOf(dict, build, windingSides, "normal");
    return shapeOf(dict, build, solidSides, "outside");
}

std::unique_ptr<SurfaceShape> makeRaster(Dictionary const& dict, GeometryContext const& context)
{
    TriSurface const surface = readSurfaceFile(dict, context.root, dict.get<std::string>("file"), Skin::Open, 0);
    return shapeOf(
        dict, [surface](std::string const& name) { return surface.renamed(name); }, heightSides, "above");
}

} // namespace

std::pair<Real, Real> readZRange(Dictionary const& dict)
{
    if (!dict.found("zRange")) dict.refuseMisspelt({"zRange"});
    require(dict.found("zRange"), dict.where(dict.found("points") ? "points" : ""), "the entry zRange is missing",
            "zRange (low high); over which the line stands in z; or dimensions 2 in constant/particleProperties");
    auto const range = dict.get<std::vector<Real>>("zRange");
    require(range.size() == 2 && std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1], dict.where("zRange"),
            "zRange is no range of z", "two rising numbers: zRange (0 0.5);");
    return {range[0], range[1]};
}

ShapeRegistry const& shapes3D()
{
    static ShapeRegistry const registry = [] {
        ShapeRegistry made("surface type", "surface types");
        made.add("polyline", makePolyline);
        made.add("searchableBox", makeBox);
        made.add("searchablePlate", makePlate);
        made.add("searchableCylinder", makeCylinder);
        made.add("searchableSphere", makeSphere);
        made.add("triSurfaceMesh", makeSurfaceFile);
        made.add("rasterSurface", makeRaster);
        return made;
    }();
    return registry;
}

} // namespace mpsDem
