#include "core/Errors.h"
#include "io/MachineMemory.h"
#include "scene/EntryText.h"
#include "scene/InitialState.h"
#include "scene/SizeEstimate.h"

namespace mpsDem {

namespace {

/// `hydrostatic { active yes; surface 1.0; }`.
void readHydrostatic(SceneDefinition& scene, Dictionary const& setParticlesDict)
{
    Dictionary const dict = setParticlesDict.subDictOrEmpty("hydrostatic");
    scene.hydrostatic = dict.getOr<bool>("active", true);
    scene.hasSurfaceLevel = dict.found("surface");
    if (!scene.hasSurfaceLevel) return;
    scene.surfaceLevel = dict.getInRange("surface", -1e30, 1e30);
    require(!scene.hydrostatic || scene.gravity.norm() > 0, dict.where("surface"), "a free surface without gravity",
            "a file constant/g with `value (0 -9.81 0);`, or hydrostatic { active no; }");
}

/// Names become parts of file names and of pairs of contact: they must differ.
void checkNames(SceneDefinition const& scene)
{
    for (BodyShape const& shape : scene.shapes)
    {
        require(shape.name != "particles" && shape.name.find('/') == std::string::npos, shape.where,
                "a body cannot be called \"" + shape.name + "\"", "a name without / that is not \"particles\"");
        for (WallDefinition const& wall : scene.walls)
            require(wall.surface.name() != shape.name, shape.where, "a body and a wall are both called \"" + shape.name + "\"",
                    "different names");
    }
}

} // namespace

SceneDefinition readSceneDefinition(CaseFolder const& caseFolder, std::filesystem::path const& dictionary)
{
    SceneDefinition scene;
    scene.startTime = readStartTime(caseFolder);
    Dictionary const particleProperties = caseFolder.read("constant/particleProperties");
    scene.lattice = readLattice(particleProperties);
    scene.kernelRadius = largestKernelRadius(caseFolder);
    scene.periodic = readPeriodicBox(caseFolder);
    scene.gravity = readGravity(caseFolder, scene.lattice.dimensions);

    GeometryContext const geometry{scene.lattice, caseFolder.root()};
    Dictionary const dict = caseFolder.read(dictionary);
    scene.walls = readWalls(dict, geometry, scene.kernelRadius);
    scene.regions = readRegions(dict, scene.lattice, caseFolder.root());
    scene.placement = LatticePlacement::read(dict, scene.lattice.dimensions);
    readHydrostatic(scene, dict);
    dict.requireAllRead();

    if (!scene.regions.empty()) scene.density = readFluidDensity(caseFolder.read("constant/transportProperties"));
    if (auto const bodies = caseFolder.readIfPresent("constant/rigidBodyProperties"))
    {
        scene.shapes = readBodyShapes(*bodies, geometry);
        scene.bodies = readBodies(*bodies, geometry, scene.startTime);
    }
    checkNames(scene);
    require(!scene.walls.empty() || !scene.regions.empty() || !scene.bodies.empty(), dict.where(),
            "the case has neither walls nor fluid nor bodies", "geometry, regions, or constant/rigidBodyProperties");
    SizeEstimate const size = estimateSize(scene);
    requireRoom(size, scene.lattice, particleProperties.where("spacing"), availableMemory(), largeSurface(scene, size));
    return scene;
}

} // namespace mpsDem
