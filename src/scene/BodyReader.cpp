#include "scene/BodyReader.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "bodies/Entries.h"
#include "bodies/RigidBodyReader.h"
#include "core/Errors.h"
#include "core/Registry.h"
#include "scene/EntryText.h"
#include "scene/SurfaceFile.h"

namespace mpsDem {

namespace {

/// A body's shape before it has a name.
struct Shape
{
    std::function<Surface(std::string const& name)> make;
    std::optional<MassProperties> exact; ///< Of what the surface only comes near to, for a density of 1 kg/m3.
    Real radius = 0;                     ///< Of a disc or a sphere.
};

using BodyShapeRegistry = Registry<Shape, Dictionary const&, GeometryContext const&>;

std::vector<Vector> readPolygon(Dictionary const& dict)
{
    auto points = readPoints(dict, "points");
    require(points.size() >= 3, dict.where("points"), "a polygon of " + std::to_string(points.size()) + " points", "three or more");
    return points;
}

std::unique_ptr<Shape> makePolygon(Dictionary const& dict, GeometryContext const& context)
{
    auto shape = std::make_unique<Shape>();
    auto const points = readPolygon(dict);
    if (context.lattice.dimensions == 2)
    {
        refuseInPlane(dict, {"zRange"});
        shape->make = [points](std::string const& name) { return Surface(Polyline::outline(name, points)); };
    }
    else
    {
        auto const [low, high] = readZRange(dict);
        shape->make = [points, low = low, high = high](std::string const& name) {
            return Surface(TriSurface::prism(name, points, low, high));
        };
    }
    return shape;
}

std::unique_ptr<Shape> makeBox(Dictionary const& dict, GeometryContext const& context)
{
    int const dimensions = context.lattice.dimensions;
    Vector const a = readPoint(dict, "min", dimensions), b = readPoint(dict, "max", dimensions);
    if (dimensions == 3) requireBoxInSpace(a, b, dict.where("max"));
    require(a.x() < b.x() && a.y() < b.y(), dict.where("max"), "a box whose max is not above its min", "min < max in x and y");
    auto shape = std::make_unique<Shape>();
    shape->make = [=](std::string const& name) {
        if (dimensions == 3) return Surface(TriSurface::box(name, a, b));
        return Surface(Polyline::outline(name, {a, Vector(b.x(), a.y(), 0), b, Vector(a.x(), b.y(), 0)}));
    };
    return shape;
}

std::unique_ptr<Shape> makeDisc(Dictionary const& dict, GeometryContext const& context)
{
    auto shape = std::make_unique<Shape>();
    Vector const centre = readPoint(dict, "centre");
    Real const radius = readPositive(dict, "radius");
    shape->radius = radius;
    shape->exact = MassProperties::fromCylinder2D(centre, radius, context.lattice.thickness, 1);
    auto const points = circlePoints(centre, radius, context.lattice.spacing);
    shape->make = [points](std::string const& name) { return Surface(Polyline::outline(name, points)); };
    return shape;
}

std::unique_ptr<Shape> makeCylinder(Dictionary const& dict, GeometryContext const& context)
{
    auto shape = std::make_unique<Shape>();
    Vector const a = readPoint(dict, "point1", 3), b = readPoint(dict, "point2", 3);
    Real const radius = readPositive(dict, "radius");
    require((b - a).norm() > 0, dict.where("point2"), "a cylinder without length", "two different ends of the axis");
    shape->exact = MassProperties::fromCylinder(a, b, radius, 1);
    int const sides = static_cast<int>(circlePoints(a, radius, context.lattice.spacing).size());
    shape->make = [=](std::string const& name) { return Surface(TriSurface::cylinder(name, a, b, radius, sides)); };
    return shape;
}

std::unique_ptr<Shape> makeSphere(Dictionary const& dict, GeometryContext const& context)
{
    auto shape = std::make_unique<Shape>();
    Vector const centre = readPoint(dict, "centre", 3);
    Real const radius = readPositive(dict, "radius"), edge = sphereEdge * context.lattice.spacing;
    shape->radius = radius;
    shape->exact = MassProperties::fromSphere(centre, radius, 1);
    shape->make = [=](std::string const& name) { return Surface(TriSurface::sphere(name, centre, radius, edge)); };
    return shape;
}

std::unique_ptr<Shape> makeSurfaceFile(Dictionary const& dict, GeometryContext const& context)
{
    auto shape = std::make_unique<Shape>();
    shape->make = [surface = readSurfaceFile(dict, context.root, dict.get<std::string>("file"), Skin::Body, context.lattice.spacing)](
                      std::string const& name) { return Surface(surface.renamed(name)); };
    return shape;
}

BodyShapeRegistry const& bodyShapes(int dimensions)
{
    static auto const make = [](bool flat) {
        BodyShapeRegistry made("shape", "shapes");
        made.add("polygon", makePolygon);
        made.add("box", makeBox);
        made.add("cylinder", flat ? makeDisc : makeCylinder);
        if (!flat) made.add("sphere", makeSphere);
        if (!flat) made.add("triSurfaceMesh", makeSurfaceFile);
        return made;
    };
    static BodyShapeRegistry const flat = make(true), spatial = make(false);
    return dimensions == 2 ? flat : spatial;
}

BodyShape readBodyShape(std::string const& name, Dictionary const& body, GeometryContext const& context)
{
    Dictionary const dict = body.subDict("shape");
    Lattice const& lattice = context.lattice;
    BodyShapeRegistry const& shapes = bodyShapes(lattice.dimensions);
    auto const type = dict.get<std::string>("type");
    refuseInPlane(dict.where("type"), "shape", type, shapes.names(), bodyShapes(3).names());
    auto const shape = shapes.make(type, dict.where("type"), dict, context);
    BodyShape result;
    result.name = name;
    result.where = dict.where(dict.found("points") ? "points" : "");
    result.radius = shape->radius;
    result.orientation = readOrientation(body, "orientation");
    atPlace(result.where, [&] {
        result.outline = shape->make(name);
        result.properties = shape->exact            ? *shape->exact
                            : result.outline.flat() ? MassProperties::fromPolygon(result.outline.line(), lattice.thickness, 1)
                                                    : MassProperties::fromTriSurface(result.outline.triangles(), 1);
        return 0;
    });
    Real const least = leastWidth(result.outline);
    require(least >= (1 - 1e-9) * lattice.spacing, result.where,
            "body \"" + name + "\" is " + shortNumber(least) + " m wide, less than the spacing of " + shortNumber(lattice.spacing) + " m",
            "a smaller spacing in constant/particleProperties");
    return result;
}

/// Extent of points along a direction.
Real widthAlong(std::vector<Vector> const& points, Vector const& direction)
{
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (Vector const& r : points)
    {
        low = std::min(low, direction.dot(r));
        high = std::max(high, direction.dot(r));
    }
    return high - low;
}

} // namespace

Real leastWidth(Surface const& outline)
{
    Real least = std::numeric_limits<Real>::infinity();
    if (outline.flat())
    {
        for (auto const& side : outline.line().segments()) least = std::min(least, widthAlong(outline.points(), side.normal));
        return least;
    }
    auto const& triangles = outline.triangles().triangles();
    std::size_t const step = std::max<std::size_t>(1, triangles.size() / 100);
    for (std::size_t t = 0; t < triangles.size(); t += step) least = std::min(least, widthAlong(outline.points(), triangles[t].normal));
    return least;
}

std::vector<BodyShape> readBodyShapes(Dictionary const& rigidBodyProperties, GeometryContext const& context)
{
    std::vector<BodyShape> all;
    Dictionary const bodies = rigidBodyProperties.subDict("bodies");
    for (std::string const& name : bodies.dictKeys()) all.push_back(readBodyShape(name, bodies.subDict(name), context));
    return all;
}

std::vector<std::unique_ptr<RigidBody>> readBodies(Dictionary const& rigidBodyProperties, GeometryContext const& context, Real time)
{
    std::vector<std::unique_ptr<RigidBody>> all;
    Dictionary const bodies = rigidBodyProperties.subDict("bodies");
    for (BodyShape const& shape : readBodyShapes(rigidBodyProperties, context))
    {
        Dictionary const dict = bodies.subDict(shape.name);
        all.push_back(atPlace(dict.where(),
                              [&] { return readRigidBody(shape.name, dict, shape.properties, context.lattice.dimensions == 2, time); }));
    }
    rigidBodyProperties.ignore("solver");
    rigidBodyProperties.requireAllRead();
    return all;
}

std::vector<std::unique_ptr<RigidBody>> readBodies(Dictionary const& rigidBodyProperties, State const& state,
                                                   GeometryContext const& context)
{
    auto all = readBodies(rigidBodyProperties, context, state.real("time/value"));
    std::string const remedy = "the bodies are not those that setParticles saw; run it again";
    std::size_t saved = 0;
    for (auto const& [name, block] : state.blocks()) saved += name.starts_with("body/") && name.ends_with("/index") ? 1 : 0;
    require(saved == all.size(), rigidBodyProperties.where("bodies"),
            std::to_string(all.size()) + " bodies, but the saved state has " + std::to_string(saved), remedy);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        std::string const block = "body/" + all[i]->name() + "/index";
        require(state.has(block) && state.integer(block) == static_cast<std::int64_t>(i), rigidBodyProperties.where("bodies"),
                "body \"" + all[i]->name() + "\" has another place in the saved state, or none", remedy);
        all[i]->load(state);
    }
    return all;
}

Surface outlineInBodyAxes(BodyShape const& shape, RigidBody const& body)
{
    Tensor const back = shape.orientation.toRotationMatrix().transpose();
    Vector const& centre = body.massProperties().centreOfMass;
    if (!shape.outline.flat()) return shape.outline.moved(back, -(back * centre));
    std::vector<Vector> points;
    for (Vector const& q : shape.outline.points()) points.push_back(back * (q - centre));
    return Polyline::outline(shape.name, std::move(points));
}

} // namespace mpsDem
