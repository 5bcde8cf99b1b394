#include <cmath>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

TEST(InterfaceHeight, WritesElevationAboveItsZero)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type interfaceHeight; locations ((1 0 0) (1.5 7 0) (9 0 0)); zero 0.8;", context);
    object->write({5, 0.5, 0.1, false});
    Table const table = scene.table("watch/0/height.dat");
    EXPECT_EQ(table.names, (std::vector<std::string>{"Time", "eta0", "eta1", "eta2"}));
    EXPECT_EQ(table.column("Time")[0], 0.5);
    EXPECT_NEAR(table.column("eta0")[0], 0.2, 1e-9);
    EXPECT_NEAR(table.column("eta1")[0], 0.2, 1e-9);
    EXPECT_TRUE(std::isnan(table.column("eta2")[0]));
}

TEST(InterfaceHeight, NeedsFluidLocationsAndADirection)
{
    FunctionObjectScene dry({2, 0.1, 1});
    RunContext const dryContext = dry.context();
    EXPECT_THROW(makeFunctionObject("type interfaceHeight; locations ((1 0 0));", dryContext), CaseError);
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    EXPECT_THROW(makeFunctionObject("type interfaceHeight; locations ();", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type interfaceHeight; locations ((1 0 0)); direction (0 0 1);", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type interfaceHeight; locations ((1 0 0)); liqid water;", context), CaseError);
}

} // namespace
} // namespace mpsDem
