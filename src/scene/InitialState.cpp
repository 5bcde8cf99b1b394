#include "scene/InitialState.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundaries/BoundaryRows.h"
#include "boundaries/SurfaceRows.h"
#include "boundaries/SurfaceTree.h"
#include "core/Errors.h"
#include "scene/InitialChecks.h"

namespace mpsDem {

namespace {

/// Fields of all particles in any order, as ParticleSet::assign takes them.
struct Layout
{
    Field<Vector> position, velocity, normal;
    Field<Real> pressure;
    Field<ParticleType> type;
    Field<int> body, wall;

    void add(Vector const& r, Vector const& u, Real p, ParticleType kind, int bodyIndex, int wallIndex, Vector const& n)
    {
        position.push_back(r);
        velocity.push_back(u);
        pressure.push_back(p);
        type.push_back(kind);
        body.push_back(bodyIndex);
        wall.push_back(wallIndex);
        normal.push_back(n);
    }
};

/// Rows behind lines (2-D) or triangles (3-D).
BoundaryRows rowsBehind(std::vector<Surface> const& surfaces, std::vector<int> const& ghostRows, Lattice const& lattice)
{
    if (lattice.dimensions == 2) return boundaryRows(linesOf(surfaces), ghostRows, lattice.spacing);
    return boundaryRows(trianglesOf(surfaces), ghostRows, lattice.spacing);
}

void addWalls(Layout& layout, SceneDefinition const& scene, std::vector<Surface> const& surfaces)
{
    std::vector<int> ghostRows;
    for (WallDefinition const& wall : scene.walls) ghostRows.push_back(wall.ghostRows);
    BoundaryRows const rows = rowsBehind(surfaces, ghostRows, scene.lattice);
    // Rows go on beyond the end of a wall; at a periodic border the images of its own particles stand there.
    auto const inside = [&](std::size_t i) { return scene.periodic.contains(rows.position[i]); };
    for (std::size_t i = 0; i < rows.position.size(); ++i)
        if (inside(i)) layout.add(rows.position[i], Vector::Zero(), 0, rows.type[i], -1, rows.chain[i], rows.normal[i]);
    for (std::size_t k = 0; k < scene.walls.size(); ++k)
    {
        bool any = false;
        for (std::size_t i = 0; i < rows.position.size() && !any; ++i)
            any = rows.chain[i] == static_cast<int>(k) && rows.type[i] == ParticleType::Wall && inside(i);
        require(any, scene.walls[k].where, "wall \"" + surfaces[k].name() + "\" gets no wall particle",
                "a wall that is longer than a spacing and lies neither within another one nor outside of the periodic box");
    }
}

void addBody(Layout& layout, SceneDefinition const& scene, std::size_t k, Surface const& outline)
{
    RigidBody const& body = *scene.bodies[k];
    BoundaryRows const rows = rowsBehind({outline}, {ghostRowsFor(scene.kernelRadius)}, scene.lattice);
    bool const any = std::find(rows.type.begin(), rows.type.end(), ParticleType::Wall) != rows.type.end();
    require(any, scene.shapes[k].where, "body \"" + body.name() + "\" is too thin for a row of particles",
            "a body of at least one spacing, or a smaller spacing in constant/particleProperties");
    for (std::size_t i = 0; i < rows.position.size(); ++i)
    {
        Vector const r = body.toSpace(rows.position[i]);
        layout.add(r, body.velocityAt(r), 0, rows.type[i], static_cast<int>(k), -1, body.rotation() * rows.normal[i]);
    }
}

void addFluid(Layout& layout, SceneDefinition const& scene, FluidFilling const& fluid)
{
    for (std::size_t i = 0; i < fluid.position.size(); ++i)
    {
        FieldValues const& given = scene.regions[static_cast<std::size_t>(fluid.region[i])]->values;
        Vector const& r = fluid.position[i];
        Real const pressure = given.hasPressure ? given.pressure : hydrostaticPressure(scene, r);
        layout.add(r, given.velocity, pressure, ParticleType::Fluid, -1, -1, Vector::Zero());
    }
}

/// Numbers of the walls in the order that ParticleSet::assign gives boundary particles: all Wall, then all Ghost.
Field<int> wallNumbers(Layout const& layout)
{
    Field<int> numbers;
    for (ParticleType const kind : {ParticleType::Wall, ParticleType::Ghost})
        for (std::size_t i = 0; i < layout.type.size(); ++i)
            if (layout.type[i] == kind) numbers.push_back(layout.wall[i]);
    return numbers;
}

} // namespace

Real hydrostaticPressure(SceneDefinition const& definition, Vector const& r)
{
    Real const g = definition.gravity.norm();
    if (!definition.hydrostatic || !(g > 0)) return 0;
    Vector const up = -definition.gravity / g;
    Real const depth = definition.hasSurfaceLevel ? definition.surfaceLevel - r.dot(up)
                                                  : depthInRegions(definition.regions, r, up, definition.lattice.spacing);
    return definition.density * g * std::max(Real(0), depth);
}

InitialScene makeInitialScene(SceneDefinition const& definition)
{
    InitialScene scene{ParticleSet(definition.lattice), {}, {}, {}, {}, {}};
    Layout layout;
    for (WallDefinition const& wall : definition.walls) scene.surfaces.push_back(wall.surface);
    for (std::size_t k = 0; k < definition.bodies.size(); ++k)
    {
        RigidBody const& body = *definition.bodies[k];
        scene.outlines.push_back({outlineInBodyAxes(definition.shapes[k], body), definition.shapes[k].radius});
        scene.placed.push_back(scene.outlines[k].outline.moved(body.rotation(), body.centre()));
    }
    checkPlacement(definition, scene.surfaces, scene.placed);

    addWalls(layout, definition, scene.surfaces);
    // Particles of a body carry the fluid's pressure to it; without fluid nothing would move them along.
    std::size_t const wetted = definition.regions.empty() ? 0 : definition.bodies.size();
    for (std::size_t k = 0; k < wetted; ++k) addBody(layout, definition, k, scene.outlines[k].outline);

    SurfaceTree const walls(scene.surfaces), bodies(scene.placed);
    scene.fluid = fillRegions(definition.regions, definition.placement, definition.lattice, {walls, bodies});
    checkFilling(definition, scene.fluid);
    addFluid(layout, definition, scene.fluid);

    scene.wallOf = wallNumbers(layout);
    scene.particles.assign(layout.position, layout.velocity, layout.pressure, layout.type, layout.body, layout.normal);
    return scene;
}

State InitialScene::state(SceneDefinition const& definition) const
{
    State all;
    particles.save(all);
    saveWallOf(all, wallOf);
    saveSurfaces(all, surfaces);
    for (std::size_t k = 0; k < definition.bodies.size(); ++k)
    {
        definition.bodies[k]->save(all);
        saveOutline(all, definition.bodies[k]->name(), static_cast<int>(k), outlines[k]);
    }
    all.set("time/value", definition.startTime);
    all.set("time/step", std::int64_t{0});
    return all;
}

} // namespace mpsDem
