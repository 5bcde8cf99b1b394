#include "postGauges/ProfilesPlot.h"

#include <algorithm>
#include <cmath>

#include "core/Log.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

constexpr Real mostPoints = 100000;

Axes profileAxes(std::string const& axis)
{
    Axes axes;
    axes.xLabel = axis + " [m]";
    axes.yLabel = "{/Symbol h} [m]";
    axes.height = 320;
    return axes;
}

std::vector<Real> timesOf(std::vector<Real> const& times, std::vector<std::size_t> const& chosen)
{
    std::vector<Real> result;
    for (std::size_t const i : chosen) result.push_back(times[i]);
    return result;
}

} // namespace

ProfilesPlot::ProfilesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : Plot(name),
      times_(dict.getOr("times", std::vector<Real>())),
      distance_(dict.getInRangeOr("spacing", 0, 1e-12, 1e12)),
      axis_(dict.getWordOr("axis", "x", {"x", "y", "z", "distance"}, "axes")),
      panels_(dict.getWordOr("layout", "panels", {"panels", "overlay"}, "layouts") == "panels"),
      bodies_(dict.getOr("bodies", std::vector<std::string>())),
      surface_(SurfaceKeys::read(dict)),
      axes_(Axes::read(dict, profileAxes(axis_))),
      pictures_(pictures),
      where_(dict.where())
{
    if (dict.found("from")) from_ = dict.get<Vector>("from");
    if (dict.found("to")) to_ = dict.get<Vector>("to");
    require(from_.has_value() == to_.has_value(), dict.where(), "from and to must be given both or not at all");
    require(!from_ || (*to_ - *from_).norm() > 0, dict.where("to"), "from and to are one point");
    readReferences(dict);
}

void ProfilesPlot::readReferences(Dictionary const& dict)
{
    CurveStyle points;
    points.kind = "points";
    for (CurveSource& source : readCurveSources(dict, "references", points))
    {
        Real const time = dict.subDict("references").subDict(source.name).get<Real>("time");
        references_.emplace_back(time, std::move(source));
    }
}

std::vector<Vector> ProfilesPlot::line(ParticleFrame const& frame, PostCase const& postCase) const
{
    Vector start = from_.value_or(Vector::Zero()), end = to_.value_or(Vector::Zero());
    if (!from_)
    {
        auto const fluid = frame.fluid();
        require(!fluid.empty(), where_, "there is no fluid to find from and to by");
        auto const less = [](Vector const& a, Vector const& b) { return a.x() < b.x(); };
        auto const [low, high] = std::minmax_element(fluid.begin(), fluid.end(), less);
        start = Vector(low->x(), 0, 0);
        end = Vector(std::max(high->x(), low->x() + postCase.requireSpacing()), 0, 0);
    }
    Real const step = distance_ > 0 ? distance_ : postCase.requireSpacing();
    Real const length = (end - start).norm();
    require(length / step < mostPoints, where_, "the line has more than " + number(mostPoints) + " points", "a larger spacing");
    auto const count = static_cast<std::size_t>(std::max(1.0, std::round(length / step)));
    std::vector<Vector> places;
    for (std::size_t i = 0; i <= count; ++i) places.push_back(start + (end - start) * (static_cast<Real>(i) / static_cast<Real>(count)));
    return places;
}

Real ProfilesPlot::abscissa(Vector const& place, Vector const& start) const
{
    if (axis_ == "distance") return (place - start).norm();
    return place[axis_[0] - 'x'];
}

std::vector<ProfilesPlot::Profile> ProfilesPlot::profiles(PostCase const& postCase) const
{
    Series const series(postCase, surface_.series, where_);
    auto const settings = surface_.settingsFor(postCase);
    auto const times = series.times();
    auto const chosen = chooseTimes(times, postCase.times, times_, where_);
    int const decimals = decimalsThatDiffer(timesOf(times, chosen), 2);
    std::vector<Profile> all;
    for (std::size_t const i : chosen)
    {
        ParticleFrame const frame = series.frame(i);
        auto const places = line(frame, postCase);
        auto const eta = elevations(frame, places, settings, surface_.zero);
        Curve curve{"eta", {{}, eta}, {}, {}};
        std::string table = "# free surface from VTK/" + surface_.series + " at time " + number(frame.time, 10) + " s, zero at " +
                            number(surface_.zero) + " m; nan: no fluid\n# " + axis_ + " eta\n";
        for (std::size_t k = 0; k < places.size(); ++k)
        {
            curve.points.x.push_back(abscissa(places[k], places.front()));
            addRow(table, {curve.points.x[k], eta[k]});
        }
        writeTable(postCase, name() + "_t" + fixedNumber(frame.time, decimals) + ".dat", table);
        all.push_back({frame.time, {curve}});
    }
    return all;
}

