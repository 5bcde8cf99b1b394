#include "postGauges/SheetLayout.h"

#include <algorithm>
#include <cmath>

namespace mpsDem::postGauges {

namespace {

/// Room around the panels [pixels at 13 points].
struct Margins
{
    Real left = 90;
    Real right = 0;
    Real bottom = 74;
    Real top = 44;
    Real between = 52;     ///< Beside each other: half a number of each axis.
    Real betweenRows = 44; ///< Title of the lower one.
    Real barGap = 22;      ///< Panels to colour bar.
    Real barWidth = 20;
};

Margins marginsFor(int fontSize, Real sideText)
{
    Real const factor = fontSize / 13.0;
    Margins m;
    for (Real* const value : {&m.left, &m.right, &m.bottom, &m.top, &m.between, &m.betweenRows, &m.barGap, &m.barWidth}) *value *= factor;
    m.right = m.barGap + m.barWidth + sideText * factor;
    return m;
}

/// As many columns as make the block of panels about 1.4 times as wide as high.
int chooseColumns(int count, Real proportion)
{
    int best = 1;
    Real bestMiss = 1e300;
    for (int columns = 1; columns <= count; ++columns)
    {
        int const rows = (count + columns - 1) / columns;
        Real const shape = proportion * columns / rows;
        Real const empty = static_cast<Real>(columns * rows) / count;
        Real const miss = std::abs(std::log(shape / 1.4)) + 0.5 * (empty - 1);
        if (miss >= bestMiss) continue;
        bestMiss = miss;
        best = columns;
    }
    return best;
}

} // namespace

SheetLayout layOut(int count, int columns, Window const& window, int width, int mostHeight, int fontSize, Real sideText, Real titleRoom)
{
    Margins m = marginsFor(fontSize, sideText);
    m.top += titleRoom * fontSize / 13.0;
    Real const sizeX = window.xHigh - window.xLow, sizeY = window.yHigh - window.yLow;
    SheetLayout sheet;
    sheet.columns = columns > 0 ? std::min(columns, count) : chooseColumns(count, sizeX / sizeY);
    sheet.rows = (count + sheet.columns - 1) / sheet.columns;
    Real const gapsX = m.left + m.right + (sheet.columns - 1) * m.between;
    Real const gapsY = m.bottom + m.top + (sheet.rows - 1) * m.betweenRows;
    Real const byWidth = std::max(40.0, width - gapsX) / (sheet.columns * sizeX);
    Real const byHeight = std::max(40.0, mostHeight - gapsY) / (sheet.rows * sizeY);
    sheet.scale = std::min(byWidth, byHeight);
    Real const panelX = sheet.scale * sizeX, panelY = sheet.scale * sizeY;
    Real const wide = gapsX + sheet.columns * panelX, high = gapsY + sheet.rows * panelY;
    sheet.width = 2 * static_cast<int>(std::lround(0.5 * wide)); // even, as films want it
    sheet.height = 2 * static_cast<int>(std::lround(0.5 * high));
    for (int i = 0; i < count; ++i)
    {
        Real const left = m.left + (i % sheet.columns) * (panelX + m.between);
        Real const top = high - m.top - (i / sheet.columns) * (panelY + m.betweenRows);
        sheet.panels.push_back({left / wide, (left + panelX) / wide, (top - panelY) / high, top / high});
    }
    Real const barLeft = wide - m.right + m.barGap;
    Real const block = high - m.top - m.bottom;
    Real const barTitle = 30.0 * fontSize / 13.0; // above the bar
    Real const barHeight = std::min(block - barTitle, std::max(panelY, 420.0 * fontSize / 13.0));
    Real const barBottom = m.bottom + 0.5 * (block - barTitle - barHeight);
    sheet.bar = {barLeft / wide, (barLeft + m.barWidth) / wide, barBottom / high, (barBottom + barHeight) / high};
    return sheet;
}

std::pair<Real, Real> niceRange(Real low, Real high)
{
    if (!(high > low)) return {low - 0.5 * std::max(1e-12, std::abs(low)), low + 0.5 * std::max(1e-12, std::abs(low))};
    Real const raw = (high - low) / 8;
    Real const power = std::pow(10.0, std::floor(std::log10(raw)));
    Real step = 10 * power;
    for (Real const factor : {5.0, 2.0, 1.0})
        if (factor * power >= raw) step = factor * power;
    return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

std::vector<Real> niceTics(Real low, Real high, int about)
{
    std::vector<Real> tics;
    Real const raw = (high - low) / about, power = std::pow(10, std::floor(std::log10(raw)));
    Real step = 10 * power;
    for (Real const factor : {5.0, 2.0, 1.0})
        if (factor * power >= 0.99 * raw) step = factor * power;
    for (Real k = std::ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; ++k) tics.push_back(k == 0 ? 0 : k * step);
    return tics;
}

int ticsAbove(Real pixels, int fontSize) { return std::clamp(static_cast<int>(pixels / (2.2 * fontSize)), 1, 10); }

Real percentile(std::vector<Real> values, Real part)
{
    auto const place = static_cast<std::ptrdiff_t>(std::lround(part * static_cast<Real>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

} // namespace mpsDem::postGauges
