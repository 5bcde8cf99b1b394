// Hard cases of bodies: at rest on a slope, hitting an end stop, nearly as light as water or lighter, pinned between walls.

#include <cmath>
#include <numbers>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// A slope of 45 degrees into 1 m of water, and the wedge of 0.5 m on it. @param top  Height of its upper side [m].
void writeSlope(RunCase& run, Real top, std::string const& motion)
{
    auto const point = [&](Real x, Real y) { return "(" + std::to_string(x) + " " + std::to_string(y) + " 0)"; };
    run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (2.2 0 0) (2.2 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (2.2 1 0); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties", "bodies { slide { shape { type polygon; points (" + point(1 - top, top) +
                                                  point(1.5 - top, top - 0.5) + point(1.5 - top, top) + "); } density 2036; " + motion +
                                                  " } }");
}

/// The wedge arrives at its end stop with 3 m/s under water.
void hitStop(std::string const& name, std::string const& stop, bool locks)
{
    RunCase run(0.04);
    writeSlope(run, 0.6, "velocity (2.1213 -2.1213 0);");
    run.write("constant/contactProperties",
              "mu 0.0105; stoppers { foot { " + stop + " body slide; point (1 0 0); normal (-0.70710678 0.70710678 0); } }");
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.control(0.4, 1e-3).make();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
    expectBelow(name + ": largest speed of water over sqrt(2 g H)", watch.fastest / std::sqrt(2 * 9.81), 3);
    expectBelow(name + ": particles lost", static_cast<Real>(run.scene().fluid()->escaped()), 0);
    if (locks)
    {
        EXPECT_TRUE(run.body().locked());
    }
    expectBelow(name + ": speed of the slide at the end [m/s]", run.body().velocity().norm(), 1);
}

} // namespace

// H5: the static friction of a block on 10 degrees, without water.
TEST(HardBodies, restsOnASlope)
{
    RunCase run(0.05);
    std::filesystem::remove(run.root() / "constant/transportProperties");
    run.write("system/setParticlesDict", "geometry { slope { type polyline; points ((0 0.352654 0) (2 0 0)); } }");
    Real const c = std::cos(10 * std::numbers::pi / 180), s = std::sin(10 * std::numbers::pi / 180);
    auto const corner = [&](Real along, Real up) {
        return "(" + std::to_string(0.5 + along * c + up * s) + " " + std::to_string(0.352654 - 0.5 * s / c - along * s + up * c) + " 0)";
    };
    run.write("constant/rigidBodyProperties", "bodies { block { shape { type polygon; points (" + corner(0, 0) + corner(0.4, 0) +
                                                  corner(0.4, 0.1) + corner(0, 0.1) + "); } density 2700; } }");
    run.write("constant/contactProperties", "mu 0.3;");
    run.fixedSteps(5, 2e-3).make();
    Vector atOneSecond = Vector::Zero();
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 1) atOneSecond = scene.bodies()[0]->centre();
    });
    expectBelow("block on 10 degrees, mu 0.3: creep in 4 s [m]", (run.body().centre() - atOneSecond).norm(), 1e-7);
    expectBelow("block on 10 degrees, mu 0.3: speed at 5 s [m/s]", run.body().velocity().norm(), 1e-7);
}

// H1
TEST(HardBodies, hitsALatchAtThreeMetresPerSecond) { hitStop("latch at 3 m/s", "type latch;", true); }
TEST(HardBodies, hitsAStopperAtThreeMetresPerSecond) { hitStop("stopper at 3 m/s", "type stopper; e 0.1;", false); }

// H9
TEST(HardBodies, sinksOrFloatsNearTheDensityOfWater)
{
    for (Real const density : {1050.0, 500.0})
    {
        RunCase run(0.03);
        run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (1.2 0 0) (1.2 1.2 0)); } }\n"
                                             "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\n");
        run.write("constant/rigidBodyProperties",
                  "bodies { box { shape { type box; min (0.48 0.18 0); max (0.72 0.42 0); } density " + std::to_string(density) + "; } }");
        run.write("constant/contactProperties", "mu 0.3;");
        run.control(1.5, 2e-3).make();
        Watch watch;
        run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
        std::string const name = "box of " + std::to_string(static_cast<int>(density)) + " kg/m3";
        expectBelow(name + ": rise of energy over that of the start", watch.rise / watch.start, 0.02);
        expectBelow(name + ": largest speed of water over sqrt(2 g H)", watch.fastest / std::sqrt(2 * 9.81 * 0.6), 3);
        if (density > 1000)
            expectBetween(name + ": height of its centre at 1.5 s [m]", run.body().centre().y(), 0.11, 0.3);
        else
            expectBetween(name + ": height of its centre at 1.5 s [m]", run.body().centre().y(), 0.5, 0.72);
    }
}

// H15: a light box on the floor of a tank beneath a fixed block: buoyancy presses it against the block, and it can go nowhere.
TEST(HardBodies, staysPinnedBetweenTwoWalls)
{
    RunCase run(0.04);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1 0) (0 0 0) (1.2 0 0) (1.2 1 0)); }\n"
                                         " block { type searchableBox; min (0.48 0.24 0); max (0.72 0.44 0); fluidSide outside; } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\n");
    run.write("constant/rigidBodyProperties", "bodies { box { shape { type box; min (0.48 0 0); max (0.72 0.24 0); } density 500; } }");
    run.write("constant/contactProperties", "mu 0.3;");
    run.control(1, 2e-3).make();
    Vector const start = run.start().bodies()[0]->centre();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
    expectBelow("pinned box: displacement in 1 s [m]", (run.body().centre() - start).norm(), 0.002);
    expectBelow("pinned box: speed at the end [m/s]", run.body().velocity().norm(), 0.01);
    expectBelow("pinned box: largest speed of water [m/s]", watch.fastest, 1);
}

} // namespace mpsDem::test
