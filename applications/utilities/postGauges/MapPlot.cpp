#include "postGauges/MapPlot.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/Log.h"
#include "postGauges/Axes.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/TableSource.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace fs = std::filesystem;

namespace {

constexpr Real leastHeight = 0.2; ///< Of a map, in widths.

std::string defaultLabel(std::string const& column)
{
    static std::map<std::string, std::string> const labels = {{"eta", "{/Symbol h} [m]"},
                                                              {"etaMax", "largest {/Symbol h} [m]"},
                                                              {"arrival", "arrival [s]"},
                                                              {"timeOfMax", "time of largest {/Symbol h} [s]"}};
    auto const found = labels.find(column);
    return found == labels.end() ? plain(column) : found->second;
}

std::optional<Real> numberIn(std::string const& text)
{
    Real value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool const whole = error == std::errc() && end == text.data() + text.size();
    return whole ? std::optional<Real>(value) : std::nullopt;
}

/// Numbers in names before<number>after of a folder.
std::map<Real, fs::path> numbered(fs::path const& folder, std::string const& before, std::string const& after)
{
    std::map<Real, fs::path> found;
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(folder, error))
    {
        std::string const name = entry.path().filename().string();
        if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after)) continue;
        if (auto const value = numberIn(name.substr(before.size(), name.size() - before.size() - after.size())))
            found[*value] = entry.path();
    }
    return found;
}

/// A long channel is drawn wider than it is.
Window stretched(Window window)
{
    window.yHigh = std::max(window.yHigh, window.yLow + leastHeight * (window.xHigh - window.xLow));
    return window;
}

/// Where the map lies, and its tics.
void writePlace(std::ostream& script, SheetLayout const& sheet, Window const& window, int fontSize)
{
    Box const& panel = sheet.panels.front();
    writeMargins(script, panel);
    int const tics = ticsAbove((panel.top - panel.bottom) * sheet.height, fontSize);
    if (auto const places = niceTics(window.yLow, window.yHigh, tics); places.size() > 1)
        script << "set ytics " << number(places[1] - places[0]) << '\n';
    script << "set xrange [" << number(window.xLow, 9) << ':' << number(window.xHigh, 9) << "]\nset yrange [" << number(window.yLow, 9)
           << ':' << number(window.yHigh, 9) << "]\n";
}

/// The lines of these values as the data block $lines.
void writeContours(std::ostream& script, std::string const& data, std::vector<Real> const& values)
{
    script << "set contour base\nunset surface\nset cntrparam levels discrete ";
    for (std::size_t k = 0; k < values.size(); ++k) script << (k > 0 ? "," : "") << number(values[k], 9);
    script << "\nset table $lines\nsplot " << data << " using 1:2:3\nunset table\nunset contour\nset surface\n";
}

} // namespace

MapGrid MapGrid::read(Table const& table, std::string const& xName, std::string const& yName, std::string const& valueName,
                      Location const& where)
{
    MapGrid grid;
    grid.x = columnOf(table, xName, where);
    std::string second = yName;
    if (second.empty())
    {
        auto const& z = columnOf(table, "z", where);
        second = std::adjacent_find(z.begin(), z.end(), std::not_equal_to<>()) == z.end() ? "y" : "z";
    }
    grid.y = columnOf(table, second, where);
    grid.value = columnOf(table, valueName, where);
    while (grid.perRow < grid.y.size() && grid.y[grid.perRow] == grid.y.front()) ++grid.perRow;
    bool regular = grid.perRow >= 2 && grid.y.size() % grid.perRow == 0 && grid.y.size() >= 2 * grid.perRow;
    for (std::size_t i = 0; regular && i < grid.y.size(); ++i)
        regular = grid.x[i] == grid.x[i % grid.perRow] && grid.y[i] == grid.y[i - i % grid.perRow];
    require(regular, Location{table.file, 0, {}}, "this is no map: rows of places of the same length, two or more of them, are needed");
    return grid;
}

