#include "postGauges/ConvergencePlot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "postGauges/Curve.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

ConvergencePlot::ConvergencePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : Plot(name),
      file_(dict.get<std::string>("file")),
      bySeconds_(dict.getWordOr("abscissa", "seconds", {"seconds", "spacing"}, "abscissas") == "seconds"),
      showSpacing_(dict.getOr("showSpacing", true)),
      pictures_(pictures)
{
    Axes defaults;
    defaults.legend = "bottomLeft";
    defaults.logX = defaults.logY = true;
    defaults.xLabel = bySeconds_ ? "computing time [s]" : "particle spacing [m]";
    defaults.yLabel = "error [-]";
    axes_ = Axes::read(dict, defaults);
    Dictionary const labels = dict.subDictOrEmpty("labels");
    for (std::string const& scheme : labels.keys()) labels_[scheme] = labels.get<std::string>(scheme);
}

namespace {

/// Schemes in the order of the table.
std::vector<std::string> schemesOf(std::vector<StudyRun> const& runs)
{
    std::vector<std::string> schemes;
    for (StudyRun const& run : runs)
        if (std::find(schemes.begin(), schemes.end(), run.scheme) == schemes.end()) schemes.push_back(run.scheme);
    return schemes;
}

/// A range that holds all values with room beside them.
std::pair<Real, Real> roomAround(std::vector<Real> const& values, bool log)
{
    auto const [low, high] = std::minmax_element(values.begin(), values.end());
    if (log) return {*low / 1.6, *high * 1.6};
    Real const margin = *high > *low ? 0.08 * (*high - *low) : 0.5 * std::max(1e-12, std::abs(*high));
    return {*low - margin, *high + margin};
}

/// The spacing as a small text at the upper right of each point.
constexpr char const* spacingLabels =
    " using 1:2:(sprintf('%g', $5)) with labels offset character 0.6,0.7 left font ',9' tc rgb '#505050' notitle";

/// Items of a plot command, each with the words that gnuplot needs between them.
class PlotItems
{
public:
    void add(std::string const& item) { text_ += (text_.empty() ? "plot " : ", \\\n     ") + item; }
    [[nodiscard]] std::string str() const { return text_ + '\n'; }

private:
    std::string text_;
};

void requireLabelled(std::map<std::string, std::string> const& labels, std::vector<std::string> const& schemes, Location const& where)
{
    for (auto const& [scheme, label] : labels)
        require(std::find(schemes.begin(), schemes.end(), scheme) != schemes.end(), where, "there is no scheme \"" + scheme + "\" to label",
                knownWords("schemes", scheme, schemes));
}

} // namespace

Axes ConvergencePlot::axesFor(std::vector<StudyRun> const& runs, Location const& where) const
{
    std::vector<Real> x, y;
    for (StudyRun const& run : runs)
    {
        if (abscissa(run) > 0) x.push_back(abscissa(run));
        if (!(run.error > 0)) continue;
        y.push_back(run.error);
        y.push_back(run.error + (run.spread > 0 ? 0.5 * run.spread : 0));
    }
    require(!x.empty() && !y.empty(), where, "no run has an error and a cost to draw");
    Axes axes = axes_;
    if (!axes.xRange) axes.xRange = roomAround(x, axes.logX);
    if (!axes.yRange) axes.yRange = roomAround(y, axes.logY);
    return axes;
}

ConvergencePlot::Rows ConvergencePlot::rowsOf(std::vector<StudyRun> runs, Axes const& axes) const
{
    std::stable_sort(runs.begin(), runs.end(), [&](StudyRun const& a, StudyRun const& b) { return abscissa(a) < abscissa(b); });
    Rows rows;
    for (StudyRun const& run : runs)
    {
        Real const half = std::isfinite(run.spread) ? 0.5 * run.spread : 0;
        Real const low = axes.logY ? std::max(run.error - half, 0.1 * axes.yRange->first) : run.error - half;
        if (!run.failed)
            addRow(rows.done, {abscissa(run), run.error, low, run.error + half, run.spacing});
        else if (abscissa(run) > 0)
            addRow(rows.failed, {abscissa(run), run.error > 0 ? run.error : axes.yRange->second});
    }
    return rows;
}

void ConvergencePlot::draw(PostCase const& postCase) const
{
    auto const path = findTable(postCase.root, file_);
    Location const where{path.string(), 0, {}};
    auto const runs = readStudy(path);
    auto const schemes = schemesOf(runs);
    requireLabelled(labels_, schemes, where);
    Axes const axes = axesFor(runs, where);
    Picture picture(postCase.plots(), name(), axes.width, axes.height, pictures_);
    writeStyle(picture.script());
    axes.write(picture.script());
    picture.script() << "set errorbars small\n";
    PlotItems items;
    for (std::size_t s = 0; s < schemes.size(); ++s)
    {
        std::vector<StudyRun> own;
        std::copy_if(runs.begin(), runs.end(), std::back_inserter(own), [&](StudyRun const& run) { return run.scheme == schemes[s]; });
        Rows const rows = rowsOf(own, axes);
        std::string const colour = " lc rgb '" + automaticColour(s) + "'";
        auto const label = labels_.find(schemes[s]);
        std::string const title = " title " + quoted(label == labels_.end() ? plain(schemes[s]) : label->second);
        std::string const data = rows.done.empty() ? std::string() : picture.addData(rows.done);
        if (!data.empty()) items.add(data + " using 1:2:3:4 with yerrorbars notitle lw 1.2 pt 0" + colour);
        if (!data.empty()) items.add(data + " using 1:2 with linespoints lw 2 pt 7 ps 0.9" + colour + title);
        if (!data.empty() && showSpacing_) items.add(data + spacingLabels);
        if (!rows.failed.empty())
            items.add(picture.addData(rows.failed) + " using 1:2 with points lw 2.5 pt 2 ps 1.4" + colour +
                      (data.empty() ? title : " notitle"));
    }
    bool const anyFailed = std::any_of(runs.begin(), runs.end(), [](StudyRun const& run) { return run.failed; });
    if (anyFailed) items.add("NaN with points lw 2.5 pt 2 ps 1.4 lc rgb '#606060' title 'run failed'");
    picture.script() << items.str();
    render(postCase, picture);
}

} // namespace mpsDem::postGauges
