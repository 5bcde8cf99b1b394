#include <cmath>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

TEST(FreeSurfaceProfile, AsksForItsTimesAndWritesThemOnce)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    auto const object = makeFunctionObject("type freeSurfaceProfile; times (0.5 0.25); from 0.2; to 1.8; count 5;", context);
    EXPECT_EQ(object->wantedTime(0), 0.25);
    EXPECT_EQ(object->wantedTime(0.25), 0.5);
    EXPECT_TRUE(std::isinf(object->wantedTime(0.5)));
    object->execute({1, 0.1, 0.1, false});
    object->execute({2, 0.25, 0.15, false});
    object->execute({3, 0.3, 0.05, false});
    object->write({3, 0.3, 0.05, true});
    EXPECT_FALSE(std::filesystem::exists(scene.folder / "postProcessing/watch/0/profile_0.1.dat"));
    EXPECT_FALSE(std::filesystem::exists(scene.folder / "postProcessing/watch/0/profile_0.3.dat"));
    Table const table = scene.table("watch/0/profile_0.25.dat");
    EXPECT_EQ(table.names, (std::vector<std::string>{"x", "eta"}));
    ASSERT_EQ(table.rows(), 5u);
    EXPECT_NEAR(table.column("x")[1], 0.6, 1e-12);
    for (Real const eta : table.column("eta")) EXPECT_NEAR(eta, 1, 1e-9);
}

TEST(FreeSurfaceProfile, CoversTheWholeFluidByDefault)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    makeFunctionObject("type freeSurfaceProfile;", context)->write({1, 2, 0.1, true});
    Table const table = scene.table("watch/0/profile_2.dat");
    ASSERT_EQ(table.rows(), 20u);
    EXPECT_NEAR(table.column("x").front(), 0.05, 1e-12);
    EXPECT_NEAR(table.column("x").back(), 1.95, 1e-12);
}

TEST(FreeSurfaceProfile, RefusesImpossibleLines)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    EXPECT_THROW(makeFunctionObject("type freeSurfaceProfile; times (0);", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type freeSurfaceProfile; from 1; to 1;", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type freeSurfaceProfile; count 5; spacing 0.1;", context), CaseError);
}

} // namespace
} // namespace mpsDem
