// Hard cases of bodies: at rest on a slope, nearly as light as water or lighter, pinned between walls.

#include <cmath>
#include <numbers>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// A block of 0.4 m x 0.1 m and 2700 kg/m3 on a slope of 10 degrees that ends at (length, 0).
void writeBlock(RunCase& run, Real length)
{
    Real const c = std::cos(10 * std::numbers::pi / 180), s = std::sin(10 * std::numbers::pi / 180);
    auto const corner = [&](Real along, Real up) {
        Real const x = 0.25 * length + along * c + up * s, y = 0.75 * length * s / c - along * s + up * c;
        return "(" + std::to_string(x) + " " + std::to_string(y) + " 0)";
    };
    run.write("constant/rigidBodyProperties", "bodies { block { shape { type polygon; points (" + corner(0, 0) + corner(0.4, 0) +
                                                  corner(0.4, 0.1) + corner(0, 0.1) + "); } density 2700; } }");
    run.write("constant/contactProperties", "mu 0.3;");
}

/// Runs to the end. @return displacement of the block since 1 s [m].
Real creep(RunCase& run, RunCase::EachStep const& eachStep = {})
{
    Vector atOneSecond = Vector::Zero();
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 1) atOneSecond = scene.bodies()[0]->centre();
        if (eachStep) eachStep(scene, step);
    });
    return (run.body().centre() - atOneSecond).norm();
}

/// What a case is computed with, and two bounds of its band.
struct Trial
{
    std::string set;     ///< schemeSet.
    Real energy;         ///< Rise above its lowest value, of that at the start.
    Real momentum;       ///< [weight of the water x 1 s].
    Real spacing = 0.05; ///< Of the block under water [m].
};

/// H5 under water.
void restUnderWater(Trial const& trial)
{
    for (std::string const face : {"dry", "pore"})
    {
        RunCase run(trial.spacing);
        run.write("system/setParticlesDict",
                  "geometry { tank { type polyline; points ((0 0.9 0) (0 0.211592 0) (1.2 0 0) (1.2 0.9 0)); } }\n"
                  "regions ( boxToParticle { box (0 0 0) (1.2 0.5 0); } );\nhydrostatic { surface 0.5; }");
        writeBlock(run, 1.2);
        run.write("system/mpsSchemes", "schemeSet " + trial.set + ";");
        run.write("system/mpsSolution", "coupling { type strong; contactFace " + face + "; }");
        run.control(20, 5e-3, budgetEntry).make();
        Watch watch;
        Series before, after; // energy of the water from 10 s to 15 s, and from then on [J]
        std::string const name = "block under water, " + trial.set + ", contact face " + face;
        Real const displacement = creep(run, [&](Scene const& scene, Step const& step) {
            watch.observe(scene, step);
            if (step.time > 10) (step.time > 15 ? after : before).add(kineticEnergy(scene) + potentialEnergy(scene));
        });
        expectBelow(name + ": creep in 19 s [m]", displacement, 1e-4);
        expectBelow(name + ": speed at 20 s [m/s]", run.body().velocity().norm(), 1e-4);
        expectInBand(name, run, watch, {.height = 0.5, .energy = trial.energy, .momentum = trial.momentum});
        expectBelow(name + ": growth of energy, 10..15 s to 15..20 s", after.mean() / before.mean() - 1, 0.005);
    }
}

/// H15: a light box on the floor of a tank beneath a fixed block: buoyancy presses it against the block, and it can go nowhere.
void pinBetweenWalls(Trial const& trial)
{
    RunCase run(0.04);
    run.write("system/mpsSchemes", "schemeSet " + trial.set + ";");
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1 0) (0 0 0) (1.2 0 0) (1.2 1 0)); }\n"
                                         " block { type searchableBox; min (0.48 0.24 0); max (0.72 0.44 0); fluidSide outside; } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\n");
    run.write("constant/rigidBodyProperties", "bodies { box { shape { type box; min (0.48 0 0); max (0.72 0.24 0); } density 500; } }");
    run.write("constant/contactProperties", "mu 0.3;");
    run.control(1, 2e-3, budgetEntry).make();
    Vector const start = run.start().bodies()[0]->centre();
    Watch watch;
    run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
    std::string const name = "pinned box, " + trial.set;
    expectBelow(name + ": displacement in 1 s [m]", (run.body().centre() - start).norm(), 0.002);
    expectBelow(name + ": speed at the end [m/s]", run.body().velocity().norm(), 0.01);
    expectBelow(name + ": largest speed of water [m/s]", watch.fastest, 1);
    expectInBand(name, run, watch, {.height = 0.6, .energy = trial.energy, .momentum = trial.momentum});
}

