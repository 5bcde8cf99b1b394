#include "scene/GeometryReader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "boundaries/BoundaryRows.h"
#include "core/Errors.h"
#include "scene/EntryText.h"
#include "scene/SurfaceShapes.h"

namespace mpsDem {

namespace {

struct NamedShape
{
    SurfaceShape shape;
    Location where;
};

std::map<std::string, NamedShape> readShapes(Dictionary const& geometry, GeometryContext const& context)
{
    ShapeRegistry const& shapes = context.lattice.dimensions == 2 ? shapes2D() : shapes3D();
    std::map<std::string, NamedShape> all;
    for (std::string const& name : geometry.dictKeys())
    {
        Dictionary const dict = geometry.subDict(name);
        auto const type = dict.get<std::string>("type");
        refuseInPlane(dict.where("type"), "surface type", type, shapes.names(), shapes3D().names());
        auto const shape = shapes.make(type, dict.where("type"), dict, context);
        Location const where = dict.where(dict.found("points") ? "points" : "");
        all.emplace(name, NamedShape{*shape, where});
    }
    return all;
}

/// Refuses a surface that no particle would stand for.
void checkExtent(Surface const& surface, Location const& where, Real spacing)
{
    Real size = 0;
    if (surface.flat())
        for (auto const& segment : surface.line().segments()) size += segment.length;
    else
        size = (surface.triangles().high() - surface.triangles().low()).maxCoeff();
    require(size >= spacing, where,
            "surface \"" + surface.name() + "\" is " + shortNumber(size) + " m long, less than the spacing of " + shortNumber(spacing) +
                " m",
            "a smaller spacing in constant/particleProperties");
}

WallDefinition makeWall(std::string const& name, NamedShape const& named, std::string const& side, Location const& where, Real spacing)
{
    SurfaceShape const& shape = named.shape;
    WallDefinition wall;
    wall.where = where;
    wall.surface = atPlace(named.where, [&] { return shape.make(name, side == shape.sides[0]); });
    checkExtent(wall.surface, named.where, spacing);
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

std::vector<WallDefinition> readWalls(Dictionary const& setParticlesDict, GeometryContext const& context, Real radius)
{
    Dictionary const geometry = setParticlesDict.subDictOrEmpty("geometry");
    std::map<std::string, NamedShape> const surfaces = readShapes(geometry, context);
    Real const spacing = context.lattice.spacing;
    int const automatic = ghostRowsFor(radius);
    std::vector<WallDefinition> walls;
    if (!setParticlesDict.found("walls"))
    {
        for (std::string const& name : geometry.dictKeys())
        {
            NamedShape const& named = surfaces.at(name);
            walls.push_back(makeWall(name, named, named.shape.side, geometry.where(name), spacing));
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
        walls.push_back(makeWall(name, found->second, side, dict.where(), spacing));
        walls.back().ghostRows = readGhostRows(dict, spacing, automatic);
    }
    return walls;
}

} // namespace mpsDem
