// A thin body that is quick: half an ellipse 0.5 m long and 0.0247 m high (two spacings) on the floor of a tank, 0.3 m of water, moved to
// 1.2 m/s in 0.8 s. Water that parts from its upper side leaves empty space there, and the whole tank rises: of the potential energy it
// had, a wave takes a joule or two; 0.57 of the body's volume in empty space are 15 J.

#include <cmath>
#include <numbers>
#include <string>

#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

struct Rise
{
    Real potential; ///< Potential energy at 1.2 s over that at 0 [J].
    Real kinetic;   ///< Kinetic energy at 1.2 s [J].
};

Rise moveThinBody(std::string const& schemes)
{
    std::string points, places;
    for (int k = 0; k <= 20; ++k)
    {
        Real const angle = std::numbers::pi * k / 20;
        points += "(" + std::to_string(0.5 + 0.25 * std::cos(angle)) + " " + std::to_string(0.0247 * std::sin(angle)) + " 0) ";
    }
    for (int k = 0; k <= 8; ++k)
    {
        Real const t = 0.2 * k;
        places += "(" + std::to_string(t < 0.8 ? 0.75 * t * t : 0.48 + 1.2 * (t - 0.8)) + " 0 0) ";
    }
    RunCase run(0.0125);
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.5 0) (0 0 0) (3 0 0) (3 0.5 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (3 0.3 0); } );\nlattice { cutCells fill; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ( " + points + "); } density 4000; prescribedMotion { " +
                  "solidBodyMotionFunction tabulated6DoFMotion; times (0 0.2 0.4 0.6 0.8 1.0 1.2 1.4 1.6); translations ( " + places +
                  "); } } }");
    run.write("system/mpsSchemes", schemes);
    run.control(1.2, 2e-3).make();
    Real before = 0;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.number == 1) before = potentialEnergy(scene);
    });
    return {potentialEnergy(run.scene()) - before, kineticEnergy(run.scene())};
}

} // namespace

TEST(ThinSlideGate, waterStaysOnAQuickThinBody)
{
    Rise const rise = moveThinBody("sourceSchemes { divergence corrected; density smooth; relaxationTime 0.02; }\n"
                                   "velocityDamping { type deviation; }\ncollisionSchemes { walls normal; }");
    expectBetween("thin body at 1.2 m/s: rise of the potential energy [J]", rise.potential, -2, 2);
    expectBelow("thin body at 1.2 m/s: kinetic energy [J]", rise.kinetic, 2.5);
}

} // namespace mpsDem::test
