#include <gtest/gtest.h>

#include "postGauges/TimeSelection.h"

namespace mpsDem::postGauges {

namespace {

std::vector<Real> const times = {0, 0.1, 0.2, 0.30001, 0.4, 1.0};

std::string messageOf(std::string const& ranges)
{
    try
    {
        (void)timesInRanges(times, ranges);
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        return error.what();
    }
    return {};
}

} // namespace

TEST(PostGaugesTimeSelection, nearestWrittenTime)
{
    EXPECT_EQ(nearestTime(times, 0.3, {}), 3U);
    EXPECT_EQ(nearestTime(times, 0.14, {}), 1U);
    EXPECT_EQ(nearestTime(times, 0.9, {}), 5U);
    EXPECT_THROW((void)nearestTime(times, 1.5, {}), CaseError);
    EXPECT_THROW((void)nearestTime({}, 0, {}), CaseError);
}

TEST(PostGaugesTimeSelection, rangesOfOpenFoam)
{
    using Indices = std::vector<std::size_t>;
    EXPECT_EQ(timesInRanges(times, "0.1:0.2"), (Indices{1, 2}));
    EXPECT_EQ(timesInRanges(times, ":0.1,0.4:"), (Indices{0, 1, 4, 5}));
    EXPECT_EQ(timesInRanges(times, "0.4, 0.3"), (Indices{3, 4}));
    EXPECT_EQ(timesInRanges(times, ":"), (Indices{0, 1, 2, 3, 4, 5}));
}

TEST(PostGaugesTimeSelection, messagesNameWhatExists)
{
    EXPECT_NE(messageOf("2:3").find("0, 0.1, 0.2"), std::string::npos);
    EXPECT_NE(messageOf("half").find("\"half\""), std::string::npos);
    EXPECT_NE(messageOf("0.1:nan").find("\"nan\""), std::string::npos);
    EXPECT_EQ(timesText({0, 0.5}), "0, 0.5 (2 times)");
    EXPECT_EQ(timesText({0, 1, 2, 3, 4, 5, 6, 7}), "0, 1, 2 ... 7 (8 times)");
}

TEST(PostGaugesTimeSelection, commandLineComesBeforeTheDictionary)
{
    using Indices = std::vector<std::size_t>;
    EXPECT_EQ(chooseTimes(times, {"", true}, {0.1}, {}), (Indices{5}));
    EXPECT_EQ(chooseTimes(times, {"0.2", false}, {0.1}, {}), (Indices{2}));
    EXPECT_EQ(chooseTimes(times, {}, {0.4, 0.1}, {}), (Indices{4, 1}));
    EXPECT_EQ(chooseTimes(times, {}, {}, {}).size(), times.size());
    EXPECT_THROW((void)chooseTimes({}, {}, {}, {}), CaseError);
    EXPECT_EQ(chooseTimes(times, {}, {0.4, 9}, {}), (Indices{4})) << "a run that ends early still has pictures";
    EXPECT_THROW((void)chooseTimes(times, {}, {9}, {}), CaseError);
}

} // namespace mpsDem::postGauges
