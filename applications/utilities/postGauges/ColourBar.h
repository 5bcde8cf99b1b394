#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "postGauges/SheetLayout.h"

namespace mpsDem::postGauges {

/// Colours of values and the bar that explains them.
struct ColourBar
{
    std::string palette = "viridis";
    std::string label;                    ///< Above the bar.
    std::pair<Real, Real> range = {0, 1}; ///< Values of the first and the last colour.
    bool below = false;                   ///< Values beyond the range, by more than a hundredth of it: an end of the bar says so.
    bool above = false;

    /// Palette, range and as many tics as there is room for, as gnuplot's settings.
    void writeScale(std::ostream& script, SheetLayout const& sheet, int fontSize) const;
    /// Place of the bar and its label.
    void writeBox(std::ostream& script, SheetLayout const& sheet, int fontSize) const;
    /// Colour of a value: red, green, blue from 0 to 1.
    [[nodiscard]] std::array<float, 3> colour(Real value) const;
};

/// Where a panel lies, as gnuplot's margins.
void writeMargins(std::ostream& script, Box const& panel);

/// Finds the range of the colours from the values of several pictures: all but the outermost 0.2 % of each, rounded outwards.
class RangeFinder
{
public:
    void add(std::vector<Real> const& values);
    [[nodiscard]] bool empty() const { return low_ > high_; }
    /// Sets range, below and above. @param fixed  Wins where given. @param fromZero  Ranges of positive values begin at 0.
    /// With the palette coolWarm the range is even about 0.
    void set(ColourBar& bar, std::optional<std::pair<Real, Real>> const& fixed, bool fromZero) const;

private:
    Real low_ = 1e300, high_ = -1e300, lowest_ = 1e300, highest_ = -1e300;
};

} // namespace mpsDem::postGauges
