#include "postGauges/TimeSelection.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

#include "core/Log.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

constexpr Real roundOff = 1e-6; ///< Relative: written times carry that many digits at least.

std::optional<Real> parseNumber(std::string_view word)
{
    Real value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    bool const whole = error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
    return whole ? std::optional<Real>(value) : std::nullopt;
}

Real requireNumber(std::string_view word, std::string const& ranges)
{
    auto const value = parseNumber(word);
    require(value.has_value(), {}, "-time: \"" + std::string(word) + "\" in \"" + ranges + "\" is no time",
            "numbers and ranges parted by commas: 0.5,1:2,4:");
    return *value;
}

/// Distance that a written time may have from the one asked for: half of the longest interval beside it.
Real tolerance(std::vector<Real> const& times, std::size_t i)
{
    Real gap = 0;
    if (i > 0) gap = std::max(gap, times[i] - times[i - 1]);
    if (i + 1 < times.size()) gap = std::max(gap, times[i + 1] - times[i]);
    return 0.5 * gap + roundOff * std::max(1.0, std::abs(times[i]));
}

void addRange(std::set<std::size_t>& chosen, std::vector<Real> const& times, Real from, Real to)
{
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        Real const slack = roundOff * std::max(1.0, std::abs(times[i]));
        if (times[i] >= from - slack && times[i] <= to + slack) chosen.insert(i);
    }
}

} // namespace

std::string timesText(std::vector<Real> const& times)
{
    if (times.empty()) return "none";
    std::string text;
    std::size_t const shown = times.size() <= 6 ? times.size() : 3;
    for (std::size_t i = 0; i < shown; ++i) text += (i > 0 ? ", " : "") + number(times[i]);
    if (shown < times.size()) text += " ... " + number(times.back());
    return text + " (" + std::to_string(times.size()) + (times.size() == 1 ? " time)" : " times)");
}

std::size_t nearestTime(std::vector<Real> const& times, Real wanted, Location const& where)
{
    auto const nearer = [&](Real a, Real b) { return std::abs(a - wanted) < std::abs(b - wanted); };
    auto const best = static_cast<std::size_t>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
    bool const near = !times.empty() && std::abs(times[best] - wanted) <= tolerance(times, best);
    require(near, where, "nothing was written at time " + number(wanted) + " s", "written times: " + timesText(times));
    return best;
}

namespace {

/// One piece of `-time`: from .. to, or the time nearest to `from`.
struct TimeRange
{
    Real from, to;
    bool single;
};

std::vector<TimeRange> parseRanges(std::string const& ranges)
{
    constexpr Real unbounded = std::numeric_limits<Real>::infinity();
    std::vector<TimeRange> parsed;
    std::string_view left = ranges;
    while (!left.empty())
    {
        std::size_t const end = std::min(left.find_first_of(", "), left.size());
        std::string_view const word = left.substr(0, end);
        left.remove_prefix(std::min(end + 1, left.size()));
        if (word.empty()) continue;
        std::size_t const colon = word.find(':');
        if (colon == std::string_view::npos)
        {
            parsed.push_back({requireNumber(word, ranges), 0, true});
            continue;
        }
        Real const from = colon == 0 ? -unbounded : requireNumber(word.substr(0, colon), ranges);
        Real const to = colon + 1 == word.size() ? unbounded : requireNumber(word.substr(colon + 1), ranges);
        parsed.push_back({from, to, false});
    }
    return parsed;
}

} // namespace

void requireRanges(std::string const& ranges) { static_cast<void>(parseRanges(ranges)); }

std::vector<std::size_t> timesInRanges(std::vector<Real> const& times, std::string const& ranges)
{
    std::set<std::size_t> chosen;
    for (TimeRange const& range : parseRanges(ranges))
        if (range.single)
            chosen.insert(nearestTime(times, range.from, {}));
        else
            addRange(chosen, times, range.from, range.to);
    require(!chosen.empty(), {}, "-time: no written time in \"" + ranges + "\"", "written times: " + timesText(times));
    return {chosen.begin(), chosen.end()};
}

std::vector<std::size_t> chooseTimes(std::vector<Real> const& times, TimeOptions const& options, std::vector<Real> const& wanted,
                                     Location const& where)
{
    require(!times.empty(), where, "nothing has been written yet", "run the solver first");
    if (options.latest) return {times.size() - 1};
    if (!options.ranges.empty()) return timesInRanges(times, options.ranges);
    std::vector<std::size_t> chosen;
    if (wanted.empty())
    {
        chosen.resize(times.size());
        std::iota(chosen.begin(), chosen.end(), std::size_t{0});
        return chosen;
    }
    Real const end = times.back() + tolerance(times, times.size() - 1);
    for (Real const time : wanted)
        if (time <= end)
            chosen.push_back(nearestTime(times, time, where));
        else
            warn(where.str() + ": the run ends at " + number(times.back()) + " s, before time " + number(time) + " s");
    require(!chosen.empty(), where, "no time that is asked for was written", "written times: " + timesText(times));
    return chosen;
}

} // namespace mpsDem::postGauges
