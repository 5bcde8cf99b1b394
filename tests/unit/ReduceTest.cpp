// Reductions: on one rank the numbers of a plain loop, and a NaN is never lost.

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
constexpr std::array<int, 4> indices{0, 1, 2, 3};

} // namespace

TEST(Reduce, oneRankKeepsTheNumbersAsTheyAre)
{
    EXPECT_EQ(Communicator::ranks(), 1);
    EXPECT_TRUE(Communicator::isMaster());
    EXPECT_EQ(sumOverRanks(0.1), 0.1);
    EXPECT_EQ(sumOverRanks(7), 7);
    EXPECT_EQ(sumOverRanks(Vector(1, 2, 3)), Vector(1, 2, 3));
    EXPECT_FALSE(anyOverRanks(false));
    EXPECT_TRUE(anyOverRanks(true));
}

TEST(Reduce, sumsInTheOrderOfTheIndices)
{
    std::array<Real, 4> const value{1e16, 1, -1e16, 1}; // another order gives 2
    EXPECT_EQ(sumOver(indices, Real(0), [&](int i) { return value[static_cast<std::size_t>(i)]; }), 1);
    EXPECT_EQ(countOver(indices, [](int i) { return i > 1; }), 2);
}

TEST(Reduce, extremesTellOfNumbersThatAreNotFinite)
{
    for (std::size_t bad = 0; bad < 4; ++bad)
    {
        std::array<Real, 4> value{3, 1, 4, 2};
        value[bad] = nan;
        auto const of = [&](int i) { return value[static_cast<std::size_t>(i)]; };
        Extremum const most = maxOver(indices, 0, of), least = minOver(indices, 10, of);
        EXPECT_FALSE(most.finite) << bad;
        EXPECT_FALSE(least.finite) << bad;
        EXPECT_EQ(most.value, bad == 2 ? 3 : 4);
        EXPECT_EQ(least.value, bad == 1 ? 2 : 1);
    }
    Extremum const none = maxOver(std::array<int, 0>{}, 5, [](int) { return nan; });
    EXPECT_TRUE(none.finite);
    EXPECT_EQ(none.value, 5);
}

TEST(Reduce, equalPlacesAreDecidedByTheId)
{
    Place const a{2, 8, Vector(1, 0, 0)}, b{2, 5, Vector(2, 0, 0)}, worse{1, 1, Vector(3, 0, 0)}, none, bad{nan, 0, Vector(4, 0, 0)};
    EXPECT_EQ(largerOf(a, b).id, 5);
    EXPECT_EQ(largerOf(b, a).id, 5);
    EXPECT_EQ(largerOf(a, worse).id, 8);
    EXPECT_EQ(largerOf(none, worse).id, 1);
    EXPECT_EQ(largerOf(worse, none).id, 1);
    EXPECT_EQ(largerOf(a, bad).id, 8);
    EXPECT_EQ(maxOverRanks(a).position, a.position);
    EXPECT_EQ(maxOverRanks(none).id, -1);
}

TEST(Reduce, quantileIsAnElement)
{
    std::vector<Real> values{5, 1, 4, 2, 3};
    EXPECT_EQ(quantileOverRanks(values, 0.95), 4); // element 3.8 -> 3 of 0..4
    EXPECT_EQ(quantileOverRanks(values, 1), 5);
    values.clear();
    EXPECT_EQ(quantileOverRanks(values, 0.5), 0);
}

} // namespace mpsDem
