#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"
#include "support/Measured.h"

namespace mpsDem {
namespace {

using test::expectBelow;

constexpr Real l0 = 0.1, height = 2, amplitude = 0.2, length = 4, speed = 2;

/// A wave that runs along x over still water behind its front at x = speed t.
Real wave(Real x, Real t)
{
    Real const behind = speed * t - x;
    return behind < 0 ? height : height + amplitude * std::sin(2 * std::numbers::pi * behind / length);
}

void placeWave(FunctionObjectScene& scene, Real t)
{
    scene.place(scene.columns(40, 12, 8, [t](Real x, Real) { return wave(x, t); }));
}

TEST(ElevationMap, RecordsTheCrestAndTheArrivalOfARunningWave)
{
    FunctionObjectScene scene({3, l0, 1});
    placeWave(scene, 0);
    RunContext const context = scene.context();
    auto const map =
        makeFunctionObject("type elevationMap; from (0.2 0 0.3); to (3.8 0 0.9); spacing 0.3; zero 2; threshold 0.1;", context);
    constexpr Real dt = 0.02;
    for (int m = 1; m <= 200; ++m)
    {
        placeWave(scene, m * dt);
        map->execute({m, m * dt, dt, false});
    }
    map->write({200, 4, dt, false});
    Table const table = scene.table("watch/0/map_4.dat");
    auto const x = table.column("x"), z = table.column("z"), most = table.column("etaMax"), arrival = table.column("arrival");
    auto const timeOfMost = table.column("timeOfMax");
    ASSERT_EQ(x.size(), 13U * 3U);
    EXPECT_NEAR(x[1] - x[0], 0.3, 1e-9);
    EXPECT_NEAR(z.back(), 0.9, 1e-9);
    Real mostOff = 0, arrivalOff = 0, crestOff = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        mostOff = std::max(mostOff, std::abs(most[i] - amplitude));
        arrivalOff = std::max(arrivalOff, std::abs(arrival[i] - (x[i] + length / 12) / speed)); // sin(30 degrees) is the threshold
        crestOff = std::max(crestOff, std::abs(timeOfMost[i] - (x[i] + length / 4) / speed));
    }
    expectBelow("elevation map: largest elevation [spacings]", mostOff / l0, 0.02);
    expectBelow("elevation map: arrival [time steps]", arrivalOff / dt, 2);
    // The crest is flat: within 0.02 spacings of it for 0.09 s.
    expectBelow("elevation map: time of the crest [s]", crestOff, 0.09);
}

TEST(ElevationMap, GoesOnAfterARestart)
{
    FunctionObjectScene scene({3, l0, 1});
    placeWave(scene, 1.5);
    RunContext const context = scene.context();
    std::string const text = "type elevationMap; from (0.5 0 0.5); to (3.5 0 0.5); spacing 0.5; zero 2; threshold 0.05;";
    auto const before = makeFunctionObject(text, context);
    before->execute({1, 1.5, 0.1, false});
    State state;
    before->save(state);
    auto const after = makeFunctionObject(text, context), anew = makeFunctionObject(text, context);
    after->load(state);
    anew->load(State());
    placeWave(scene, 0);
    for (auto const* object : {&after, &anew}) (*object)->write({2, object == &after ? 2.0 : 3.0, 0.1, false});
    Table const kept = scene.table("watch/0/map_2.dat"), fresh = scene.table("watch/0/map_3.dat");
    ASSERT_EQ(kept.column("x").size(), 7U) << "one row where the corners have one z";
    EXPECT_NEAR(kept.column("etaMax")[3], wave(2, 1.5) - height, 0.02 * l0);
    EXPECT_EQ(kept.column("arrival")[3], 1.5);
    EXPECT_TRUE(std::isnan(kept.column("arrival")[6])) << "the front is at 3 m";
    EXPECT_NEAR(fresh.column("etaMax")[3], 0, 1e-9);
    EXPECT_TRUE(std::isnan(fresh.column("arrival")[3]));
    auto const other = makeFunctionObject("type elevationMap; from (0 0 0.5); to (1 0 0.5); spacing 0.5;", context);
    other->load(state); // another grid: a warning, and the map begins anew
    other->write({3, 4, 0.1, false});
    EXPECT_NEAR(scene.table("watch/0/map_4.dat").column("etaMax")[2], height, 1e-9);
}

TEST(ElevationMap, KnowsDryPlacesAndRefusesNonsense)
{
    FunctionObjectScene scene({3, l0, 1});
    placeWave(scene, 0);
    RunContext const context = scene.context();
    makeFunctionObject("type elevationMap; from (3 0 0.5); to (5 0 0.5); spacing 1;", context)->write({1, 1, 0.1, false});
    Table const table = scene.table("watch/0/map_1.dat");
    EXPECT_NEAR(table.column("eta")[0], height, 1e-9);
    EXPECT_TRUE(std::isnan(table.column("eta")[2]) && std::isnan(table.column("etaMax")[2]));
    EXPECT_THROW(makeFunctionObject("type elevationMap; from (0 0 0);", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type elevationMap; from (0 0 0); to (0 0 0);", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type elevationMap; from (0 0 0); to (1e4 0 1e4);", context), CaseError);
}

} // namespace
} // namespace mpsDem
