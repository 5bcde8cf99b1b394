// Weak coupling lets this step's pressure move the body afterwards: it is stable only where the added mass is less than the mass.

#include <string>

#include "core/Errors.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

/// A body amid a tank of 3.2 m by 2.4 m, free to move.
void writeTank(RunCase& run, std::string const& shape, std::string const& density, std::string const& coupling)
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 2.8 0) (0 0 0) (3.2 0 0) (3.2 2.8 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (3.2 2.4 0); } );\nhydrostatic { surface 2.4; }");
    run.write("constant/rigidBodyProperties", "bodies { float { shape { type box; " + shape + " } density " + density + "; } }");
    run.write("system/mpsSolution", "coupling\n{\n    type " + coupling + ";\n}");
}

std::string const square = "min (1.4 1 0); max (1.8 1.4 0);";
std::string const plate = "min (1.2 1.1 0); max (2 1.4 0);"; // m_a of a flat plate: pi/4 w^2 rho, 2.1 of the water displaced

FluidBodyCoupling const& coupling(RunCase const& run) { return run.scene().solids()->couplings().front(); }

/// A wedge of 0.5 m that slides down a ramp under water for 0.5 s.
Real jumpOfTheWedge(std::string const& type)
{
    RunCase run(0.04);
    run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (4 0 0) (4 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (4 1 0); } );\nhydrostatic { surface 1; }");
    run.write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); } density 2036; } }");
    run.write("constant/contactProperties", "mu 0.0104724;");
    run.write("system/mpsSolution", "coupling { type " + type + "; }");
    run.control(0.5, 1e-3).make();
    Jump jump;
    Series force;
    run.run([&](Scene const& scene, Step const&) {
        jump.add(scene.bodies()[0]->fluid.force);
        force.add(scene.bodies()[0]->fluid.force.norm());
    });
    return jump.value() / force.mean();
}

} // namespace

TEST(WeakCoupling, isRefusedForALightBox)
{
    RunCase run(0.025);
    writeTank(run, square, "500", "weak");
    run.control(1, 1e-3).make();
    run.start();
    try
    {
        run.step();
        FAIL() << "nothing was refused";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        EXPECT_EQ(error.where().line, 4) << "of type in system/mpsSolution";
        std::string const text = error.what();
        for (char const* piece : {"system/mpsSolution:4", "\"float\"", "of its mass", "strong or auto", "0.8"})
            EXPECT_NE(text.find(piece), std::string::npos) << piece << " is not in\n" << text;
    }
    // A square of side a in open water: m_a = 1.19 rho a^2.
    expectBetween("light box, 16 spacings: added mass over 2.38 m", coupling(run).addedMassRatio() / 2.38, 0.8, 1.2);
}

TEST(WeakCoupling, isAllowedForAHeavyBox)
{
    RunCase run(0.05);
    writeTank(run, square, "7800", "weak");
    run.fixedSteps(0.05, 1e-3).make();
    run.run();
    expectBetween("steel box, 8 spacings: added mass over 0.153 m", coupling(run).addedMassRatio() / (1.19 / 7.8), 0.7, 1.3);
    EXPECT_EQ(coupling(run).mode(), FluidBodyCoupling::Mode::Weak);
}

// Heavy enough for `weakAbove`, and yet with more added mass than mass.
TEST(WeakCoupling, becomesStrongForAHeavyPlateWhereTheTypeIsAuto)
{
    RunCase run(0.05);
    writeTank(run, plate, "2500", "auto");
    run.fixedSteps(0.05, 1e-3, "#inputMode merge\nwriteControl runTime; writeInterval 0.05;").make();
    EXPECT_STREQ(run.start().solids()->couplings().front().modeName(), "weak");
    Jump jump;
    run.run([&](Scene const& scene, Step const& step) {
        if (step.time > 0.01) jump.add(scene.bodies()[0]->fluid.force);
    });
    EXPECT_STREQ(coupling(run).modeName(), "strong");
    expectBelow("plate, auto: step jump of the force over its weight", jump.value() / (run.body().mass() * 9.81), 0.05);
    expectBetween("plate, 6 spacings thick: added mass over 0.84 m", coupling(run).addedMassRatio() / (2.1 / 2.5), 0.7, 1.3);
    Scene const restarted(CaseFolder(run.root()), Scene::Options{});
    EXPECT_STREQ(restarted.solids()->couplings().front().modeName(), "strong") << "after a restart";
}

TEST(WeakCoupling, isAsQuietAsStrongForTheWedge)
{
    Real const weak = jumpOfTheWedge("weak"), strong = jumpOfTheWedge("strong");
    expectBelow("wedge, spacing 0.04, weak: jump of the force over its mean", weak, 0.12);
    expectBelow("wedge, spacing 0.04: jump when weak over that when strong", weak / strong, 1.5);
}

} // namespace mpsDem::test
