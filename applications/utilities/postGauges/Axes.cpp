#include "postGauges/Axes.h"

#include <cmath>
#include <map>

#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

std::map<std::string, std::string> const& legends()
{
    static std::map<std::string, std::string> const places = {
        {"topRight", "set key top right"},     {"topLeft", "set key top left"},          {"bottomRight", "set key bottom right"},
        {"bottomLeft", "set key bottom left"}, {"outside", "set key outside right top"}, {"none", "unset key"}};
    return places;
}

void readLogScale(Dictionary const& dict, Axes& axes)
{
    if (!dict.found("logScale")) return;
    axes.logX = axes.logY = false;
    for (std::string const& axis : dict.get<std::vector<std::string>>("logScale"))
    {
        require(axis == "x" || axis == "y", dict.where("logScale"), "logScale: \"" + axis + "\" is no axis", "allowed: x y");
        (axis == "x" ? axes.logX : axes.logY) = true;
    }
}

void requirePositive(Dictionary const& dict, std::string const& key, bool log, std::optional<std::pair<Real, Real>> const& range)
{
    require(!log || !range || range->first > 0, dict.where(key), key + " must be above zero on a logarithmic axis");
}

/// Labels at 1, 2 and 5 times the powers of ten, where the range spans less than two of them: powers alone would be one label or two.
std::string oneTwoFive(std::string const& axis, std::optional<std::pair<Real, Real>> const& range)
{
    if (!range || range->second / range->first > 150) return {};
    std::string tics;
    for (Real power = std::pow(10, std::floor(std::log10(range->first))); power <= range->second; power *= 10)
        for (Real const factor : {1.0, 2.0, 5.0}) tics += (tics.empty() ? "" : ", ") + number(factor * power);
    return "set " + axis + "tics (" + tics + ")\n";
}

std::string rangeText(std::optional<std::pair<Real, Real>> const& range)
{
    return range ? "[" + number(range->first, 12) + ":" + number(range->second, 12) + "]" : "[*:*]";
}

} // namespace

std::optional<std::pair<Real, Real>> readRange(Dictionary const& dict, std::string const& key)
{
    if (!dict.found(key)) return std::nullopt;
    auto const ends = dict.get<std::vector<Real>>(key);
    bool const fits = ends.size() == 2 && ends[0] < ends[1];
    require(fits, dict.where(key), key + " must be two increasing numbers", key + " (0 2.5);");
    return std::pair(ends[0], ends[1]);
}

Axes Axes::read(Dictionary const& dict, Axes const& defaults)
{
    Axes axes = defaults;
    axes.title = dict.getOr("title", defaults.title);
    axes.xLabel = dict.getOr("xLabel", defaults.xLabel);
    axes.yLabel = dict.getOr("yLabel", defaults.yLabel);
    if (auto const range = readRange(dict, "xRange")) axes.xRange = range;
    if (auto const range = readRange(dict, "yRange")) axes.yRange = range;
    readLogScale(dict, axes);
    requirePositive(dict, "xRange", axes.logX, axes.xRange);
    requirePositive(dict, "yRange", axes.logY, axes.yRange);
    std::vector<std::string> places;
    for (auto const& [name, command] : legends()) places.push_back(name);
    axes.legend = dict.getWordOr("legend", defaults.legend, places, "places of the legend");
    axes.verticalLines = dict.getOr("verticalLines", defaults.verticalLines);
    axes.horizontalLines = dict.getOr("horizontalLines", defaults.horizontalLines);
    axes.grid = dict.getOr("grid", defaults.grid);
    auto const size = dict.getOr("size", std::vector<int>{defaults.width, defaults.height});
    bool const fits = size.size() == 2 && size[0] >= 200 && size[1] >= 150 && size[0] <= 8000 && size[1] <= 8000;
    require(fits, dict.where("size"), "size must be (width height) in pixels", "allowed: (200 150) to (8000 8000)");
    axes.width = size[0];
    axes.height = size[1];
    return axes;
}

void writeStyle(std::ostream& script)
{
    script << "set border 3 lw 1 lc rgb '#404040'\n"
           << "set tics nomirror out scale 0.6 textcolor rgb '#202020'\n"
           << "set format x '%g'\nset format y '%g'\nset offsets graph 0,graph 0,graph 0.12,graph 0.05\nset key Left reverse noopaque "
              "spacing 1.15 samplen 2.5\n";
}

void Axes::write(std::ostream& script) const
{
    script << "set title " << quoted(title) << "\nset xlabel " << quoted(xLabel) << "\nset ylabel " << quoted(yLabel) << '\n';
    script << "set xrange " << rangeText(xRange) << "\nset yrange " << rangeText(yRange) << '\n';
    script << (logX ? "set logscale x\n" : "unset logscale x\n") << (logY ? "set logscale y\n" : "unset logscale y\n");
    if (logX) script << oneTwoFive("x", xRange);
    if (logY) script << oneTwoFive("y", yRange);
    script << (grid ? "set grid lw 0.6 lc rgb '#dddddd' lt 1\n" : "unset grid\n");
    script << legends().at(legend) << "\nunset arrow\n";
    std::string const dashed = " nohead front lw 1 dt (6,4) lc rgb '#707070'\n";
    for (Real const x : verticalLines)
        script << "set arrow from first " << number(x, 12) << ",graph 0 to first " << number(x, 12) << ",graph 1" << dashed;
    for (Real const y : horizontalLines)
        script << "set arrow from graph 0,first " << number(y, 12) << " to graph 1,first " << number(y, 12) << dashed;
}

} // namespace mpsDem::postGauges
