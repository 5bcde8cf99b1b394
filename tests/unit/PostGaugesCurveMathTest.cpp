#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "postGauges/CurveMath.h"

namespace mpsDem::postGauges {

namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

Points sampled(Real from, Real to, int count, Real (*f)(Real))
{
    Points points;
    for (int i = 0; i <= count; ++i)
    {
        points.x.push_back(from + (to - from) * i / count);
        points.y.push_back(f(points.x.back()));
    }
    return points;
}

} // namespace

TEST(PostGaugesCurveMath, interpolatesBetweenPoints)
{
    Points const line{{0, 1, 3}, {0, 2, 6}};
    EXPECT_DOUBLE_EQ(interpolate(line, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(interpolate(line, 2.0), 4.0);
    EXPECT_DOUBLE_EQ(interpolate(line, 3.0), 6.0);
    EXPECT_DOUBLE_EQ(interpolate({{1, 1, 2}, {0, 5, 6}}, 1.5), 5.5) << "a step in x = 1";
}

TEST(PostGaugesCurveMath, constantOffsetIsTheDifference)
{
    Points const reference = sampled(0, 2, 40, [](Real x) { return std::sin(x); });
    Points curve = reference;
    for (Real& y : curve.y) y += 0.25;
    auto const difference = compareCurves(curve, reference, 0, 2).value();
    EXPECT_NEAR(difference.rms, 0.25, 1e-14);
    EXPECT_NEAR(difference.maximum, 0.25, 1e-14);
    EXPECT_EQ(difference.points, 41U);
    EXPECT_NEAR(difference.referenceRange, 1.0, 1e-3);
}

TEST(PostGaugesCurveMath, comparesOnlyWhereBothHavePoints)
{
    Points const reference{{0, 1, 2, 3, 4}, {0, 0, 0, 0, nan}};
    Points const curve{{0.5, 2.5}, {1, 3}};
    auto const difference = compareCurves(curve, reference, -10, 10).value();
    EXPECT_EQ(difference.points, 2U); // x = 1 and 2
    EXPECT_DOUBLE_EQ(difference.maximum, 2.5);
    EXPECT_DOUBLE_EQ(difference.at, 2.0);
    EXPECT_DOUBLE_EQ(difference.rms, std::sqrt((1.5 * 1.5 + 2.5 * 2.5) / 2));
    EXPECT_FALSE(compareCurves(curve, reference, 3, 10).has_value());
    EXPECT_FALSE(compareCurves({{nan}, {1}}, reference, -10, 10).has_value()) << "a signal of NaN is no agreement";
}

TEST(PostGaugesCurveMath, firstCrestOfAWave)
{
    Points const wave = sampled(0, 3, 60, [](Real x) { return 0.1 * std::sin(2 * std::numbers::pi * (x - 0.013)); });
    auto const crest = firstCrest(wave, 0.02).value();
    EXPECT_NEAR(crest.x, 0.263, 2e-4); // parabola through points 0.05 apart: error of third order
    EXPECT_NEAR(crest.y, 0.1, 1e-4);
}

TEST(PostGaugesCurveMath, noiseIsNoCrest)
{
    Points const noisy = sampled(0, 1.2, 2400, [](Real x) { return std::exp(-50 * (x - 0.6) * (x - 0.6)) + 0.01 * std::sin(1000 * x); });
    auto const crest = firstCrest(noisy, 0.1).value();
    EXPECT_NEAR(crest.x, 0.6, 0.02);
    EXPECT_NEAR(crest.y, 1.0, 0.011);
    EXPECT_FALSE(firstCrest(sampled(0, 1, 10, [](Real x) { return x; }), 0.1).has_value()) << "still rising";
    EXPECT_FALSE(firstCrest({}, 0.1).has_value());
}

TEST(PostGaugesCurveMath, finiteAndIncreasing)
{
    Points const mixed{{0, nan, 2, 3}, {1, 1, nan, 4}};
    EXPECT_EQ(finitePoints(mixed).x, (std::vector<Real>{0, 3}));
    EXPECT_TRUE(increases({{0, 1, 1, 2}, {0, 0, 0, 0}}));
    EXPECT_FALSE(increases({{0, 2, 1}, {0, 0, 0}}));
}

} // namespace mpsDem::postGauges
