#pragma once

#include <string>
#include <vector>

#include "core/Errors.h"
#include "core/Types.h"

namespace mpsDem::postGauges {

/// Which of the written times the command line asks for.
struct TimeOptions
{
    std::string ranges;  ///< As `-time` of OpenFOAM: "0:1,2.5,4:" ; empty where not given.
    bool latest = false; ///< `-latestTime`
    [[nodiscard]] bool given() const { return latest || !ranges.empty(); }
};

/// Index of the time nearest to `wanted` [s].
///
/// It may lie half an interval between written times away, so that 0.5 finds 0.50003.
/// @param times  Written times, increasing.
/// @throw CaseError (BadInput) where none is that near; the message names those that exist.
std::size_t nearestTime(std::vector<Real> const& times, Real wanted, Location const& where);

/// @throw CaseError (BadInput) for text that is no list of ranges, before anything is drawn.
void requireRanges(std::string const& ranges);

/// Indices of the times in the ranges, increasing, each once. A number without ':' takes the nearest time as `nearestTime` does.
/// @throw CaseError (BadInput) for text that is no list of ranges and where no time is left.
std::vector<std::size_t> timesInRanges(std::vector<Real> const& times, std::string const& ranges);

/// The command line's choice; without one those of the list that the run has reached, with a warning for the others; without a list all.
std::vector<std::size_t> chooseTimes(std::vector<Real> const& times, TimeOptions const& options, std::vector<Real> const& wanted,
                                     Location const& where);

/// "0, 0.1, 0.2 ... 5 (51 times)" for messages.
std::string timesText(std::vector<Real> const& times);

} // namespace mpsDem::postGauges
