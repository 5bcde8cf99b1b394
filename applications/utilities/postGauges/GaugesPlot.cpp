#include "postGauges/GaugesPlot.h"

#include <limits>

#include "core/Log.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

SurfaceKeys SurfaceKeys::read(Dictionary const& dict)
{
    SurfaceKeys keys;
    bool const volume = dict.getWordOr("method", "volume", {"volume", "top"}, "methods") == "volume";
    keys.settings.method = volume ? SurfaceMethod::Volume : SurfaceMethod::Top;
    keys.settings.width = dict.getInRangeOr("width", keys.settings.width, 1, 20);
    keys.settings.splash = static_cast<int>(dict.getInRangeOr("splash", keys.settings.splash, 1, 1e6));
    keys.zero = dict.getOr("zero", 0.0);
    keys.series = dict.getOr<std::string>("series", "particles");
    return keys;
}

SurfaceSettings SurfaceKeys::settingsFor(PostCase const& postCase) const
{
    SurfaceSettings complete = settings;
    complete.spacing = postCase.requireSpacing();
    complete.dimensions = postCase.dimensions;
    complete.up = postCase.up;
    return complete;
}

std::vector<Real> elevations(ParticleFrame const& frame, std::vector<Vector> const& locations, SurfaceSettings const& settings, Real zero)
{
    FreeSurface const surface(frame.fluid(), frame.solid(), settings);
    std::vector<Real> eta;
    for (Vector const& location : locations)
    {
        auto const height = surface.elevation(location);
        eta.push_back(height ? *height - zero : std::numeric_limits<Real>::quiet_NaN());
    }
    return eta;
}

namespace {

Axes gaugeAxes()
{
    Axes axes;
    axes.xLabel = "t [s]";
    axes.yLabel = "{/Symbol h} [m]";
    return axes;
}

std::string placeText(Vector const& location)
{
    return "(" + number(location.x()) + " " + number(location.y()) + " " + number(location.z()) + ")";
}

} // namespace

GaugesPlot::GaugesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : Plot(name),
      locations_(dict.get<std::vector<Vector>>("locations")),
      surface_(SurfaceKeys::read(dict)),
      axes_(Axes::read(dict, gaugeAxes())),
      pictures_(pictures),
      where_(dict.where())
{
    require(!locations_.empty(), dict.where("locations"), "there is no location", "locations ((4 0 0));");
    CurveStyle points;
    points.kind = "points";
    references_ = readCurveSources(dict, "references", points);
}

void GaugesPlot::draw(PostCase const& postCase) const
{
    Series const series(postCase, surface_.series, where_);
    auto const settings = surface_.settingsFor(postCase);
    std::string table =
        "# free-surface elevation from VTK/" + surface_.series + ", zero at " + number(surface_.zero) + " m; nan: no fluid\n";
    std::string names = "# Time";
    for (std::size_t k = 0; k < locations_.size(); ++k)
    {
        table += "# eta" + std::to_string(k) + ": " + placeText(locations_[k]) + '\n';
        names += " eta" + std::to_string(k);
    }
    table += names + '\n';
    std::vector<Real> times;
    std::vector<std::vector<Real>> eta(locations_.size());
    for (std::size_t const i : chooseTimes(series.times(), postCase.times, {}, where_))
    {
        ParticleFrame const frame = series.frame(i);
        std::vector<Real> row = elevations(frame, locations_, settings, surface_.zero);
        for (std::size_t k = 0; k < row.size(); ++k) eta[k].push_back(row[k]);
        times.push_back(frame.time);
        row.insert(row.begin(), frame.time);
        addRow(table, row);
    }
    writeTable(postCase, name() + ".dat", table);
    drawPicture(postCase, times, eta);
}

void GaugesPlot::drawPicture(PostCase const& postCase, std::vector<Real> const& times, std::vector<std::vector<Real>> const& eta) const
{
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < eta.size(); ++k)
    {
        Curve curve{"eta" + std::to_string(k), {times, eta[k]}, {}, {}};
        curve.style.label = (postCase.dimensions == 2) ? "x = " + number(locations_[k].x()) + " m" : placeText(locations_[k]);
        if (finitePoints(curve.points).x.empty())
            warn("gauge " + placeText(locations_[k]) + " never meets fluid: it is not drawn");
        else
            curves.push_back(curve);
    }
    for (Curve const& reference : loadCurves(references_, postCase)) curves.push_back(reference);
    if (curves.empty()) return;
    Picture picture(postCase.plots(), name(), axes_.width, axes_.height, pictures_);
    writeStyle(picture.script());
    axes_.write(picture.script());
    drawCurves(curves, picture);
    render(postCase, picture);
}

} // namespace mpsDem::postGauges
