#include "postGauges/ParticlesPlot.h"

#include <algorithm>
#include <cmath>

#include "core/Log.h"
#include "postGauges/Axes.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

ParticlesPlot::ParticlesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : Plot(name),
      times_(dict.getOr("times", std::vector<Real>())),
      field_(dict.getOr<std::string>("field", "p")),
      series_(dict.getOr<std::string>("series", "particles")),
      pictures_(pictures),
      where_(dict.where())
{
    if (!dict.found("formats")) pictures_.formats = {"png"};
    readLook(dict);
    readView(dict);
}

void ParticlesPlot::readLook(Dictionary const& dict)
{
    range_ = readRange(dict, "range");
    colourWalls_ = dict.getOr("colourWalls", false);
    bodyStyle_ = dict.getWordOr("bodyStyle", "outline", {"outline", "filled", "none"}, "body styles");
    palette_ = dict.getWordOr("palette", "viridis", paletteNames(), "palettes");
    label_ = dict.getOr("label", fieldLabel(field_));
    scale_ = dict.getOr("scale", 1.0);
    discSize_ = dict.getInRangeOr("discSize", categorical() ? 1 : 1.42, 0.1, 5);
    title_ = dict.getOr<std::string>("title", "");
}

void ParticlesPlot::readView(Dictionary const& dict)
{
    auto const standard = field_ == "type" ? std::vector<std::string>{"fluid", "wall", "ghost"} : std::vector<std::string>{"fluid", "wall"};
    for (std::string const& kind : readKinds(dict, standard))
    {
        showFluid_ = showFluid_ || kind == "fluid";
        showWall_ = showWall_ || kind == "wall";
        showGhost_ = showGhost_ || kind == "ghost";
    }
    slice_ = Slice::read(dict);
    if (dict.found("window"))
    {
        auto const corners = dict.get<std::vector<Vector>>("window");
        bool const fits = corners.size() == 2 && corners[0].x() < corners[1].x() && corners[0].y() < corners[1].y();
        require(fits, dict.where("window"), "window must be two corners, the lower left one first", "window ((0 0 0) (4 1.5 0));");
        window_ = Window{corners[0].x(), corners[1].x(), corners[0].y(), corners[1].y()};
    }
    if (dict.found("bodies")) bodies_ = dict.get<std::vector<std::string>>("bodies");
    width_ = static_cast<int>(dict.getInRangeOr("width", width_, 300, 8000));
    maxHeight_ = static_cast<int>(dict.getInRangeOr("maxHeight", maxHeight_, 200, 8000));
    frames_ = dict.getOr("frames", false);
    contactSheet_ = dict.getOr("contactSheet", false);
    columns_ = static_cast<int>(dict.getInRangeOr("columns", 0, 0, 12));
}

bool ParticlesPlot::shows(ParticleFrame const& frame, std::size_t i) const
{
    auto const kind = static_cast<ParticleKind>(frame.type[i]);
    bool const wall = kind == ParticleKind::Wall || kind == ParticleKind::DryWall;
    return (showFluid_ && kind == ParticleKind::Fluid) || (showWall_ && wall) || (showGhost_ && kind == ParticleKind::Ghost);
}

bool ParticlesPlot::coloured(int type) const { return type == static_cast<int>(ParticleKind::Fluid) || colourWalls_ || field_ == "type"; }

Window ParticlesPlot::windowOf(ParticleFrame const& frame, Scene const& scene) const
{
    Window box{1e300, -1e300, 1e300, -1e300};
    for (std::size_t const i : scene.slice.particles(frame))
    {
        if (!shows(frame, i)) continue;
        Vector const place = scene.slice.place(frame.data.position[i]);
        box = {std::min(box.xLow, place.x()), std::max(box.xHigh, place.x()), std::min(box.yLow, place.y()),
               std::max(box.yHigh, place.y())};
    }
    require(box.xLow <= box.xHigh, where_, "there is no particle to show in " + frame.file, "show (fluid wall ghost);");
    Real const spacing = scene.spacing;
    return {box.xLow - 2 * spacing, box.xHigh + 2 * spacing, box.yLow - 2 * spacing, box.yHigh + 3 * spacing};
}

void ParticlesPlot::setRange(Series const& series, std::vector<std::size_t> const& chosen, Scene& scene) const
{
    RangeFinder finder;
    for (std::size_t const index : chosen)
    {
        ParticleFrame const frame = series.frame(index);
        auto const all = frame.field(field_, where_);
        std::vector<Real> values;
        for (std::size_t const i : scene.slice.particles(frame))
            if (shows(frame, i) && coloured(frame.type[i])) values.push_back(scale_ * all[i]);
        finder.add(values);
    }
    require(range_ || !finder.empty(), where_, "no particle that is shown has a colour", "show (fluid ...); or colourWalls true;");
    bool const magnitude = field_ == "p" || field_.starts_with("mag");
    scene.bar.palette = palette_;
    scene.bar.label = label_;
    finder.set(scene.bar, range_, magnitude && scale_ > 0);
}

ParticlesPlot::Scene ParticlesPlot::sceneOf(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen) const
{
    Scene scene;
    scene.spacing = postCase.requireSpacing();
    ParticleFrame const first = series.frame(chosen.front());
    scene.slice = slice_.completed(postCase, first);
    scene.window = window_ ? *window_ : windowOf(first, scene);
    if (!categorical()) setRange(series, chosen, scene);
    scene.bodies = bodies_ ? *bodies_ : seriesNames(postCase);
    if (!bodies_) std::erase(scene.bodies, series_);
    if (bodyStyle_ == "none") scene.bodies.clear();
    std::vector<Real> times;
    for (std::size_t const i : chosen) times.push_back(series.times()[i]);
    scene.decimals = decimalsThatDiffer(times, 2);
    return scene;
}

void ParticlesPlot::draw(PostCase const& postCase) const
{
    Series const series(postCase, series_, where_);
    auto const times = series.times();
    auto const chosen = chooseTimes(times, postCase.times, times_, where_);
    Scene const scene = sceneOf(postCase, series, chosen);
    if (contactSheet_)
    {
        require(chosen.size() <= 36, where_, "there are " + std::to_string(chosen.size()) + " times, too many for one sheet",
                "at most 36: times ( ... );");
        drawSheet(postCase, series, chosen, scene, name());
        return;
    }
    for (std::size_t k = 0; k < chosen.size(); ++k)
        drawSheet(postCase, series, {chosen[k]}, scene,
                  frames_ ? frameName(name(), k) : name() + "_t" + fixedNumber(times[chosen[k]], scene.decimals));
}

} // namespace mpsDem::postGauges
