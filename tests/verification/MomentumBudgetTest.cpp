// Momentum of water and bodies changes by the impulses from outside alone: gravity, pressure of the walls, contact.

#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

std::string const budget = "functions { momentum { type momentumBudget; writeControl none; } }";

/// Largest residual in 1 s over the weight of the water times 1 s.
Real residual(RunCase& run)
{
    Vector const start = momentumBalance(run.start());
    Real const weight =
        run.particles().fluid().size() * run.scene().fluid()->fluid().density() * run.particles().lattice().particleVolume() * 9.81;
    Real largest = 0;
    run.run([&](Scene const& scene, Step const&) { largest = std::max(largest, (momentumBalance(scene) - start).norm()); });
    return largest / weight;
}

} // namespace

TEST(MomentumBudget, closesForWaterAtRest)
{
    RunCase run(0.04);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.6 0) (0 0 0) (1.2 0 0) (1.2 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.2 1 0); } );\n");
    run.fixedSteps(1, 2e-3, budget).make();
    expectBelow("still tank: momentum residual over weight x 1 s", residual(run), 0.02);
}

TEST(MomentumBudget, closesForASlidingWedge)
{
    RunCase run(0.04);
    run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (2.2 0 0) (2.2 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (2.2 1 0); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); }\n"
              "density 2036; } }");
    run.write("constant/contactProperties", "mu 0.0105;");
    run.write("system/mpsSolution", "coupling { type strong; }");
    run.control(0.9, 1e-3, budget).make();
    expectBelow("sliding wedge: momentum residual over weight x 1 s", residual(run), 0.02);
}

} // namespace mpsDem::test
