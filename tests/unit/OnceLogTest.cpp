#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/OnceLog.h"

namespace {

using namespace mpsDem;

/// Warnings that a text holds, each once on standard output and once on standard error.
int warningsIn(std::string const& text)
{
    int count = 0;
    for (std::size_t at = text.find("FOAM Warning"); at != std::string::npos; at = text.find("FOAM Warning", at + 1)) ++count;
    return count;
}

TEST(OnceLog, WhatHappensInEveryStepIsShownOnceADecadeAndCountedAtTheEnd)
{
    forgetShown();
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    for (int k = 0; k < 1234; ++k) warnSeldom("the block overlaps by " + std::to_string(k), "overlap of the block");
    warnSeldom("the disc overlaps", "overlap of the disc");
    static_cast<void>(testing::internal::GetCapturedStderr());
    std::string const log = testing::internal::GetCapturedStdout();
    EXPECT_EQ(warningsIn(log), 5) << log;
    for (std::string const piece :
         {"by 0\n", "by 9 (10 such warnings so far)\n", "by 99 (100 such", "by 999 (1000 such", "the disc overlaps\n"})
        EXPECT_NE(log.find(piece), std::string::npos) << piece << '\n' << log;
    std::ostringstream end;
    tellSeldom(end);
    EXPECT_EQ(end.str(), "Warnings in all, overlap of the block: 1234\n\n");
}

} // namespace
