// Weak coupling lets this step's pressure move the body afterwards: it is stable only where the added mass is less than the mass.

#include <algorithm>
#include <string>

#include "core/Errors.h"
#include "core/Log.h"
#include "support/CheckpointSample.h"
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

/// A plate of 0.6 m by 0.3 m, 0.05 m above 0.8 m of water, that comes down at 2 m/s.
void writeFall(RunCase& run, std::string const& density, std::string const& coupling)
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.6 0) (0 0 0) (1.6 0 0) (1.6 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (1.6 0.8 0); } );\nhydrostatic { surface 0.8; }");
    run.write("constant/rigidBodyProperties",
              "bodies { float { shape { type box; min (0.5 0.85 0); max (1.1 1.15 0); } velocity (0 -2 0); density " + density + "; } }");
    run.write("system/mpsSolution", "coupling { type " + coupling + "; }");
}

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

// The added mass alone decides: this plate is heavier than water by far, the steel box still more so.
TEST(WeakCoupling, becomesStrongForAHeavyPlateWhereTheTypeIsAuto)
{
    RunCase run(0.05);
    writeTank(run, plate, "2500", "auto");
    run.fixedSteps(0.05, 1e-3, "#inputMode merge\nwriteControl runTime; writeInterval 0.05;").make();
    EXPECT_STREQ(run.start().solids()->couplings().front().modeName(), "auto: by the added mass, not known yet");
    Jump jump;
    run.run([&](Scene const& scene, Step const& step) {
        EXPECT_EQ(coupling(run).mode(), FluidBodyCoupling::Mode::Strong) << "from the first step on";
        if (step.time > 0.01) jump.add(scene.bodies()[0]->fluid.force);
    });
    EXPECT_STREQ(coupling(run).modeName(), "strong");
    expectBelow("plate, auto: step jump of the force over its weight", jump.value() / (run.body().mass() * 9.81), 0.05);
    expectBetween("plate, 6 spacings thick: added mass over 0.84 m", coupling(run).addedMassRatio() / (2.1 / 2.5), 0.7, 1.3);
    Scene const restarted(CaseFolder(run.root()), Scene::Options{});
    EXPECT_STREQ(restarted.solids()->couplings().front().modeName(), "strong") << "after a restart";
}

TEST(WeakCoupling, staysWeakForAHeavyBoxWhereTheTypeIsAuto)
{
    RunCase run(0.05);
    writeTank(run, square, "7800", "auto");
    run.fixedSteps(0.005, 1e-3).make();
    run.run();
    EXPECT_STREQ(coupling(run).modeName(), "weak");
}

TEST(WeakCoupling, becomesStrongInMidRunAndRestartsBitByBit)
{
    std::string const written = "#inputMode merge\nwriteControl runTime; writeInterval 0.05;";
    RunCase unbroken(0.05);
    writeFall(unbroken, "2000", "auto");
    unbroken.fixedSteps(0.3, 1e-3, written).make();
    Real switched = 0;
    unbroken.run([&](Scene const&, Step const& step) {
        if (switched == 0 && coupling(unbroken).mode() == FluidBodyCoupling::Mode::Strong) switched = step.time;
    });
    expectBetween("plate that falls into water, auto: time of the switch [s]", switched, 0.101, 0.199);
    for (Real const half : {0.05, 0.1, 0.2}) // before and after
    {
        RunCase broken(0.05);
        writeFall(broken, "2000", "auto");
        broken.fixedSteps(half, 1e-3, written).make();
        broken.run();
        RunCase continued(0.05);
        continued.copyFrom(broken).fixedSteps(0.3, 1e-3, written);
        continued.run();
        EXPECT_TRUE(sameBits(continued.scene().state(), unbroken.scene().state())) << "restart at " << half;
    }
}

// The input was fine when the run began: it is not refused half an hour later.
TEST(WeakCoupling, isWarnedOfOnceInMidRun)
{
    RunCase run(0.05);
    writeFall(run, "1500", "weak");
    run.fixedSteps(0.3, 1e-3).make();
    muteLog(false);
    testing::internal::CaptureStdout();
    Real largest = 0;
    run.run([&](Scene const&, Step const&) { largest = std::max(largest, coupling(run).addedMassRatio()); });
    std::string const log = testing::internal::GetCapturedStdout();
    muteLog(true);
    expectBetween("plate that falls into water, weak: largest added mass over its mass", largest, 0.8, 2);
    int above = 0;
    for (std::size_t at = 0; (at = log.find("weak coupling is unstable", at)) != std::string::npos; ++at) ++above;
    expectBetween("warnings of one body: above 0.5, above 0.8", above, 2, 2);
    for (char const* piece : {"\"float\"", "of its mass (time 0.", "strong or auto"})
        EXPECT_NE(log.find(piece), std::string::npos) << piece << " is not in\n" << log;
}

// Pressure does not act through a solid: the two sides of a plate answer apart, however thin it is.
TEST(WeakCoupling, thinPlatesHaveTheirAddedMass)
{
    struct Plate
    {
        char const* name;
        char const* shape;
        Real exact; ///< m_a/m of a plate of 0.8 m at the density of water: pi/4 w/t C, C(t/w) from 1.14 to 1.36 (DNV-RP-C205).
    };
    for (Plate const& thin : {Plate{"2", "min (1.2 1.1 0); max (2 1.2 0);", 7.27}, Plate{"3", "min (1.2 1.1 0); max (2 1.25 0);", 5.03},
                              Plate{"6", "min (1.2 1.1 0); max (2 1.4 0);", 2.72}})
    {
        RunCase run(0.05);
        writeTank(run, thin.shape, "1000", "strong");
        run.control(1, 1e-3).make();
        run.start();
        run.step();
        expectBetween(std::string("plate, ") + thin.name + " spacings thick: added mass over exact",
                      coupling(run).addedMassRatio() / thin.exact, 0.75, 1.1);
    }
}

TEST(WeakCoupling, isAsQuietAsStrongForTheWedge)
{
    Real const weak = jumpOfTheWedge("weak"), strong = jumpOfTheWedge("strong");
    expectBelow("wedge, spacing 0.04, weak: jump of the force over its mean", weak, 0.12);
    expectBelow("wedge, spacing 0.04: jump when weak over that when strong", weak / strong, 1.5);
}

} // namespace mpsDem::test
