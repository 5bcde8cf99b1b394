// Pressure integrated over bodies in still water (eqs 15-16) against Archimedes, and the coupling of bodies lighter than water.

#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

constexpr Real side = 0.24;
constexpr Real archimedes = 1000 * 9.81 * side * side; ///< [N/m]

/// A square box in the middle of a tank 1.2 m wide with 0.6 m of water.
RunCase& boxInTank(RunCase& run, std::string const& motion)
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (1.2 0 0) (1.2 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.2 0.6 0); } );\n");
    return run.write("constant/rigidBodyProperties",
                     "bodies { box { shape { type box; min (0.48 0.18 0); max (0.72 0.42 0); } " + motion + " } }");
}

/// Mean lift of the held box over the second half of 0.5 s.
Real lift(Real spacing)
{
    RunCase run(spacing);
    boxInTank(run, "density 1000; releaseTime 1000;").fixedSteps(0.5, 1e-3).make();
    Series force;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time > 0.25) force.add(scene.bodies()[0]->fluid.force.y());
    });
    return force.mean();
}

struct Rise
{
    Real jump = 0, height = 0;
};

/// The box let go: root mean square of the step-to-step change of its force over rho g V, and how far it has risen.
Rise rise(Real density)
{
    RunCase run(0.03);
    boxInTank(run, "density " + std::to_string(density) + ";").fixedSteps(0.5, 1e-3);
    run.write("system/mpsSolution", "coupling { type strong; }").make();
    Jump jump;
    run.run([&](Scene const& scene, Step const&) { jump.add(scene.bodies()[0]->fluid.force); });
    return {jump.value() / archimedes, run.body().centre().y() - 0.3};
}

} // namespace

TEST(Buoyancy, liftsAFixedBox) { expectBelow("fixed box, 8 spacings wide: lift, relative error", lift(0.03) / archimedes - 1, 0.015); }

TEST(Buoyancy, convergesForAFixedBox)
{
    expectBelow("fixed box, 4 spacings wide: lift, relative error", lift(0.06) / archimedes - 1, 0.03);
    expectBelow("fixed box, 16 spacings wide: lift, relative error", lift(0.015) / archimedes - 1, 0.015);
}

TEST(Buoyancy, lightBoxesRiseQuietlyWithStrongCoupling)
{
    for (Real const density : {100.0, 200.0, 500.0})
    {
        Rise const box = rise(density);
        std::string const name = "box of " + std::to_string(static_cast<int>(density)) + " kg/m3";
        expectBelow(name + ": step jump of the force / rho g V", box.jump, 0.1);
        expectBetween(name + ": rise after 0.5 s [m]", box.height, 0.2, 0.5);
    }
}

} // namespace mpsDem::test
