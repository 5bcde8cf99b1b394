#include "postGauges/CurvesPlot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/Log.h"
#include "postGauges/SheetLayout.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

CurvesPlot::CurvesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : Plot(name),
      axes_(Axes::read(dict, {})),
      sources_(readCurveSources(dict, "curves")),
      pictures_(pictures)
{
    require(!sources_.empty(), dict.where("curves"), "the plot has no curves", "curves { <name> { file \"table.csv\"; x 1; y 2; } }");
    if (dict.found("compare")) readComparison(dict.subDict("compare"));
}

void CurvesPlot::readComparison(Dictionary const& dict)
{
    std::vector<std::string> names;
    for (CurveSource const& source : sources_) names.push_back(source.name);
    Comparison asked;
    asked.where = dict.where();
    asked.reference = dict.getWord("reference", names, "curves");
    std::vector<std::string> others = names;
    std::erase(others, asked.reference);
    asked.curves = dict.getOr("curves", others);
    for (std::string const& curve : asked.curves)
        require(std::find(others.begin(), others.end(), curve) != others.end(), dict.where("curves"),
                "\"" + curve + "\" is no curve that can be compared", knownWords("curves", curve, others));
    constexpr Real unbounded = std::numeric_limits<Real>::max();
    asked.from = dict.getOr("from", -unbounded);
    asked.to = dict.getOr("to", unbounded);
    require(asked.from < asked.to, dict.where("to"), "to must be greater than from");
    asked.crest = dict.getOr("crest", true);
    if (dict.found("crestProminence")) asked.prominence = dict.getInRange("crestProminence", 0, 1e300);
    comparison_ = asked;
}

namespace {

/// From zero beyond the value that all points have; nothing where they differ.
std::optional<std::pair<Real, Real>> rangeOfLevel(std::vector<Curve> const& curves)
{
    std::vector<Real> values;
    for (Curve const& curve : curves)
    {
        auto const finite = finitePoints(curve.points).y;
        values.insert(values.end(), finite.begin(), finite.end());
        values.insert(values.end(), curve.upper.begin(), curve.upper.end());
    }
    if (values.empty() || std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end()) return std::nullopt;
    Real const twice = 2 * values.front();
    return twice == 0 ? std::pair(-1.0, 1.0) : niceRange(std::min(0.0, twice), std::max(0.0, twice));
}

} // namespace

void CurvesPlot::draw(PostCase const& postCase) const
{
    std::vector<Curve> const curves = loadCurves(sources_, postCase);
    if (curves.empty()) throw CaseError(ExitCode::InputOutput, sources_.front().table.where, "none of the files of the plot is there");
    Axes axes = axes_;
    if (!axes.yRange && !axes.logY) axes.yRange = rangeOfLevel(curves);
    Picture picture(postCase.plots(), name(), axes.width, axes.height, pictures_);
    writeStyle(picture.script());
    axes.write(picture.script());
    drawCurves(curves, picture);
    render(postCase, picture);
    if (comparison_) compare(postCase, curves);
}

namespace {

/// The curve of that name; null where it was left out.
Curve const* curveOf(std::vector<Curve> const& curves, std::string const& name)
{
    auto const found = std::find_if(curves.begin(), curves.end(), [&](Curve const& curve) { return curve.name == name; });
    return found == curves.end() ? nullptr : &*found;
}

/// Part of the curve between two x.
Points cut(Points const& points, Real from, Real to)
{
    Points part;
    for (std::size_t i = 0; i < points.x.size(); ++i)
    {
        if (points.x[i] < from || points.x[i] > to) continue;
        part.x.push_back(points.x[i]);
        part.y.push_back(points.y[i]);
    }
    return part;
}

std::string extent(Points const& points)
{
    Points const finite = finitePoints(points);
    return finite.x.empty() ? "empty" : number(finite.x.front()) + " to " + number(finite.x.back());
}

/// "rms 0.012 (3.4 % of the reference's range), ..." for the log.
void logDifference(std::string const& name, std::string const& reference, Difference const& difference)
{
    auto const percent = [&](Real value) {
        return difference.referenceRange > 0 ? " (" + number(100 * value / difference.referenceRange, 3) + " %)" : std::string();
    };
    info() << "    " << name << " against " << reference << ": rms " << number(difference.rms, 4) << percent(difference.rms) << ", max "
           << number(difference.maximum, 4) << percent(difference.maximum) << " at x = " << number(difference.at, 4) << ", "
           << difference.points << " points; % of the reference's range " << number(difference.referenceRange, 4) << '\n';
}

constexpr Real noCrests = std::numeric_limits<Real>::infinity(); ///< A prominence that no crest has.
constexpr Crest noCrest = {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::quiet_NaN()};

void logCrests(std::string const& name, Crest const& crest, Crest const& expected)
{
    Real const deltaX = crest.x - expected.x, deltaY = crest.y - expected.y;
    if (!std::isfinite(deltaX)) return;
    info() << "    first crest of " << name << ": x = " << number(crest.x, 4) << " (" << number(deltaX, 3)
           << " from the reference), y = " << number(crest.y, 4) << " (" << number(deltaY, 3) << ")\n";
}

} // namespace

void CurvesPlot::compare(PostCase const& postCase, std::vector<Curve> const& curves) const
{
    Comparison const& asked = *comparison_;
    Curve const* const truth = curveOf(curves, asked.reference);
    if (!truth)
    {
        warn("nothing is compared in " + name() + ": the curve \"" + asked.reference + "\" is not there");
        return;
    }
    Points const& reference = truth->points;
    std::string table = "# differences from the curve " + asked.reference + "; crest: first crest, curve minus reference, nan: none\n";
    for (std::size_t i = 0; i < asked.curves.size(); ++i) table += "# curve " + std::to_string(i) + ": " + asked.curves[i] + '\n';
    table += "# curve rms max xOfMax referenceRange points crestX crestY crestDeltaX crestDeltaY\n";
    for (std::size_t i = 0; i < asked.curves.size(); ++i)
    {
        Curve const* const curve = curveOf(curves, asked.curves[i]);
        if (!curve) continue;
        Points const& points = curve->points;
        require(increases(finitePoints(points)), asked.where, "x of \"" + asked.curves[i] + "\" does not increase: it cannot be compared");
        auto const difference = compareCurves(points, reference, asked.from, asked.to);
        require(difference.has_value(), asked.where, "\"" + asked.curves[i] + "\" and \"" + asked.reference + "\" have no x in common",
                asked.curves[i] + ": " + extent(points) + ", " + asked.reference + ": " + extent(reference));
        logDifference(asked.curves[i], asked.reference, *difference);
        Real const prominence = asked.crest ? asked.prominence.value_or(0.1 * difference->referenceRange) : noCrests;
        Crest const crest = firstCrest(cut(points, asked.from, asked.to), prominence).value_or(noCrest);
        Crest const expected = firstCrest(cut(reference, asked.from, asked.to), prominence).value_or(noCrest);
        logCrests(asked.curves[i], crest, expected);
        addRow(table, {static_cast<Real>(i), difference->rms, difference->maximum, difference->at, difference->referenceRange,
                       static_cast<Real>(difference->points), crest.x, crest.y, crest.x - expected.x, crest.y - expected.y});
    }
    writeTable(postCase, name() + "_errors.dat", table);
}

} // namespace mpsDem::postGauges
