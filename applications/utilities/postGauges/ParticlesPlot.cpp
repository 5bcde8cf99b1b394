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
    static std::vector<std::string> const kinds = {"fluid", "wall", "ghost"};
    auto const standard = field_ == "type" ? kinds : std::vector<std::string>{"fluid", "wall"};
    for (std::string const& kind : dict.getOr("show", standard))
    {
        require(std::find(kinds.begin(), kinds.end(), kind) != kinds.end(), dict.where("show"), "show: \"" + kind + "\" is not known",
                knownWords("kinds of particles", kind, kinds));
        showFluid_ = showFluid_ || kind == "fluid";
        showWall_ = showWall_ || kind == "wall";
        showGhost_ = showGhost_ || kind == "ghost";
    }
    slice_ = readRange(dict, "slice");
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
    contactSheet_ = dict.getOr("contactSheet", false);
    columns_ = static_cast<int>(dict.getInRangeOr("columns", 0, 0, 12));
}

bool ParticlesPlot::shows(ParticleFrame const& frame, std::size_t i) const
{
    Real const z = frame.data.position[i].z();
    bool const inSlice = !slice_ || (z >= slice_->first && z <= slice_->second);
    auto const kind = static_cast<ParticleKind>(frame.type[i]);
    bool const wall = kind == ParticleKind::Wall || kind == ParticleKind::DryWall;
    return inSlice && ((showFluid_ && kind == ParticleKind::Fluid) || (showWall_ && wall) || (showGhost_ && kind == ParticleKind::Ghost));
}

bool ParticlesPlot::coloured(int type) const { return type == static_cast<int>(ParticleKind::Fluid) || colourWalls_ || field_ == "type"; }

Window ParticlesPlot::windowOf(ParticleFrame const& frame, Real spacing) const
{
    Window box{1e300, -1e300, 1e300, -1e300};
    for (std::size_t i = 0; i < frame.type.size(); ++i)
    {
        if (!shows(frame, i)) continue;
        Vector const& place = frame.data.position[i];
        box = {std::min(box.xLow, place.x()), std::max(box.xHigh, place.x()), std::min(box.yLow, place.y()),
               std::max(box.yHigh, place.y())};
    }
    require(box.xLow <= box.xHigh, where_, "there is no particle to show in " + frame.file, "show (fluid wall ghost);");
    return {box.xLow - 2 * spacing, box.xHigh + 2 * spacing, box.yLow - 2 * spacing, box.yHigh + 3 * spacing};
}

void ParticlesPlot::setRange(Series const& series, std::vector<std::size_t> const& chosen, Scene& scene) const
{
    constexpr Real cut = 0.002, beyond = 0.01;
    constexpr Real unset = 1e300;
    Real low = unset, high = -unset, lowest = unset, highest = -unset;
    for (std::size_t const index : chosen)
    {
        ParticleFrame const frame = series.frame(index);
        auto const all = frame.field(field_, where_);
        std::vector<Real> values;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (shows(frame, i) && coloured(frame.type[i])) values.push_back(scale_ * all[i]);
        if (values.empty()) continue;
        low = std::min(low, percentile(values, cut));
        high = std::max(high, percentile(values, 1 - cut));
        lowest = std::min(lowest, *std::min_element(values.begin(), values.end()));
        highest = std::max(highest, *std::max_element(values.begin(), values.end()));
    }
    require(range_ || low <= high, where_, "no particle that is shown has a colour", "show (fluid ...); or colourWalls true;");
    if (palette_ == "coolWarm") low = -(high = std::max(std::abs(low), std::abs(high)));
    bool const magnitude = field_ == "p" || field_.starts_with("mag");
    scene.range = range_ ? *range_ : niceRange(magnitude && scale_ > 0 ? std::min(0.0, low) : low, high);
    Real const tolerance = beyond * (scene.range.second - scene.range.first);
    scene.below = lowest < scene.range.first - tolerance;
    scene.above = highest > scene.range.second + tolerance;
}

ParticlesPlot::Scene ParticlesPlot::sceneOf(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen) const
{
    Scene scene;
    scene.spacing = postCase.requireSpacing();
    scene.window = window_ ? *window_ : windowOf(series.frame(chosen.front()), scene.spacing);
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
    for (std::size_t const i : chosen) drawSheet(postCase, series, {i}, scene, name() + "_t" + fixedNumber(times[i], scene.decimals));
}

} // namespace mpsDem::postGauges