/// H9: a box in the midst of still water that sinks slowly, and one that floats up and out of it, and falls back.
void sinkOrFloat(Trial const& trial)
{
    for (Real const density : {1050.0, 500.0})
    {
        RunCase run(0.03);
        run.write("system/mpsSchemes", "schemeSet " + trial.set + ";");
        run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (1.2 0 0) (1.2 1.2 0)); } }\n"
                                             "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\n");
        run.write("constant/rigidBodyProperties",
                  "bodies { box { shape { type box; min (0.48 0.18 0); max (0.72 0.42 0); } density " + std::to_string(density) + "; } }");
        run.write("constant/contactProperties", "mu 0.3;");
        run.control(1.5, 2e-3, budgetEntry).make();
        Watch watch;
        run.run([&](Scene const& scene, Step const& step) { watch.observe(scene, step); });
        std::string const name = "box of " + std::to_string(static_cast<int>(density)) + " kg/m3, " + trial.set;
        expectInBand(name, run, watch, {.height = 0.6, .energy = trial.energy, .momentum = trial.momentum});
        Real const y = run.body().centre().y();
        if (density > 1000)
            expectBetween(name + ": height of its centre at 1.5 s [m]", y, 0.11, 0.3);
        else
            expectBetween(name + ": height of its centre at 1.5 s [m]", y, 0.5, 0.72);
    }
}

} // namespace

// H5: static friction holds a block on 10 degrees without any creep.
TEST(HardBodies, restsOnASlope)
{
    RunCase run(0.05);
    std::filesystem::remove(run.root() / "constant/transportProperties");
    run.write("system/setParticlesDict", "geometry { slope { type polyline; points ((0 0.352654 0) (2 0 0)); } }");
    writeBlock(run, 2);
    run.fixedSteps(20, 2e-3).make();
    expectBelow("block on 10 degrees, mu 0.3: creep in 19 s [m]", creep(run), 1e-7);
    expectBelow("block on 10 degrees, mu 0.3: speed at 20 s [m/s]", run.body().velocity().norm(), 1e-7);
}

// H5 under water, whose pressure is never quite at rest. The water sinks by 8 % at first, into the cells that the slope cuts, 4 % at half the
// spacing; from then on its energy rises.
TEST(HardBodies, restsOnASlopeUnderWater) { restUnderWater({"standard", 0.02, 1.5}); }
TEST(HardBodies, restsOnASlopeUnderWaterWithSetWaves) { restUnderWater({"waves", 0.005, 1, 0.025}); }

// Measured: 1.59 % with a dry contact face and 1.48 % with pore pressure; set waves 0.73 and 0.74 %. At half the spacing 0.85 % (pore, 10 s)
// and, with the set waves, 0.15 and 0.17 %.
TEST(HardBodies, DISABLED_restsOnASlopeUnderWaterWithoutGainOfEnergy)
{
    for (std::string const set : {"standard", "waves"}) restUnderWater({set, 0.005, 1.5});
}

// Measured: 1.40 with a dry contact face, 1.37 with pore pressure (set waves: 1.25, 1.39; at half the spacing 0.91, 0.93), that is 7 % of the
// water's weight throughout the 20 s; without the block 0.063 in 20 s. It belongs to the body and to the spacing: it points off the slope and
// grows evenly, by 0.062 a second at a spacing of 0.05 m and 0.031 at 0.025 m (in 5 s). Tried in 5 s: without dynamic labelling 0.067 a second.
// Without the block, in 20 s: no shifting 0.99, p = 0 at the centre of surface particles 1.23, eq 4 0.23, no surface damping 0.24. So it is what
// water and body do not get from each other (Gradient and PI).
TEST(HardBodies, DISABLED_restsOnASlopeUnderWaterKeepingMomentum) { restUnderWater({"standard", 0.02, 20 * 0.02}); }

TEST(HardBodies, sinksOrFloatsNearTheDensityOfWater) { sinkOrFloat({"standard", 0.02, 0.02}); }
TEST(HardBodies, sinksOrFloatsWithSetWaves) { sinkOrFloat({"waves", 0.005, 0.02}); }

// Measured: 1.33 % (1050 kg/m3) and 1.02 % (500 kg/m3): water whose rows dissolve swells where its density is read from n (bounds.md).
TEST(HardBodies, DISABLED_sinksOrFloatsWithoutGainOfEnergy) { sinkOrFloat({"standard", 0.005, 0.02}); }

TEST(HardBodies, staysPinnedBetweenTwoWalls) { pinBetweenWalls({"standard", 0.02, 0.04}); }
TEST(HardBodies, staysPinnedBetweenTwoWallsWithSetWaves) { pinBetweenWalls({"waves", 0.005, 0.04}); }

// Measured: 0.93 %, as above.
TEST(HardBodies, DISABLED_staysPinnedBetweenTwoWallsWithoutGainOfEnergy) { pinBetweenWalls({"standard", 0.005, 0.04}); }

// Measured: 0.0295 in 1 s and 0.098 in 3 s, upwards; 0.0127 in 1 s at a spacing of 0.02 m instead of 0.04 m, and 0.0015 without the box. As at
// H5 it is of first order in the spacing: what water and body do not get from each other.
TEST(HardBodies, DISABLED_staysPinnedBetweenTwoWallsKeepingMomentum) { pinBetweenWalls({"standard", 0.02, 0.02}); }

} // namespace mpsDem::test
