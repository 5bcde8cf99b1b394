#include "postGauges/Curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/Log.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

std::map<std::string, std::string> const& colours()
{
    static std::map<std::string, std::string> const names = {{"black", "#000000"},  {"grey", "#8a8a8a"},    {"blue", "#0072b2"},
                                                             {"orange", "#e69f00"}, {"green", "#009e73"},   {"red", "#d55e00"},
                                                             {"purple", "#cc79a7"}, {"skyBlue", "#56b4e9"}, {"yellow", "#f0e442"}};
    return names;
}

bool isHexColour(std::string const& text)
{
    return text.size() == 7 && text.front() == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

std::string readColour(Dictionary const& dict, std::string const& fallback)
{
    std::string const colour = dict.getOr("colour", fallback);
    std::vector<std::string> known = {"auto", "\"#rrggbb\""};
    for (auto const& [name, code] : colours()) known.push_back(name);
    bool const fits = colour == "auto" || isHexColour(colour) || colours().count(colour) != 0;
    require(fits, dict.where("colour"), "colour \"" + colour + "\" is not known", knownWords("colours", colour, known));
    return colour;
}

Real column(Dictionary const& dict, std::string const& key, Real fallback)
{
    Real const value = dict.getOr(key, fallback);
    require(!key.ends_with("Scale") || value != 0, dict.where(key), key + " must not be zero");
    return value;
}

} // namespace

std::string automaticColour(std::size_t n)
{
    static std::array<char const*, 7> const cycle = {"blue", "red", "green", "purple", "orange", "skyBlue", "black"};
    return colours().at(cycle[n % cycle.size()]);
}

CurveStyle CurveStyle::read(Dictionary const& dict, CurveStyle const& defaults)
{
    static std::vector<std::string> const kinds = {"line", "dashed", "points", "linePoints", "band"};
    CurveStyle style = defaults;
    style.label = dict.getOr("label", defaults.label);
    style.kind = dict.getWordOr("style", defaults.kind, kinds, "styles");
    style.colour = readColour(dict, defaults.colour);
    style.lineWidth = dict.getInRangeOr("lineWidth", defaults.lineWidth, 0.1, 20);
    style.pointSize = dict.getInRangeOr("pointSize", defaults.pointSize, 0.1, 20);
    return style;
}

CurveSource CurveSource::read(std::string const& name, Dictionary const& dict, CurveStyle const& defaults)
{
    CurveSource source;
    source.name = name;
    source.table = TableSource::read(dict);
    if (dict.found("x")) source.xColumn = wordOrNumber(dict, "x");
    if (dict.found("y")) source.yColumn = wordOrNumber(dict, "y");
    source.xScale = column(dict, "xScale", 1);
    source.xOffset = column(dict, "xOffset", 0);
    source.yScale = column(dict, "yScale", 1);
    source.yOffset = column(dict, "yOffset", 0);
    CurveStyle own = defaults;
    own.label = plain(name);
    source.style = CurveStyle::read(dict, own);
    if (source.style.kind == "band") source.upperColumn = wordOrNumber(dict, "y2");
    return source;
}

Curve CurveSource::load(PostCase const& postCase) const
{
    Table const data = table.load(postCase);
    Curve curve{name, {columnOf(data, xColumn, table.where), columnOf(data, yColumn, table.where)}, {}, style};
    if (!upperColumn.empty()) curve.upper = columnOf(data, upperColumn, table.where);
    for (Real& x : curve.points.x) x = xScale * x + xOffset;
    for (Real& y : curve.points.y) y = yScale * y + yOffset;
    for (Real& y : curve.upper) y = yScale * y + yOffset;
    return curve;
}

std::vector<Curve> loadCurves(std::vector<CurveSource> const& sources, PostCase const& postCase)
{
    std::vector<Curve> curves;
    for (CurveSource const& source : sources)
    {
        auto const path = source.table.path(postCase);
        if (source.table.isReference() && !std::filesystem::is_regular_file(path))
            warn(source.table.where.str() + ": there is no file " + postCase.shown(path) + ", drawn without \"" + source.name + "\"");
        else
            curves.push_back(source.load(postCase));
    }
    return curves;
}

std::vector<CurveSource> readCurveSources(Dictionary const& dict, std::string const& key, CurveStyle const& defaults)
{
    std::vector<CurveSource> sources;
    if (!dict.found(key)) return sources;
    Dictionary const entries = dict.subDict(key);
    for (std::string const& name : entries.keys())
    {
        require(entries.isDict(name), entries.where(name), key + "." + name + " must be a dictionary",
                name + " { file \"table.csv\"; x 1; y 2; }");
        sources.push_back(CurveSource::read(name, entries.subDict(name), defaults));
    }
    return sources;
}

namespace {

std::string colourOf(CurveStyle const& style, std::size_t& automatic)
{
    if (isHexColour(style.colour)) return style.colour;
    if (style.colour != "auto") return colours().at(style.colour);
    if (style.kind == "band") return "#8a8a8a";
    if (style.kind == "points") return "#000000";
    return automaticColour(automatic++);
}

std::string lookOf(CurveStyle const& style, std::string const& colour, std::size_t pointKind)
{
    static std::array<int, 5> const pointKinds = {6, 4, 8, 12, 2}; // open circle, square, triangle, diamond, cross
    std::string const line = " lw " + number(style.lineWidth) + " lc rgb '" + colour + "'";
    std::string const point = " pt " + std::to_string(pointKinds[pointKind % pointKinds.size()]) + " ps " + number(style.pointSize);
    if (style.kind == "band") return "with filledcurves fs transparent solid 0.3 noborder lc rgb '" + colour + "'";
    if (style.kind == "dashed") return "with lines dt (8,5)" + line;
    if (style.kind == "points")
        return "with points" + point + " lw " + number(std::max(1.0, 0.75 * style.lineWidth)) + " lc rgb '" + colour + "'";
    if (style.kind == "linePoints") return "with linespoints" + point + line;
    return "with lines" + line;
}

std::string rowsOf(Curve const& curve)
{
    std::string rows;
    for (std::size_t i = 0; i < curve.points.x.size(); ++i)
    {
        if (curve.upper.empty())
            addRow(rows, {curve.points.x[i], curve.points.y[i]});
        else
            addRow(rows, {curve.points.x[i], curve.points.y[i], curve.upper[i]});
    }
    return rows;
}

} // namespace

void drawCurves(std::vector<Curve> const& curves, Picture& picture, std::vector<std::string> const& further)
{
    std::vector<std::string> bands, others;
    std::size_t automatic = 0, pointKind = 0;
    for (Curve const& curve : curves)
    {
        require(!finitePoints(curve.points).x.empty(), {}, "the curve \"" + curve.name + "\" has no point to draw");
        std::string const colour = colourOf(curve.style, automatic);
        bool const band = !curve.upper.empty();
        bool const marks = curve.style.kind == "points" || curve.style.kind == "linePoints";
        std::string const title = curve.style.label.empty() ? " notitle" : " title " + quoted(curve.style.label);
        std::string const columns = band ? " using 1:2:3 " : " using 1:2 ";
        std::string const item = picture.addData(rowsOf(curve)) + columns + lookOf(curve.style, colour, pointKind) + title;
        if (marks) ++pointKind;
        (band ? bands : others).push_back(item);
    }
    bands.insert(bands.end(), others.begin(), others.end());
    bands.insert(bands.end(), further.begin(), further.end());
    char const* separator = "plot ";
    for (std::string const& item : bands)
    {
        picture.script() << separator << item;
        separator = ", \\\n     ";
    }
    picture.script() << '\n';
}

} // namespace mpsDem::postGauges
