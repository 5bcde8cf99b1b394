// setParticles in 3-D: walls, bodies and fluid from a case folder, and the state that comes back.

#include <fstream>

#include "io/Checkpoint.h"
#include "io/StlFile.h"
#include "scene/InitialFiles.h"
#include "scene/InitialReport.h"
#include "support/Measured.h"
#include "support/SmallCase.h"

namespace mpsDem::test {

namespace {

/// A channel with a ramp, half full of water, and a wedge across it that stands on the ramp.
SmallCase& spaceCase(SmallCase& made)
{
    made.write("constant/particleProperties", "dimensions 3; spacing 0.05;");
    made.write("constant/rigidBodyProperties", "bodies { slide { shape { type polygon; points ((0.2 0.8 0) (0.6 0.4 0) (0.6 0.8 0)); "
                                               "zRange (0.1 0.4); } density 2000; } }");
    made.write("system/setParticlesDict",
               "geometry { bed { type polyline; points ((-0.2 1.2 0) (1 0 0) (2 0 0) (2 1.2 0)); zRange (0 0.5); sideWalls yes; } }\n"
               "regions ( boxToParticle { box (-0.2 0 0) (2 0.5 0.5); } );\n");
    return made;
}

struct Made
{
    SceneDefinition definition;
    InitialScene scene;
};

Made make(SmallCase const& made)
{
    CaseFolder const folder(made.root());
    SceneDefinition definition = readSceneDefinition(folder, "system/setParticlesDict");
    InitialScene scene = makeInitialScene(definition);
    return {std::move(definition), std::move(scene)};
}

} // namespace

TEST(SpaceScene, fillsAChannelWithItsVolumeOfWater)
{
    SmallCase folder;
    Made const made = make(spaceCase(folder));
    Real const area = 1 * 0.5 + 0.5 * 0.5 * 0.5, wedge = 0.5 * 0.1 * 0.1 * 0.3; // of the wedge below the water line
    expectBelow("volume of the regions, relative error", made.scene.fluid.volume / (area * 0.5 - wedge) - 1, 0.01);
    Real const filled = made.scene.particles.fluid().size() * made.definition.lattice.particleVolume();
    expectBelow("volume of the particles, relative error", filled / (area * 0.5 - wedge) - 1, 0.06); // half a row on the ramp
    for (int const i : made.scene.particles.fluid())
    {
        Vector const& r = made.scene.particles.r[static_cast<std::size_t>(i)];
        EXPECT_TRUE(r.z() > 0 && r.z() < 0.5 && r.y() > 0 && r.x() + r.y() > 1) << r.transpose();
    }
}

TEST(SpaceScene, givesTheBodyItsMassAndTheRampAsSupport)
{
    SmallCase folder;
    Made const made = make(spaceCase(folder));
    MassProperties const& properties = made.definition.bodies[0]->massProperties();
    EXPECT_NEAR(properties.mass, 2000 * 0.08 * 0.3, 1e-9);
    EXPECT_NEAR((properties.centreOfMass - Vector(0.2 + 0.8 / 3, 0.4 + 0.8 / 3, 0.25)).norm(), 0, 1e-12);
    BodyOutlook const outlook = bodyOutlook(made.definition, made.scene, 0, std::nullopt);
    EXPECT_NEAR(outlook.support.distance, 0, 1e-9);
    EXPECT_NEAR(outlook.slope, std::acos(std::sqrt(0.5)), 1e-6);
    std::string const report = initialReport(made.definition, made.scene, std::nullopt);
    for (char const* piece : {"3-D", "slope 45 degrees", "inertia"}) EXPECT_NE(report.find(piece), std::string::npos) << report;
}

TEST(SpaceScene, givesBackTheSurfacesThatWereSaved)
{
    SmallCase folder;
    Made const made = make(spaceCase(folder));
    State const state = made.scene.state(made.definition);
    auto const walls = loadSurfaces(state);
    ASSERT_EQ(walls.size(), 1u);
    EXPECT_FALSE(walls[0].flat());
    EXPECT_EQ(walls[0].points(), made.scene.surfaces[0].points());
    EXPECT_EQ(walls[0].triangles().patches(), 5);
    BodyOutline const outline = loadOutline(state, "slide");
    EXPECT_TRUE(outline.outline.closed());
    EXPECT_NEAR(outline.outline.triangles().volume(), 0.08 * 0.3, 1e-12);
}

TEST(SpaceScene, readsWallsAndBodiesFromFiles)
{
    SmallCase folder;
    spaceCase(folder);
    std::filesystem::create_directories(folder.root() / "constant/triSurface");
    writeStl(folder.root() / "constant/triSurface/cube.stl", TriSurface::box("cube", {0, 0, 0}, {200, 200, 200}));
    std::ofstream(folder.root() / "constant/triSurface/floor.asc")
        << "ncols 5\nnrows 3\nxllcorner -1\nyllcorner -1.2\ncellsize 0.8\n0 0 0 0 0\n0 0 0 0 0\n0 0 0 0 0\n";
    folder.write("constant/rigidBodyProperties", "bodies { cube { shape { type triSurfaceMesh; file \"cube.stl\"; scale 0.001; translate "
                                                 "(1 0.4 0.15); } density 500; } }");
    folder.write("system/setParticlesDict", "geometry { floor { type rasterSurface; file \"floor.asc\"; }\n"
                                            "sides { type searchableBox; min (0 -0.5 0); max (2 1 0.5); open (bottom top); } }\n"
                                            "regions ( boxToParticle { box (0 -0.2 0) (2 0.5 0.5); } );\n");
    Made const made = make(folder);
    EXPECT_NEAR(made.definition.bodies[0]->massProperties().mass, 4, 1e-5);
    Real const volume = 2 * 0.5 * 0.5 - 0.2 * 0.2 * 0.1;
    expectBelow("water between raster and box, relative error", made.scene.fluid.volume / volume - 1, 0.01);
    int onFloor = 0;
    for (std::size_t i = 0; i < made.scene.wallOf.size(); ++i)
        onFloor += made.scene.wallOf[i] == 0 && made.scene.particles.type[i] == ParticleType::Wall ? 1 : 0;
    expectBetween("wall particles of the floor", onFloor, 460, 540); // 400 on 2 x 0.5 m, 100 along its joints with the sides
}

} // namespace mpsDem::test
