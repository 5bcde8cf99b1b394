#pragma once

#include <cmath>
#include <cstdio>
#include <source_location>
#include <string>

#include <gtest/gtest.h>

#include "core/Types.h"

namespace mpsDem::test {

/// Where a test expects something: failures name this line, not that of the helper.
using Place = std::source_location;

/// Prints `name value bound` and expects |value| <= bound.
inline void expectBelow(std::string const& name, Real value, Real bound, Place const& place = Place::current())
{
    std::printf("%-48s %14.6g  bound %g\n", name.c_str(), value, bound);
    if (!(std::abs(value) <= bound))
        ADD_FAILURE_AT(place.file_name(), static_cast<int>(place.line())) << name << ": |" << value << "| exceeds " << bound;
}

/// Prints the same and expects low <= value <= high.
inline void expectBetween(std::string const& name, Real value, Real low, Real high, Place const& place = Place::current())
{
    std::printf("%-48s %14.6g  bound %g .. %g\n", name.c_str(), value, low, high);
    if (!(value >= low && value <= high))
        ADD_FAILURE_AT(place.file_name(), static_cast<int>(place.line()))
            << name << ": " << value << " is outside of " << low << " .. " << high;
}

} // namespace mpsDem::test
