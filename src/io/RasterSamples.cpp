#include "io/RasterSamples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/Errors.h"
#include "core/OnceLog.h"

namespace mpsDem {

namespace {

constexpr Real spreads = 10; ///< Further from the middle than this many spreads is far.
constexpr Real extents = 2;  ///< Further than this many extents is impossible.

/// Numbers that stand for "no height" in many files.
constexpr std::array<Real, 4> usualMissing{-9999, -32768, -32767, -99999};

bool standsForNone(Real height)
{
    return std::any_of(usualMissing.begin(), usualMissing.end(), [&](Real none) { return std::abs(height - none) < 0.01; });
}

/// The height that a share of all is below.
Real quantile(std::vector<Real>& heights, Real share)
{
    auto const place = heights.begin() + static_cast<std::ptrdiff_t>(share * static_cast<Real>(heights.size() - 1));
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
}

std::string cellText(RasterSamples const& samples, std::size_t sample)
{
    auto const number = [](Real position) { return std::to_string(static_cast<int>(position) + 1); };
    return "row " + number(samples.south[sample / samples.east.size()]) + ", column " + number(samples.east[sample % samples.east.size()]);
}

/// Heights of one kind: how many, and the first.
struct Found
{
    std::size_t count = 0, first = 0;
    void add(std::size_t sample)
    {
        if (count++ == 0) first = sample;
    }
    [[nodiscard]] std::string others() const { return count > 1 ? " (and " + std::to_string(count - 1) + " more)" : ""; }
};

/// Two more numbers around a line of positions: half a cell before the first, and half a cell behind the last of `cells`.
std::vector<Real> widened(std::vector<Real> const& positions, int cells)
{
    std::vector<Real> wide{-0.5};
    wide.insert(wide.end(), positions.begin(), positions.end());
    wide.push_back(cells - 0.5);
    return wide;
}

/// Height at position `x` in a line with those of two places; that of the nearer one where the other is missing.
Real inLine(Real x, Real nearer, Real nearerHeight, Real other, Real otherHeight)
{
    if (std::isnan(otherHeight)) return nearerHeight;
    return nearerHeight + (nearerHeight - otherHeight) * (x - nearer) / (nearer - other);
}

/// Marks the missing heights that hang together with the given one.
void markMissing(RasterSamples const& samples, int row, int column, std::vector<char>& marked)
{
    std::vector<std::pair<int, int>> next{{row, column}};
    while (!next.empty())
    {
        auto const [r, c] = next.back();
        next.pop_back();
        if (r < 0 || c < 0 || r >= samples.rows() || c >= samples.columns()) continue;
        std::size_t const own = samples.index(r, c);
        if (marked[own] != 0 || !std::isnan(samples.height[own])) continue;
        marked[own] = 1;
        for (auto const& [dr, dc] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) next.emplace_back(r + dr, c + dc);
    }
}

} // namespace

void checkHeights(RasterSamples const& samples, RasterSource const& source)
{
    std::vector<Real> heights;
    for (Real const height : samples.height)
        if (!std::isnan(height)) heights.push_back(height);
    if (heights.empty()) return;
    Real const middle = quantile(heights, 0.5), spread = quantile(heights, 0.9) - quantile(heights, 0.1);
    Found impossible, far;
    for (std::size_t k = 0; k < samples.height.size(); ++k)
    {
        Real const off = std::abs(samples.height[k] - middle);
        if (!(off > spreads * spread)) continue; // NaN is not
        if (off > extents * source.extent || standsForNone(samples.height[k]))
            impossible.add(k);
        else if (spread > 0)
            far.add(k);
    }
    auto const text = [&](Found const& found) {
        return "height " + shortNumber(samples.height[found.first]) + " in " + cellText(samples, found.first) + found.others() +
               " is far off the others, which lie about " + shortNumber(middle);
    };
    if (impossible.count > 0)
        throw CaseError(ExitCode::BadInput, Location{source.file, samples.line[impossible.first], {}}, text(impossible),
                        "heights in the unit of cellsize; where none is known NODATA_value, " + shortNumber(source.missing) +
                            " in this file");
    if (far.count == 0) return;
    warnOnce(Location{source.file, samples.line[far.first], {}}.str() + ": " + text(far));
}

void warnOfHoles(RasterSamples const& samples, std::string const& file)
{
    std::vector<char> outer(samples.height.size(), 0);
    for (int row = 0; row < samples.rows(); ++row)
        for (int column : {0, samples.columns() - 1}) markMissing(samples, row, column, outer);
    for (int column = 0; column < samples.columns(); ++column)
        for (int row : {0, samples.rows() - 1}) markMissing(samples, row, column, outer);
    Found missing;
    for (std::size_t k = 0; k < samples.height.size(); ++k)
        if (std::isnan(samples.height[k]) && outer[k] == 0) missing.add(k);
    if (missing.count == 0) return;
    warnOnce(Location{file, samples.line[missing.first], {}}.str() + ": no height in " + cellText(samples, missing.first) +
             missing.others() + " (NODATA_value): the surface has a hole there");
}

void warnOfRowsWithinLines(RasterSamples const& samples, std::string const& file)
{
    if (samples.line.front() == samples.line.back()) return;
    for (int row = 1; row < samples.rows(); ++row)
    {
        std::size_t const k = samples.index(row, 0);
        if (samples.line[k] != samples.line[k - 1]) continue;
        warnOnce(Location{file, samples.line[k], {}}.str() +
                 ": a row (ncols heights) begins within this line, though there are several lines: are ncols and nrows right?");
        return;
    }
}

RasterSamples continued(RasterSamples const& samples, int columns, int rows)
{
    RasterSamples wide;
    wide.east = widened(samples.east, columns);
    wide.south = widened(samples.south, rows);
    wide.height.assign(wide.east.size() * wide.south.size(), std::numeric_limits<Real>::quiet_NaN());
    int const lastRow = wide.rows() - 1, lastColumn = wide.columns() - 1;
    auto const line = [&](std::vector<Real> const& x, int to, int from, int before, Real near, Real far) {
        auto const at = [&](int k) { return x[static_cast<std::size_t>(k)]; };
        return inLine(at(to), at(from), near, at(before), far);
    };
    for (int row = 1; row < lastRow; ++row)
    {
        for (int column = 1; column < lastColumn; ++column) wide.height[wide.index(row, column)] = samples.at(row - 1, column - 1);
        wide.height[wide.index(row, 0)] = line(wide.east, 0, 1, 2, wide.at(row, 1), wide.at(row, 2));
        wide.height[wide.index(row, lastColumn)] =
            line(wide.east, lastColumn, lastColumn - 1, lastColumn - 2, wide.at(row, lastColumn - 1), wide.at(row, lastColumn - 2));
    }
    for (int column = 0; column <= lastColumn; ++column)
    {
        wide.height[wide.index(0, column)] = line(wide.south, 0, 1, 2, wide.at(1, column), wide.at(2, column));
        wide.height[wide.index(lastRow, column)] =
            line(wide.south, lastRow, lastRow - 1, lastRow - 2, wide.at(lastRow - 1, column), wide.at(lastRow - 2, column));
    }
    return wide;
}

} // namespace mpsDem
