#include <cmath>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "core/Log.h"
#include "core/OnceLog.h"

#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

/// Still water of depth 1 m with its exact pressure, above a floor.
void fillTank(FunctionObjectScene& scene)
{
    auto points = scene.block(20, 10);
    for (int k = 0; k < 20; ++k) points.push_back({Vector(0.05 + 0.1 * k, -0.05, 0), ParticleType::Wall, Vector::UnitY()});
    scene.place(points);
    for (int i : scene.particles.owned())
    {
        scene.particles.p[i] = 1e4 * (1 - scene.particles.r[i].y());
        scene.particles.n[i] = 1;
        if (scene.particles.isFluid(i)) scene.particles.u[i] = {2, -1, 0};
    }
}

TEST(Probes, KeepConstantFieldsAndSymmetricPressure)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    makeFunctionObject("type probes; probeLocations ((1 0.5 0)); fields (p U n);", context)->write({1, 0.5, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/p.dat").column("p0")[0], 5000, 1e-6);
    EXPECT_NEAR(scene.table("watch/0/U.dat").column("U0x")[0], 2, 1e-9);
    EXPECT_NEAR(scene.table("watch/0/U.dat").column("U0y")[0], -1, 1e-9);
    EXPECT_NEAR(scene.table("watch/0/n.dat").column("n0")[0], 1, 1e-9);
    EXPECT_GE(scene.table("watch/0/count.dat").column("count0")[0], 12);
}

TEST(Probes, HydrostaticCorrectionIsExactOnAWall)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    makeFunctionObject("type probes; probeLocations ((1 0 0)); fields (p); hydrostaticCorrection on;", context)
        ->write({1, 0.5, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/p.dat").column("p0")[0], 1e4, 1e-5);
}

TEST(Probes, WetWallsCountForPressureOnlyAndDryOnesNotAtAll)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type probes; probeLocations ((1 -0.1 0)); fields (p);", context);
    object->write({1, 0.5, 0.1, false});
    for (int i : scene.particles.wall()) scene.particles.wet[i] = 0;
    object->write({2, 0.6, 0.1, false});
    Table const count = scene.table("watch/0/count.dat");
    EXPECT_GT(count.column("count0")[0], count.column("count0")[1]);
    EXPECT_GT(scene.table("watch/0/p.dat").column("p0")[0], scene.table("watch/0/p.dat").column("p0")[1]);
}

TEST(Probes, AreNoNumberWhereThereIsNothing)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    makeFunctionObject("type probes; probeLocations ((1 3 0)); fields (p U);", context)->write({1, 0.5, 0.1, false});
    EXPECT_TRUE(std::isnan(scene.table("watch/0/p.dat").column("p0")[0]));
    EXPECT_TRUE(std::isnan(scene.table("watch/0/U.dat").column("U0x")[0]));
    EXPECT_EQ(scene.table("watch/0/count.dat").column("count0")[0], 0);
    EXPECT_THROW(makeFunctionObject("type probes; probeLocations ((1 3 0)); fields (q);", context), CaseError);
}

TEST(Probes, ZDoesNotCountInAPlaneAndIsToldSo)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    for (std::string const entries : {"type probes; probeLocations ((1 0.5 0.4));", "type interfaceHeight; locations ((1 0 0.4));"})
    {
        forgetShown();
        testing::internal::CaptureStdout();
        makeFunctionObject(entries, context)->write({1, 0.5, 0.1, false});
        std::string const log = testing::internal::GetCapturedStdout();
        EXPECT_NE(log.find("ocations does not count in a case of two dimensions"), std::string::npos) << log;
    }
    EXPECT_GT(scene.table("watch/0/count.dat").column("count0")[0], 0);
    EXPECT_FALSE(std::isnan(scene.table("watch/0/height.dat").column("eta0")[0]));
    EXPECT_THROW(makeFunctionObject("type probes; probeLocations ((1 1e400 0));", context), CaseError);
}

TEST(Probes, OutsideOfWallsAndFluidAreWarnedOf)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene); // x from 0.05 to 1.95 m, y from -0.05 to 0.95 m
    RunContext const context = scene.context();
    auto const warnings = [&](std::string const& entries) {
        int const before = warningCount();
        makeFunctionObject(entries, context);
        return warningCount() - before;
    };
    EXPECT_EQ(warnings("type probes; probeLocations ((1 0.5 0) (0.1 0.94 0));"), 0);
    EXPECT_EQ(warnings("type probes; probeLocations ((1 0.5 0) (1 3 0));"), 1);
    EXPECT_EQ(warnings("type interfaceHeight; locations ((1 99 0));"), 0) << "heights do not count";
    EXPECT_EQ(warnings("type interfaceHeight; locations ((1 0 0) (7 0 0));"), 1);
    EXPECT_EQ(warnings("type freeSurfaceProfile; from 0.1; to 1.9;"), 0);
    EXPECT_EQ(warnings("type freeSurfaceProfile; from -3; to 1.9;"), 1);
}

TEST(Probes, HeadsTellZerosWithoutSign)
{
    FunctionObjectScene scene({2, 0.1, 1});
    fillTank(scene);
    RunContext const context = scene.context();
    makeFunctionObject("type interfaceHeight; locations ((1 -0.0 0));", context)->write({1, 0.5, 0.1, false});
    std::ifstream in(scene.folder / "postProcessing/watch/0/height.dat");
    std::string const head((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    EXPECT_NE(head.find("along (0 1 0) [m]"), std::string::npos) << head;
    EXPECT_EQ(head.find("-0 "), std::string::npos) << head;
}

} // namespace
} // namespace mpsDem
