// The wedge of Heinrich (1992) that falls into 0.4 m of water, per metre of width: 0.5 m high, 2036 kg/m3, on a ramp of 45 degrees, its lower
// edge at the water line, held 0.05 m above the floor: tutorials/landslide/subaerialWedge2D at 0.04 m, with the set `standard`. Times count
// from its release.

#include <algorithm>

#include "functionObjects/SurfaceElevation.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real depth = 0.4, hold = 0.2, spacing = 0.04, gaugeX = 4;

void writeCase(RunCase& run, Real endTime)
{
    run.write("system/setParticlesDict", "geometry { ramp { type polyline; points ((-0.6 1.6 0) (1 0 0)); }\n"
                                         " tank { type polyline; points ((1 0 0) (7 0 0) (7 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (7 0.4 0); } );\nhydrostatic { surface 0.4; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.1 0.9 0) (0.6 0.4 0) (0.6 0.9 0)); } density 2036; releaseTime 0.2; } }");
    run.write("constant/contactProperties",
              "mu 0.0104724; e 0.2;\n"
              "stoppers { foot { type latch; body slide; point (0.95 0.05 0); normal (-0.70710678 0.70710678 0); } }");
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.control(endTime + hold, 2e-3).make();
}

/// Highest elevation of the free surface above the floor between two places [m].
Real highest(SurfaceElevation const& surface, Real from, Real to)
{
    Real height = 0;
    for (Real x = from; x < to; x += spacing) height = std::max(height, surface.elevation(Vector(x, 0, 0)).value_or(0));
    return height;
}

/// What is measured. In front of the wedge that stands still, x > 0.95 m, the water first leaves a cavity, and the sheet that it threw up falls.
struct Plunge
{
    Real stop = 0;                     ///< Time at which the wedge stands still [s].
    Real cavity = depth, filledAt = 0; ///< Least elevation at the wedge after the stop [m]; when it is half of the depth again [s].
    Real sheet = 9, fallenAt = 0;      ///< Least height of the sheet from 0.5 to 1 s [m], and when: it has rolled over [s].
    Real crest = 0, crestAt = 0;       ///< First crest at the gauge [m], and when [s].
};

/// Takes in the state at a time since the release [s].
void observe(Plunge& found, SurfaceElevation const& surface, bool stands, Real time)
{
    if (found.stop == 0 && stands) found.stop = time;
    Real const atWedge = surface.elevation(Vector(0.99, 0, 0)).value_or(0);
    if (stands && found.filledAt == 0)
    {
        found.cavity = std::min(found.cavity, atWedge);
        if (found.cavity < 0.5 * depth && atWedge >= 0.5 * depth) found.filledAt = time;
    }
    if (time > 0.5 && time < 1)
    {
        Real const height = highest(surface, 0.99, 3);
        if (height < found.sheet)
        {
            found.sheet = height;
            found.fallenAt = time;
        }
    }
    Real const eta = surface.elevation(Vector(gaugeX, 0, 0)).value_or(depth) - depth;
    bool const past = time - found.crestAt > 0.3 && found.crest > 0.04; // the second crest is higher
    if (past || eta <= found.crest) return;
    found.crest = eta;
    found.crestAt = time;
}

Plunge plunge(Real endTime)
{
    RunCase run(spacing);
    writeCase(run, endTime);
    Plunge found;
    SurfaceElevation surface(run.start().particles(), SurfaceElevationControls{}, Vector(0, 1, 0));
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < hold) return;
        surface.update();
        observe(found, surface, scene.bodies()[0]->locked(), step.time - hold);
    });
    return found;
}

} // namespace

// Reference: the same set at 0.02 m, stop at 0.400 s and a first crest of 0.078 m at 1.93 s (with `waves`, as the tutorial: 0.115 m at
// 2.02 s). Of the water the paper tells that it detaches from the stopped wedge, and that it rolls over and forms the first wave at 0.75 s.
TEST(SubaerialWedgeGate, leavesACavityThatClosesAndAWave)
{
    Plunge const found = plunge(2.6);
    expectBelow("subaerial wedge: stop, relative difference to that at 0.02 m", found.stop / 0.4 - 1, 0.03);
    expectBelow("subaerial wedge: least elevation at the stopped wedge over the depth", found.cavity / depth, 0.25);
    expectBetween("subaerial wedge: cavity half full again [s]", found.filledAt, 0.6, 0.9);
    expectBetween("subaerial wedge: sheet has rolled over [s]", found.fallenAt, 0.65, 0.85);
    expectBetween("subaerial wedge: first crest at x = 4 m [m]", found.crest, 0.9 * 0.078, 1.1 * 0.078);
    expectBetween("subaerial wedge: time of the first crest [s]", found.crestAt, 0.95 * 1.93, 1.05 * 1.93);
}

// The paper tells of a stop at about 0.53 s. Measured: 0.398 s at 0.04 m. Without any water the assumed way of 0.35 m down takes 0.380 s, so
// the way is another one or the time does not count from the release: tried in the tutorial (Allrun-sensitivity, set `waves`) legs of 0.45
// and 0.55 m (0.396, 0.400 s), a stop on the floor (0.430 s), and an edge 0.25 m above the water (0.511 s).
TEST(SubaerialWedgeGate, DISABLED_stopsWhenThePaperTells)
{
    expectBetween("subaerial wedge: stop [s]", plunge(0.6).stop, 0.95 * 0.53, 1.05 * 0.53);
}

} // namespace mpsDem::test
