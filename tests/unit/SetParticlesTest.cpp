#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/Log.h"
#include "io/Checkpoint.h"
#include "io/VtkFile.h"
#include "scene/InitialFiles.h"
#include "scene/InitialReport.h"
#include "scene/InitialState.h"
#include "support/SmallCase.h"

namespace {

using namespace mpsDem;
using test::SmallCase;

struct Made
{
    SceneDefinition definition;
    InitialScene scene;
};

Made make(SmallCase const& testCase)
{
    SceneDefinition definition = readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
    InitialScene scene = makeInitialScene(definition);
    return {std::move(definition), std::move(scene)};
}

TEST(SetParticles, WedgeCaseHasItsParticlesPressureAndMass)
{
    SmallCase const testCase;
    Made const made = make(testCase);
    ParticleSet const& particles = made.scene.particles;
    // Region without ramp and wedge: 2 - 0.5 - 0.08 m2; lattice points on the diagonal are lost.
    EXPECT_NEAR(made.scene.fluid.volume, 0.5 * (2 - 0.5 - 0.08), 2e-4);
    EXPECT_NEAR(particles.fluid().size() * particles.lattice().particleVolume(), made.scene.fluid.volume, 0.03 * made.scene.fluid.volume);
    for (int const i : particles.fluid())
    {
        auto const k = static_cast<std::size_t>(i);
        EXPECT_NEAR(particles.p[k], 1000 * 10 * (1 - particles.r[k].y()), 1e-6 * 1e4);
    }
    EXPECT_EQ(made.scene.wallOf.size(), static_cast<std::size_t>(particles.boundary().size()));
    for (int const i : particles.boundary())
    {
        auto const k = static_cast<std::size_t>(i);
        EXPECT_EQ(made.scene.wallOf[k], particles.body[k] < 0 ? 0 : -1);
        EXPECT_NEAR(particles.normal[k].norm(), 1, 1e-12);
    }
    EXPECT_NEAR(made.definition.bodies[0]->mass(), 2000 * 0.08 * 0.5, 1e-9);
}

TEST(SetParticles, StateComesBackWithSurfacesOutlinesAndBodies)
{
    SmallCase const testCase;
    Made const made = make(testCase);
    CaseFolder const folder(testCase.root());
    writeInitialFiles(folder, made.definition, made.scene, "report\n", "00000000");
    Checkpoint const saved = readCheckpoint(testCase.root() / "0");
    EXPECT_EQ(saved.info.time, 0);
    EXPECT_EQ(saved.state.integer("time/step"), 0);

    ParticleSet particles(made.definition.lattice);
    particles.load(saved.state);
    EXPECT_EQ(particles.r, made.scene.particles.r);
    auto const surfaces = loadSurfaces(saved.state);
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_EQ(surfaces[0].name(), "bed");
    EXPECT_EQ(surfaces[0].points(), made.scene.surfaces[0].points());
    EXPECT_EQ(surfaces[0].line().segments()[1].normal, made.scene.surfaces[0].line().segments()[1].normal);
    EXPECT_EQ(loadWallOf(saved.state, static_cast<std::size_t>(particles.boundary().size()), 1), made.scene.wallOf);

    auto const bodies = readBodies(folder.read("constant/rigidBodyProperties"), saved.state, {made.definition.lattice, folder.root()});
    BodyOutline const outline = loadOutline(saved.state, "slide");
    EXPECT_EQ(outline.radius, 0);
    Surface const placed = outline.outline.moved(bodies[0]->rotation(), bodies[0]->centre());
    EXPECT_NEAR((placed.points()[1] - Vector(0.6, 0.4, 0)).norm(), 0, 1e-12);

    PointCloudData const cloud = readPointCloud(testCase.root() / "0" / "particles.vtp");
    EXPECT_EQ(cloud.position.size(), particles.r.size());
    EXPECT_EQ(std::count(cloud.integers.at("type").begin(), cloud.integers.at("type").end(), 0), particles.fluid().size());
    EXPECT_EQ(readSurface(testCase.root() / "0" / "slide.vtp").polygons.size(), 1u);
}

TEST(SetParticles, NamesAndOrderOfManyWallsSurvive)
{
    State state;
    std::vector<Surface> surfaces;
    for (int k = 0; k < 12; ++k)
        surfaces.emplace_back(Polyline("wall" + std::to_string(11 - k), std::vector<Vector>{{0, 1.0 * k, 0}, {1, 1.0 * k, 0}}, false,
                                       k % 2 ? Polyline::FluidSide::Right : Polyline::FluidSide::Left));
    saveSurfaces(state, surfaces);
    auto const back = loadSurfaces(state);
    ASSERT_EQ(back.size(), surfaces.size());
    for (std::size_t k = 0; k < back.size(); ++k)
    {
        EXPECT_EQ(back[k].name(), surfaces[k].name());
        EXPECT_EQ(back[k].line().segments()[0].normal, surfaces[k].line().segments()[0].normal);
    }
}

TEST(SetParticles, OrientationNamesTheBodyAxesWithoutTurningTheShape)
{
    SmallCase const testCase;
    testCase.write("constant/rigidBodyProperties", "bodies { slide { shape { type box; min (1 0.5 0); max (1.4 0.7 0); } density 500; "
                                                   "orientation (0 -1 0 1 0 0 0 0 1); } }");
    Made const made = make(testCase);
    EXPECT_NEAR((made.scene.placed[0].points()[0] - Vector(1, 0.5, 0)).norm(), 0, 1e-12);
    // R^T (x - c) for a quarter turn: (-0.2, -0.1) becomes (-0.1, 0.2).
    EXPECT_NEAR((made.scene.outlines[0].outline.points()[0] - Vector(-0.1, 0.2, 0)).norm(), 0, 1e-12);
    ParticleSet const& particles = made.scene.particles;
    for (int const i : particles.boundary())
        if (particles.body[static_cast<std::size_t>(i)] == 0)
        {
            EXPECT_TRUE(made.scene.placed[0].line().encloses(particles.r[static_cast<std::size_t>(i)]));
        }
}

TEST(SetParticles, CylinderKeepsItsRadius)
{
    SmallCase const testCase;
    testCase.write("constant/rigidBodyProperties",
                   "bodies { float { shape { type cylinder; centre (1.3 0.6 0); radius 0.2; } density 500; velocity (0 1 0); } }");
    Made const made = make(testCase);
    EXPECT_EQ(made.scene.outlines[0].radius, 0.2);
    EXPECT_GE(made.scene.outlines[0].outline.points().size(), 64u);
    ParticleSet const& particles = made.scene.particles;
    for (int const i : particles.boundary())
        if (particles.body[static_cast<std::size_t>(i)] == 0)
        {
            EXPECT_EQ(particles.u[static_cast<std::size_t>(i)], Vector(0, 1, 0));
        }
    BodyOutlook const outlook = bodyOutlook(made.definition, made.scene, 0, std::nullopt);
    EXPECT_NEAR(outlook.submergedWeight, -500 * 3.14159265 * 0.04 * 0.5 * 10, 1e-3);
    muteLog(true);
    std::string const report = initialReport(made.definition, made.scene, std::nullopt);
    muteLog(false);
    EXPECT_NE(report.find("floats"), std::string::npos);
}

TEST(SetParticles, OutlookSaysWhetherFrictionHoldsTheBody)
{
    SmallCase const testCase;
    Made const made = make(testCase);
    auto const contact = Dictionary::fromText("mu 1.2; pairs { \"bed:slide\" { mu 0.5; } }");
    BodyOutlook const outlook = bodyOutlook(made.definition, made.scene, 0, contact);
    Real const weight = (2000 - 1000) * 0.08 * 0.5 * 10;
    EXPECT_NEAR(outlook.submergedWeight, weight, 1e-9);
    EXPECT_NEAR(outlook.support.distance, 0, 1e-12);
    EXPECT_NEAR(outlook.slope, std::atan(1.0), 1e-9);
    EXPECT_NEAR(outlook.drive, weight / std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(outlook.resistance, 0.5 * weight / std::sqrt(2.0), 1e-6);
    muteLog(true);
    EXPECT_NE(initialReport(made.definition, made.scene, contact).find("slides"), std::string::npos);
    EXPECT_NE(initialReport(made.definition, made.scene, Dictionary::fromText("mu 1.2;")).find("stays"), std::string::npos);
    muteLog(false);
}

TEST(SetParticles, PressureFollowsTheRegionAboveOrTheSurfaceGiven)
{
    SmallCase const testCase;
    testCase.remove("constant/rigidBodyProperties");
    std::string const tank = "geometry { tank { type searchableBox; min (0 0 0); max (2 1 0); open (top); } }\n";
    std::string const dam = "regions ( boxToParticle { box (0 0 0) (0.5 0.5 0); } boxToParticle { box (0.5 0 0) (2 0.1 0); } );";
    testCase.write("system/setParticlesDict", tank + dam);
    SceneDefinition const step = readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
    EXPECT_NEAR(hydrostaticPressure(step, {0.25, 0.1, 0}), 4000, 1e-2);
    EXPECT_NEAR(hydrostaticPressure(step, {1.25, 0.05, 0}), 500, 1e-2);

    testCase.write("system/setParticlesDict", tank + dam + " hydrostatic { surface 0.4; }");
    SceneDefinition const level = readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
    EXPECT_NEAR(hydrostaticPressure(level, {0.25, 0.1, 0}), 3000, 1e-9);
    EXPECT_EQ(hydrostaticPressure(level, {0.25, 0.45, 0}), 0);

    testCase.write("system/setParticlesDict", tank + dam + " hydrostatic { active no; }");
    SceneDefinition const none = readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict");
    EXPECT_EQ(hydrostaticPressure(none, {0.25, 0.1, 0}), 0);
}

TEST(SetParticles, BoxesMayBeOpenAndCirclesLieOutside)
{
    Lattice const lattice{2, 0.05, 1};
    auto const dict =
        Dictionary::fromText("geometry { tank { type searchableBox; min (0 0 0); max (2 1 0); open (top left); }"
                             " pile { type searchableCylinder; point1 (1 0.5 0); point2 (1 0.5 1); radius 0.2; }"
                             " roof { type searchablePlate; origin (0 1 0); span (2 0 0); } }"
                             "walls ( { name basin; surface tank; } { surface pile; } { surface roof; side right; thickness 0.2; } );");
    auto const walls = readWalls(dict, {lattice, {}}, 2.1);
    dict.requireAllRead();
    ASSERT_EQ(walls.size(), 3u);
    EXPECT_EQ(walls[0].surface.name(), "basin");
    EXPECT_EQ(walls[0].surface.points().size(), 3u); // bottom and right
    EXPECT_FALSE(walls[0].surface.closed());
    EXPECT_EQ(walls[0].surface.line().segments()[0].normal, Vector(0, 1, 0));
    EXPECT_EQ(walls[0].surface.line().segments()[1].normal, Vector(-1, 0, 0));
    EXPECT_LT(walls[1].surface.line().closest({1, 0.5, 0}).distance, 0);
    EXPECT_EQ(walls[2].surface.line().segments()[0].normal, Vector(0, -1, 0));
    EXPECT_EQ(walls[2].ghostRows, 3);
    EXPECT_EQ(walls[0].ghostRows, 2);
}

TEST(SetParticles, PaperSchemesGetMoreGhostRows)
{
    SmallCase const testCase;
    testCase.write("system/mpsSchemes", "kernel { gradient 2.1; laplacian 3.1; }");
    EXPECT_EQ(readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict").walls[0].ghostRows, 3);
    testCase.write("system/mpsSchemes", "schemeSet paper;");
    EXPECT_EQ(readSceneDefinition(CaseFolder(testCase.root()), "system/setParticlesDict").walls[0].ghostRows, 4);
}

TEST(SetParticles, StartTimeNamesTheFolder)
{
    EXPECT_EQ(timeName(0), "0");
    EXPECT_EQ(timeName(0.25), "0.25");
    SmallCase const testCase;
    testCase.write("system/controlDict", "startTime 0.25; endTime 1;");
    Made const made = make(testCase);
    writeInitialFiles(CaseFolder(testCase.root()), made.definition, made.scene, "report\n", "00000000");
    EXPECT_EQ(readCheckpoint(testCase.root() / "0.25").info.time, 0.25);
}

TEST(SetParticles, SpecimensOfTheDictionariesAreValid)
{
    std::filesystem::path const folder = std::filesystem::path(MPSDEM_ETC) / "caseDicts";
    auto const read = [&](char const* name) {
        auto const dict = Dictionary::fromFile(folder / name, folder);
        dict.requireHeader();
        return dict;
    };
    Lattice const lattice = readLattice(read("particleProperties"));
    EXPECT_EQ(lattice.thickness, 0.55);

    auto const dict = read("setParticlesDict");
    EXPECT_EQ(readWalls(dict, {lattice, {}}, 2.1).size(), 5u);
    EXPECT_EQ(readRegions(dict, lattice).size(), 4u);
    EXPECT_EQ(LatticePlacement::read(dict).jitter, 0);
    dict.ignore("hydrostatic");
    dict.requireAllRead();

    auto const bodies = readBodies(read("rigidBodyProperties"), {lattice, {}}, 0);
    ASSERT_EQ(bodies.size(), 1u);
    EXPECT_EQ(bodies[0]->mass(), 140);
}

} // namespace
