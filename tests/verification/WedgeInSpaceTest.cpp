// The wedge of Heinrich (1992) in a channel between side walls, in 3-D and in 2-D at the same spacing: without friction at the side walls the
// motion is the same in every section.

#include <array>
#include <cmath>

#include "functionObjects/SurfaceElevation.h"
#include "support/Curve.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real hold = 0.2; ///< The water settles so long around the held wedge [s].
constexpr std::array gauges{1.5, 1.75, 2.0, 2.25, 2.5, 3.0};
constexpr Real columnWidth = 6; ///< Of a gauge, in spacings, and width of the channel: single particles do not count so.

struct Wave
{
    Curve z;                                 ///< Way down of the slide over time since its release [m].
    std::array<Real, gauges.size()> crest{}; ///< Of the first wave, above the level of the settled water [m].
};

void writeCase(RunCase& run, Real spacing, bool inSpace)
{
    std::string const width = std::to_string(columnWidth * spacing), range = inSpace ? "zRange (0 " + width + "); " : "";
    if (inSpace)
        run.threeDimensions();
    else
        run.write("constant/particleProperties", "spacing " + std::to_string(spacing) + "; thickness " + width + ";");
    // Cut cells are filled as in 3-D: empty ones let the water of 2-D sink by up to 6 mm at 0.04 m while the wave comes.
    run.write("system/setParticlesDict",
              "lattice { cutCells fill; } geometry { tank { type polyline; points ((-0.6 1.6 0) (1 0 0) (4.5 0 0) (4.5 1.6 0)); " + range +
                  (inSpace ? "sideWalls yes; " : "") + "} }\nregions ( boxToParticle { box (-0.6 0 0) (4.5 1 " + width +
                  "); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); " + range +
                  "} density 2036; releaseTime 0.2; constraints { along { sixDoFRigidBodyMotionConstraint plane; normal (0 0 1); } "
                  "noTurn { sixDoFRigidBodyMotionConstraint axis; axis (0 0 1); } } } }");
    run.write("constant/contactProperties",
              "mu 0.0104724; e 0.2;\n"
              "stoppers { foot { type latch; body slide; point (0.95 0.05 0); normal (-0.70710678 0.70710678 0); } }");
    run.write("system/mpsSolution", "coupling { type strong; }");
    if (!inSpace)
        run.write("system/mpsSchemes", "sourceSchemes { divergence corrected; density smooth; }"); // nearest to the standard of 3-D
    run.control(1.5 + hold, 2e-3).make();
}

Wave wave(Real spacing, bool inSpace)
{
    RunCase run(spacing);
    writeCase(run, spacing, inSpace);
    Scene& scene = run.start();
    SurfaceElevationControls controls;
    controls.width = columnWidth;
    SurfaceElevation surface(scene.particles(), controls, Vector::UnitY());
    Real const top = scene.bodies()[0]->centre().y(), middle = inSpace ? columnWidth * spacing / 2 : 0;
    std::array<Series, gauges.size()> level, elevation;
    Wave result;
    while (scene.time().running())
    {
        Step const step = run.step();
        Real const time = step.time - hold;
        result.z.add(time, top - scene.bodies()[0]->centre().y());
        if (step.number % 5 != 0) continue;
        surface.update();
        for (std::size_t k = 0; k < gauges.size(); ++k)
            (time < 0 ? level : elevation)[k].add(surface.elevation(Vector(gauges[k], 0, middle)).value_or(0));
    }
    for (std::size_t k = 0; k < gauges.size(); ++k) result.crest[k] = elevation[k].largest() - level[k].mean();
    return result;
}

void compare(Real spacing)
{
    Wave const flat = wave(spacing, false), space = wave(spacing, true);
    Real way = 0, sum = 0, size = 0;
    for (Real const t : {0.2, 0.4, 0.6, 0.8, 1.0})
    {
        std::printf("    t = %.1f s: z = %.4f m in 2-D, %.4f m in 3-D\n", t, flat.z.at(t), space.z.at(t));
        way = std::max(way, std::abs(space.z.at(t) - flat.z.at(t)));
    }
    for (std::size_t k = 0; k < gauges.size(); ++k)
    {
        std::printf("    x = %.2f m: first crest %.4f m in 2-D, %.4f m in 3-D\n", gauges[k], flat.crest[k], space.crest[k]);
        sum += space.crest[k] / flat.crest[k] - 1;
        size += std::abs(space.crest[k] / flat.crest[k] - 1);
    }
    std::string const name = "wedge in 3-D, spacing " + std::to_string(spacing);
    expectBelow(name + ": z(t), difference from 2-D over 0.44 m", way / 0.44, 0.05);
    expectBelow(name + ": first crest, mean difference from 2-D", sum / gauges.size(), 0.05);
    expectBelow(name + ": first crest, mean size of the differences from 2-D", size / gauges.size(), 0.05);
}

} // namespace

TEST(WedgeInSpaceGate, movesAndMakesWavesAsIn2D) { compare(0.03); }

TEST(WedgeInSpaceGate, movesAndMakesWavesAsIn2DAtAFinerSpacing) { compare(0.025); }

// Measured: first crests in 3-D 14, 13 and 12 % above 2-D at x = 1.5, 1.75 and 2 m. 2-D at 0.04 m is itself 8 % below its own crests at 0.02 m
// there, 3-D 5 % above those: too coarse for a comparison to 5 % (etc/doc/three-dimensions.md).
TEST(WedgeInSpaceGate, DISABLED_movesAndMakesWavesAsIn2DAtACoarserSpacing) { compare(0.04); }

} // namespace mpsDem::test
