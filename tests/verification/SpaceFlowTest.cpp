// Fluid in 3-D: viscosity in a periodic box, the free surface's labels, and pressure that turns a body.

#include <cmath>
#include <numbers>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

void writeTank(RunCase& run, std::string const& more = "")
{
    run.threeDimensions();
    run.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (1 0.8 0.6); open (top); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1 0.5 0.6); } );\n" +
                                             more);
}

/// Angle of a block after a time, turned by the water that stands on one of its sides only.
Real turned(bool inSpace, Real spacing)
{
    RunCase run(spacing);
    std::string const range = inSpace ? "zRange (0 0.2); " : "";
    if (inSpace)
        run.threeDimensions();
    else
        run.write("constant/particleProperties", "spacing " + std::to_string(spacing) + "; thickness 0.2;");
    if (!inSpace)
        run.write("system/mpsSchemes", "sourceSchemes { divergence corrected; density smooth; }"); // nearest to the standard of 3-D
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1 0) (0 0 0) (1.2 0 0) (1.2 1 0)); " + range +
                                             (inSpace ? "sideWalls yes; " : "") +
                                             "} }\nregions ( boxToParticle { box (0 0 0) (0.6 0.4 0.2); } );\n");
    run.write("constant/rigidBodyProperties",
              "bodies { gate { shape { type polygon; points ((0.6 0.02 0) (0.8 0.02 0) (0.8 0.62 0) (0.6 0.62 0)); " + range +
                  "} density 2000; constraints { pin { sixDoFRigidBodyMotionConstraint point; } "
                  "about { sixDoFRigidBodyMotionConstraint axis; axis (0 0 1); } } } }");
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.fixedSteps(0.15, 1e-3).make();
    run.run();
    Vector const side = run.body().orientation() * Vector::UnitX();
    return std::atan2(side.y(), side.x());
}

} // namespace

// Vortices that are the same in every section, from a cloud that is not: on an even lattice the columns of particles at the points where the
// flow parts stay in line until they are 0.6 l0 apart and 1.7 l0 aside, which no weight takes for the same volume, and the energy rises. u = sin(kx) cos(ky), v = -cos(kx) sin(ky), k = 2 pi, energy ~ exp(-4 nu k^2 t).
TEST(SpaceFlow, viscosityAndPeriodicBoxTakeEnergyAsTheExactSolution)
{
    Real const nu = 0.01, k = 2 * std::numbers::pi;
    RunCase run(0.05);
    run.threeDimensions().gravity(Vector::Zero());
    run.write("constant/transportProperties", "nu 0.01; rho 1000;");
    run.write("system/setParticlesDict", "regions ( boxToParticle { box (0 0 0) (1 1 0.4); } );\nlattice { jitter 0.1; }");
    run.write("system/mpsSchemes", "freeSurfaceSchemes { type none; } cyclic { min (0 0 0); max (1 1 0.4); }");
    run.fixedSteps(0.3, 2.5e-3).make([&](ParticleSet& particles) {
        for (int const i : particles.fluid())
        {
            Real const x = k * particles.r[i].x(), y = k * particles.r[i].y();
            particles.u[i] = Vector(std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y), 0);
        }
    });
    run.run();
    Real const exact = 0.25 * 1000 * 0.4 * std::exp(-4 * nu * k * k * 0.3);
    expectBelow("Taylor-Green in 3-D, 20 spacings a wave: energy at 0.3 s, relative error", kineticEnergy(run.scene()) / exact - 1, 0.04);
}

// Thresholds of n, |F| and the cone: what lies two rows deep is never taken for the surface, what is on top nearly always (1.1 % are not).
TEST(SpaceFlow, labelsTheTopRowAndNothingBelowTheSecond)
{
    RunCase run(0.05);
    writeTank(run);
    run.control(0.5, 2e-3).make();
    std::array<int, 2> deep{}, top{}; // particles, those labelled as surface
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time < 0.1) return;
        ParticleSet const& particles = scene.particles();
        for (int const i : particles.fluid())
        {
            bool const surface = particles.surface[i] == SurfaceLabel::Surface;
            Real const depth = 0.5 - particles.r[i].y();
            if (depth > 0.1)
            {
                ++deep[0];
                deep[1] += surface;
            }
            if (depth < 0.03)
            {
                ++top[0];
                top[1] += surface;
            }
        }
    });
    ASSERT_GT(top[0], 1000);
    expectBelow("3-D tank: particles deeper than two rows labelled as surface, share", Real(deep[1]) / deep[0], 1e-5);
    expectBelow("3-D tank: particles of the top row not labelled, share", 1 - Real(top[1]) / top[0], 0.02);
}

// A block that stands on the floor in still water: the water presses it down, nothing lifts it.
TEST(SpaceFlow, aBlockOnTheFloorHasNoLift)
{
    RunCase run(0.05);
    writeTank(run, "hydrostatic { surface 0.5; }");
    run.write("constant/rigidBodyProperties",
              "bodies { block { shape { type box; min (0.4 0 0.2); max (0.6 0.2 0.4); } density 3000; releaseTime 10; } }");
    run.write("constant/contactProperties", "mu 0.5; e 0.2;");
    run.control(0.2, 2e-3).make();
    Series force;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time > 0.1) force.add(scene.bodies()[0]->fluid.force.y());
    });
    expectBelow("block on the floor: force of the water over the load above it, less -1", force.mean() / (1000 * 9.81 * 0.3 * 0.04) + 1,
                0.05);
}

// A gate on a hinge in its middle, water on its left only: one degree of freedom, in 3-D as in 2-D.
TEST(SpaceFlow, pressureOnOneSideTurnsABodyAsIn2D)
{
    Real const flat = turned(false, 0.04), space = turned(true, 0.04);
    expectBetween("hinged gate in 2-D: angle after 0.15 s [rad]", flat, 0.02, 0.5);
    expectBelow("hinged gate: angle in 3-D over that in 2-D, less 1", space / flat - 1, 0.05);
}

} // namespace mpsDem::test