MapPlot::MapPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : Plot(name),
      object_(dict.get<std::string>("object")),
      file_(dict.getOr<std::string>("file", "map")),
      value_(dict.getOr<std::string>("value", "etaMax")),
      x_(dict.getOr<std::string>("x", "x")),
      y_(dict.getOr<std::string>("y", "")),
      contours_(dict.getOr("contours", std::vector<Real>())),
      range_(readRange(dict, "range")),
      scale_(dict.getOr("scale", 1.0)),
      label_(dict.getOr("label", defaultLabel(value_))),
      palette_(dict.getWordOr("palette", "viridis", paletteNames(), "palettes")),
      title_(dict.getOr<std::string>("title", "")),
      xLabel_(dict.getOr<std::string>("xLabel", "x [m]")),
      yLabel_(dict.getOr<std::string>("yLabel", y_ == "y" ? "y [m]" : "z [m]")),
      width_(static_cast<int>(dict.getInRangeOr("width", 1200, 300, 8000))),
      maxHeight_(static_cast<int>(dict.getInRangeOr("maxHeight", 1200, 200, 8000))),
      pictures_(pictures),
      where_(dict.where())
{
    if (dict.found("time")) time_ = dict.get<Real>("time");
}

fs::path MapPlot::table(PostCase const& postCase) const
{
    fs::path const folder = postCase.root / "postProcessing" / object_;
    std::map<Real, fs::path> tables; // of a later start in place of an earlier one's
    for (auto const& [start, path] : numbered(folder, "", ""))
        for (auto const& [time, file] : numbered(path, file_ + "_", ".dat")) tables[time] = file;
    if (tables.empty())
        throw CaseError(ExitCode::InputOutput, where_, "there is no " + file_ + "_<time>.dat in " + postCase.shown(folder),
                        "the name of an elevationMap in `functions` of system/controlDict that has been written");
    std::vector<Real> times;
    for (auto const& [time, file] : tables) times.push_back(time);
    return tables.at(times[time_ ? nearestTime(times, *time_, where_) : times.size() - 1]);
}

void MapPlot::draw(PostCase const& postCase) const
{
    fs::path const source = table(postCase);
    MapGrid const grid = MapGrid::read(readTable(source), x_, y_, value_, where_);
    std::string rows;
    std::vector<Real> values;
    for (std::size_t i = 0; i < grid.value.size(); ++i)
    {
        addRow(rows, {grid.x[i], grid.y[i], scale_ * grid.value[i]});
        if ((i + 1) % grid.perRow == 0) rows += '\n';
        if (std::isfinite(grid.value[i])) values.push_back(scale_ * grid.value[i]);
    }
    if (values.empty()) // a wave that has come nowhere yet is no error
    {
        warn(name() + " is left out: the column " + value_ + " of " + postCase.shown(source) + " has no value; a later time may have");
        return;
    }
    ColourBar bar;
    bar.palette = palette_;
    bar.label = label_;
    RangeFinder finder;
    finder.add(values);
    finder.set(bar, range_, false);
    Real const stepX = std::abs(grid.x[1] - grid.x[0]), stepY = std::abs(grid.y[grid.perRow] - grid.y[0]);
    auto const [xLow, xHigh] = std::minmax_element(grid.x.begin(), grid.x.end());
    auto const [yLow, yHigh] = std::minmax_element(grid.y.begin(), grid.y.end());
    Window const window{*xLow - 0.5 * stepX, *xHigh + 0.5 * stepX, *yLow - 0.5 * stepY, *yHigh + 0.5 * stepY};
    auto const sheet = layOut(1, 1, stretched(window), width_, maxHeight_, pictures_.fontSize, 110);
    Picture picture(postCase.plots(), name(), sheet.width, sheet.height, pictures_);
    auto& script = picture.script();
    std::string const data = picture.addData(rows);
    script << "set border 15 lw 1 lc rgb '#404040'\nset tics out scale 0.6 nomirror textcolor rgb '#202020'\nunset key\n";
    bar.writeScale(script, sheet, pictures_.fontSize);
    bar.writeBox(script, sheet, pictures_.fontSize);
    if (!contours_.empty()) writeContours(script, data, contours_);
    writePlace(script, sheet, window, pictures_.fontSize);
    script << "set title " << quoted(title_) << "\nset xlabel " << quoted(xLabel_) << "\nset ylabel " << quoted(yLabel_) << "\nplot "
           << data << " using 1:2:3 with image";
    if (!contours_.empty()) script << ", $lines using 1:2 with lines lw 1.2 lc rgb '#202020'";
    script << '\n';
    info() << "    from " << postCase.shown(source) << '\n';
    render(postCase, picture);
}

} // namespace mpsDem::postGauges
