#include "scene/InitialFiles.h"

#include <cstdint>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/Checkpoint.h"
#include "io/OutputFile.h"
#include "io/VtkFile.h"
#include "scene/InputFingerprint.h"
#include "scene/Output.h"
#include "scene/Scene.h"
#include "scene/StartChecks.h"

namespace mpsDem {

namespace {

void writeParticles(std::filesystem::path const& path, InitialScene const& scene, Real time)
{
    ParticleSet const& particles = scene.particles;
    std::vector<std::uint8_t> type(particles.type.size(), 0);
    std::vector<int> wall(particles.type.size(), -1);
    for (int const i : particles.boundary())
    {
        auto const k = static_cast<std::size_t>(i);
        type[k] = particles.type[k] == ParticleType::Ghost ? 3 : particles.wet[k] != 0 ? 1 : 2;
        wall[k] = scene.wallOf[k];
    }
    PointCloud cloud;
    cloud.position = particles.r;
    cloud.vectors.emplace_back("U", particles.u);
    cloud.scalars.emplace_back("p", particles.p);
    cloud.integers.emplace_back("id", std::span<std::int64_t const>(particles.id));
    cloud.integers.emplace_back("type", std::span<std::uint8_t const>(type));
    cloud.integers.emplace_back("body", std::span<int const>(particles.body));
    cloud.integers.emplace_back("wall", std::span<int const>(wall));
    writePointCloud(path, cloud, time);
}

void writeOutline(std::filesystem::path const& path, Surface const& outline, Real time)
{
    SurfaceCells surface;
    surface.points = outline.points();
    surface.polygons = polygonsOf(outline);
    writeSurface(path, surface, time);
}

State initialState(SceneDefinition const& definition, InitialScene const& scene)
{
    State state = scene.state(definition);
    saveKernelRadius(state, definition.kernelRadius);
    return state;
}

/// The log says nothing while it lives.
struct Silence
{
    Silence() { muteLog(true); }
    ~Silence() { muteLog(false); }
    Silence(Silence const&) = delete;
    Silence& operator=(Silence const&) = delete;
};

} // namespace

void requireRunnable(CaseFolder const& caseFolder, SceneDefinition const& definition, InitialScene const& scene)
{
    Silence const silence; // the run tells its notes and warnings itself
    State const state = initialState(definition, scene);
    Scene const run(caseFolder, {.functionObjects = true, .initial = &state});
}

std::string inputFingerprint(CaseFolder const& caseFolder, std::filesystem::path const& setParticlesDict)
{
    return fingerprintOf(caseFolder, {setParticlesDict, "constant/particleProperties", "constant/rigidBodyProperties",
                                      "constant/transportProperties", "constant/g"});
}

void writeInitialFiles(CaseFolder const& caseFolder, SceneDefinition const& definition, InitialScene const& scene,
                       std::string const& report, std::string const& fingerprint)
{
    std::filesystem::path const folder = caseFolder.root() / timeName(definition.startTime);
    CheckpointInfo info;
    info.time = definition.startTime;
    info.codeVersion = MPSDEM_VERSION;
    info.inputHash = fingerprint;
    if (!definition.regions.empty()) info.effects.emplace_back("fluid");
    if (!definition.walls.empty()) info.effects.emplace_back("walls");
    if (!definition.bodies.empty()) info.effects.emplace_back("bodies");
    bool const isNew = !std::filesystem::exists(folder);
    try
    {
        writeInitialState(folder, initialState(definition, scene), info);
        if (scene.particles.size() > 0) writeParticles(folder / "particles.vtp", scene, definition.startTime);
        for (Surface const& outline : scene.placed) writeOutline(folder / (outline.name() + ".vtp"), outline, definition.startTime);
        atomicWrite(folder / "report.txt", report);
    }
    catch (CaseError const&)
    {
        std::error_code ignored;
        if (isNew) std::filesystem::remove_all(folder, ignored);
        throw;
    }
}

} // namespace mpsDem
