#include "postGauges/ColourBar.h"

#include <algorithm>
#include <cmath>

#include "postGauges/ParticleColours.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

constexpr Real cut = 0.002, beyond = 0.01;

} // namespace

void ColourBar::writeScale(std::ostream& script, SheetLayout const& sheet, int fontSize) const
{
    script << paletteCommand(palette) << "set cbrange [" << number(range.first, 9) << ':' << number(range.second, 9) << "]\n";
    Real const pixels = (sheet.bar.top - sheet.bar.bottom) * sheet.height;
    Real const line = 1.6 * fontSize / pixels * (range.second - range.first);
    script << "set cbtics out scale 0.4 ('' " << number(range.first, 9); // a list must not be empty
    auto const add = [&](std::string const& mark, Real value) { script << ", '" << mark << number(value) << "' " << number(value, 9); };
    if (below) add("\u2264 ", range.first);
    if (above) add("\u2265 ", range.second);
    for (Real const value : niceTics(range.first, range.second, ticsAbove(pixels, fontSize)))
        if (!(below && value < range.first + line) && !(above && value > range.second - line)) add("", value);
    script << ")\n";
}

void ColourBar::writeBox(std::ostream& script, SheetLayout const& sheet, int fontSize) const
{
    Box const& bar = sheet.bar;
    script << "set colorbox vertical user origin screen " << number(bar.left, 6) << ",screen " << number(bar.bottom, 6) << " size screen "
           << number(bar.right - bar.left, 6) << ",screen " << number(bar.top - bar.bottom, 6) << "\nset label " << quoted(label)
           << " at screen " << number(bar.left, 6) << ",screen " << number(bar.top + 1.9 * fontSize / sheet.height, 6) << " left\n";
}

std::array<float, 3> ColourBar::colour(Real value) const
{
    Real const share = (value - range.first) / (range.second - range.first);
    return paletteColour(palette, std::isfinite(share) ? share : 0);
}

void writeMargins(std::ostream& script, Box const& panel)
{
    script << "set lmargin at screen " << number(panel.left, 9) << "\nset rmargin at screen " << number(panel.right, 9)
           << "\nset bmargin at screen " << number(panel.bottom, 9) << "\nset tmargin at screen " << number(panel.top, 9) << '\n';
}

void RangeFinder::add(std::vector<Real> const& values)
{
    if (values.empty()) return;
    low_ = std::min(low_, percentile(values, cut));
    high_ = std::max(high_, percentile(values, 1 - cut));
    lowest_ = std::min(lowest_, *std::min_element(values.begin(), values.end()));
    highest_ = std::max(highest_, *std::max_element(values.begin(), values.end()));
}

void RangeFinder::set(ColourBar& bar, std::optional<std::pair<Real, Real>> const& fixed, bool fromZero) const
{
    Real low = low_, high = high_;
    if (bar.palette == "coolWarm") low = -(high = std::max(std::abs(low), std::abs(high)));
    bar.range = fixed ? *fixed : niceRange(fromZero ? std::min(0.0, low) : low, high);
    Real const tolerance = beyond * (bar.range.second - bar.range.first);
    bar.below = lowest_ < bar.range.first - tolerance;
    bar.above = highest_ > bar.range.second + tolerance;
}

} // namespace mpsDem::postGauges
