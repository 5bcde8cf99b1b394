#pragma once

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/Types.h"
#include "io/Table.h"

namespace mpsDem::test {

/// Values over time, straight lines between them.
class Curve
{
public:
    /// @param time  Not before the last one.
    void add(Real time, Real value) { points_.emplace_back(time, value); }

    /// The value at a time; the first or last one outside of the series.
    [[nodiscard]] Real at(Real time) const
    {
        auto const next = std::lower_bound(points_.begin(), points_.end(), std::pair(time, -std::numeric_limits<Real>::infinity()));
        if (next == points_.begin()) return points_.front().second;
        if (next == points_.end()) return points_.back().second;
        auto const last = std::prev(next);
        Real const share = (time - last->first) / (next->first - last->first);
        return (1 - share) * last->second + share * next->second;
    }

    /// Mean from a to b, b > a: the trapezoidal rule on the points between them.
    [[nodiscard]] Real mean(Real from, Real to) const
    {
        Real sum = 0;
        std::pair<Real, Real> last(from, at(from));
        auto const step = [&](std::pair<Real, Real> const& point) {
            sum += 0.5 * (point.second + last.second) * (point.first - last.first);
            last = point;
        };
        for (auto const& point : points_)
            if (point.first > from && point.first < to) step(point);
        step({to, at(to)});
        return sum / (to - from);
    }

    /// Largest value from a to b.
    [[nodiscard]] Real largest(Real from, Real to) const
    {
        Real result = std::max(at(from), at(to));
        for (auto const& [time, value] : points_)
            if (time > from && time < to) result = std::max(result, value);
        return result;
    }

    /// First time at which the value is at least `level`; infinite where it never is.
    [[nodiscard]] Real firstAbove(Real level) const
    {
        for (auto const& [time, value] : points_)
            if (value >= level) return time;
        return std::numeric_limits<Real>::infinity();
    }

    [[nodiscard]] std::vector<std::pair<Real, Real>> const& points() const { return points_; }

private:
    std::vector<std::pair<Real, Real>> points_;
};

/// Two columns of a table in tutorials/resources.
inline Curve reference(std::string const& file, std::string const& time, std::string const& value)
{
    Table const table = readTable(std::filesystem::path(MPSDEM_TEST_DATA).parent_path() / "tutorials" / "resources" / file);
    std::vector<Real> const &times = table.column(time), &values = table.column(value);
    Curve curve;
    for (std::size_t k = 0; k < times.size(); ++k) curve.add(times[k], values[k]);
    return curve;
}

} // namespace mpsDem::test