void ProfilesPlot::addReferences(PostCase const& postCase, std::vector<Profile>& all) const
{
    auto const written = Series(postCase, surface_.series, where_).times();
    for (auto const& [time, source] : references_)
    {
        Real const nearest = written[nearestTime(written, time, source.table.where)];
        auto const profile = std::find_if(all.begin(), all.end(), [&](Profile const& one) { return one.time == nearest; });
        if (profile == all.end() && postCase.times.given()) continue;
        require(profile != all.end(), source.table.where, "there is no profile at the time of this reference",
                "times (" + number(time) + " ...);");
        for (Curve const& curve : loadCurves({source}, postCase)) profile->curves.push_back(curve);
    }
}

int ProfilesPlot::decimalsOf(std::vector<Profile> const& all)
{
    std::vector<Real> times;
    for (Profile const& profile : all) times.push_back(profile.time);
    return decimalsThatDiffer(times, 2);
}

std::vector<std::string> ProfilesPlot::bodyItems(PostCase const& postCase, Real time, Picture& picture) const
{
    std::vector<std::string> items;
    for (std::string const& body : bodies_)
    {
        auto outlines = bodyOutlines(postCase, body, time, where_);
        for (auto& outline : outlines)
            for (Vector& point : outline) point -= surface_.zero * postCase.up;
        items.push_back(picture.addData(outlineRows(outlines)) +
                        " using 1:2 with filledcurves closed fs solid 1 border lc rgb '#404040' fc rgb '#c8c8c8' notitle");
    }
    return items;
}

void ProfilesPlot::drawPanels(PostCase const& postCase, std::vector<Profile> const& all) const
{
    auto const count = static_cast<int>(all.size());
    require(count <= 20, where_, "there are " + std::to_string(count) + " times, too many panels for one picture",
            "times ( ... ); or layout overlay;");
    Picture picture(postCase.plots(), name(), axes_.width, axes_.height * count, pictures_);
    int const decimals = decimalsOf(all);
    writeStyle(picture.script());
    picture.script() << "set multiplot layout " << count << ",1\n";
    for (Profile const& profile : all)
    {
        Axes axes = axes_;
        axes.title = (axes.title.empty() ? "" : axes.title + ", ") + "t = " + fixedNumber(profile.time, decimals) + " s";
        if (&profile != &all.back()) axes.xLabel.clear();
        if (profile.curves.size() == 1) axes.legend = "none";
        axes.write(picture.script());
        std::vector<Curve> curves = profile.curves;
        curves.front().style.label = "computed";
        drawCurves(curves, picture, bodyItems(postCase, profile.time, picture));
    }
    picture.script() << "unset multiplot\n";
    render(postCase, picture);
}

void ProfilesPlot::drawOverlay(PostCase const& postCase, std::vector<Profile> const& all) const
{
    Picture picture(postCase.plots(), name(), axes_.width, axes_.height, pictures_);
    writeStyle(picture.script());
    axes_.write(picture.script());
    int const decimals = decimalsOf(all);
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        std::size_t const first = curves.size();
        for (Curve curve : all[i].curves)
        {
            if (curve.style.colour == "auto") curve.style.colour = automaticColour(i);
            curves.push_back(curve);
        }
        curves[first].style.label = "t = " + fixedNumber(all[i].time, decimals) + " s";
    }
    drawCurves(curves, picture, bodyItems(postCase, all.back().time, picture));
    render(postCase, picture);
}

void ProfilesPlot::draw(PostCase const& postCase) const
{
    std::vector<Profile> all = profiles(postCase);
    std::erase_if(all, [](Profile const& profile) { return finitePoints(profile.curves.front().points).x.empty(); });
    require(!all.empty(), where_, "there is no fluid above the line at any of the times");
    addReferences(postCase, all);
    if (panels_)
        drawPanels(postCase, all);
    else
        drawOverlay(postCase, all);
}

} // namespace mpsDem::postGauges
