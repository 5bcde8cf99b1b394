#include "scene/BodyReader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bodies/Entries.h"
#include "bodies/RigidBodyReader.h"
#include "core/Errors.h"
#include "core/Registry.h"
#include "scene/EntryText.h"
#include "scene/GeometryReader.h"

namespace mpsDem {

namespace {

struct Shape
{
    std::vector<Vector> points;
    Real radius = 0;
    Vector centre = Vector::Zero(); ///< Of a cylinder.
};

using ShapeRegistry = Registry<Shape, Dictionary const&, Real>;

std::unique_ptr<Shape> makePolygon(Dictionary const& dict, Real)
{
    auto shape = std::make_unique<Shape>();
    shape->points = readPoints(dict, "points");
    require(shape->points.size() >= 3, dict.where("points"), "a polygon of " + std::to_string(shape->points.size()) + " points",
            "three or more");
    return shape;
}

std::unique_ptr<Shape> makeBox(Dictionary const& dict, Real)
{
    Vector const a = readPoint(dict, "min"), b = readPoint(dict, "max");
    require(a.x() < b.x() && a.y() < b.y(), dict.where("max"), "a box whose max is not above its min", "min < max in x and y");
    auto shape = std::make_unique<Shape>();
    shape->points = {a, Vector(b.x(), a.y(), 0), b, Vector(a.x(), b.y(), 0)};
    return shape;
}

std::unique_ptr<Shape> makeCylinder(Dictionary const& dict, Real spacing)
{
    auto shape = std::make_unique<Shape>();
    shape->centre = readPoint(dict, "centre");
    shape->radius = readPositive(dict, "radius");
    shape->points = circlePoints(shape->centre, shape->radius, spacing);
    return shape;
}

ShapeRegistry const& shapes()
{
    static ShapeRegistry const registry = [] {
        ShapeRegistry made("shape", "shapes");
        made.add("polygon", makePolygon);
        made.add("box", makeBox);
        made.add("cylinder", makeCylinder);
        return made;
    }();
    return registry;
}

BodyShape readBodyShape(std::string const& name, Dictionary const& body, Lattice const& lattice)
{
    Dictionary const dict = body.subDict("shape");
    auto const shape = shapes().make(dict.get<std::string>("type"), dict.where("type"), dict, lattice.spacing);
    BodyShape result;
    result.name = name;
    result.where = dict.where(dict.found("points") ? "points" : "");
    result.radius = shape->radius;
    result.orientation = readOrientation(body, "orientation");
    atPlace(result.where, [&] {
        result.outline = Polyline::outline(name, shape->points);
        result.properties = shape->radius > 0 ? MassProperties::fromCylinder2D(shape->centre, shape->radius, lattice.thickness, 1)
                                              : MassProperties::fromPolygon(result.outline, lattice.thickness, 1);
        return 0;
    });
    Real const least = leastWidth(result.outline);
    require(least >= (1 - 1e-9) * lattice.spacing, result.where,
            "body \"" + name + "\" is " + shortNumber(least) + " m wide, less than the spacing of " + shortNumber(lattice.spacing) + " m",
            "a smaller spacing in constant/particleProperties");
    return result;
}

} // namespace

Real leastWidth(Polyline const& outline)
{
    Real least = std::numeric_limits<Real>::infinity();
    for (auto const& side : outline.segments())
    {
        Real low = 0, high = 0;
        for (Vector const& corner : outline.points())
        {
            Real const off = side.normal.dot(corner - side.a);
            low = std::min(low, off);
            high = std::max(high, off);
        }
        least = std::min(least, high - low);
    }
    return least;
}

std::vector<BodyShape> readBodyShapes(Dictionary const& rigidBodyProperties, Lattice const& lattice)
{
    std::vector<BodyShape> all;
    Dictionary const bodies = rigidBodyProperties.subDict("bodies");
    for (std::string const& name : bodies.dictKeys()) all.push_back(readBodyShape(name, bodies.subDict(name), lattice));
    return all;
}

std::vector<std::unique_ptr<RigidBody>> readBodies(Dictionary const& rigidBodyProperties, Lattice const& lattice, Real time)
{
    std::vector<std::unique_ptr<RigidBody>> all;
    Dictionary const bodies = rigidBodyProperties.subDict("bodies");
    for (BodyShape const& shape : readBodyShapes(rigidBodyProperties, lattice))
    {
        Dictionary const dict = bodies.subDict(shape.name);
        all.push_back(
            atPlace(dict.where(), [&] { return readRigidBody(shape.name, dict, shape.properties, lattice.dimensions == 2, time); }));
    }
    rigidBodyProperties.ignore("solver");
    rigidBodyProperties.requireAllRead();
    return all;
}

std::vector<std::unique_ptr<RigidBody>> readBodies(Dictionary const& rigidBodyProperties, State const& state, Lattice const& lattice)
{
    auto all = readBodies(rigidBodyProperties, lattice, state.real("time/value"));
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

Polyline outlineInBodyAxes(BodyShape const& shape, RigidBody const& body)
{
    Tensor const back = shape.orientation.toRotationMatrix().transpose();
    std::vector<Vector> points;
    for (Vector const& q : shape.outline.points()) points.push_back(back * (q - body.massProperties().centreOfMass));
    return Polyline::outline(shape.name, std::move(points));
}

} // namespace mpsDem
