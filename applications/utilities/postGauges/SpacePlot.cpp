#include "postGauges/SpacePlot.h"

#include <algorithm>
#include <cmath>

#include "core/Log.h"
#include "postGauges/Axes.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

SpacePlot::SpacePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures, std::string const& field)
    : Plot(name),
      times_(dict.getOr("times", std::vector<Real>())),
      field_(dict.getOr("field", field)),
      range_(readRange(dict, "range")),
      scale_(dict.getOr("scale", 1.0)),
      label_(dict.getOr("label", fieldLabel(field_))),
      palette_(dict.getWordOr("palette", "viridis", paletteNames(), "palettes")),
      camera_(CameraControls::read(dict.subDictOrEmpty("camera"))),
      walls_(dict.getOr("walls", true)),
      axes_(dict.getOr("axes", true)),
      title_(dict.getOr<std::string>("title", "")),
      contactSheet_(dict.getOr("contactSheet", false)),
      frames_(dict.getOr("frames", false)),
      series_(dict.getOr<std::string>("series", "particles")),
      pictures_(pictures),
      where_(dict.where())
{
    if (!dict.found("formats")) pictures_.formats = {"png"};
    fromZero_ = (field_ == "p" || field_.starts_with("mag")) && scale_ > 0;
    readView(dict);
}

void SpacePlot::readView(Dictionary const& dict)
{
    if (dict.found("bodies")) bodies_ = dict.get<std::vector<std::string>>("bodies");
    width_ = static_cast<int>(dict.getInRangeOr("width", width_, 300, 8000));
    maxHeight_ = static_cast<int>(dict.getInRangeOr("maxHeight", maxHeight_, 200, 8000));
    columns_ = static_cast<int>(dict.getInRangeOr("columns", 0, 0, 12));
    if (dict.found("region"))
    {
        auto const corners = dict.get<std::vector<Vector>>("region");
        bool const fits = corners.size() == 2 && (corners[0].array() < corners[1].array()).all();
        require(fits, dict.where("region"), "region must be two corners, the lower one first", "region ((0 0 0) (4 1 2));");
        region_ = SpaceBox{corners[0], corners[1]};
        for (int d = 0; d < 3; ++d)
        {
            cuts_.push_back({corners[0], -Vector::Unit(d)});
            cuts_.push_back({corners[1], Vector::Unit(d)});
        }
    }
    if (dict.found("clip"))
    {
        Dictionary const clip = dict.subDict("clip");
        auto const normal = clip.get<Vector>("normal");
        require(normal.allFinite() && normal.norm() > 0, clip.where("normal"), "the normal of the clip plane is zero");
        cuts_.push_back({clip.get<Vector>("point"), normal.normalized()});
    }
}

bool SpacePlot::isCutAway(Vector const& r, Real margin) const
{
    return std::any_of(cuts_.begin(), cuts_.end(), [&](CutPlane const& cut) { return (r - cut.point).dot(cut.normal) > margin; });
}

ParticleFrame SpacePlot::frameOf(Series const& series, std::size_t i, Scene const& scene) const
{
    ParticleFrame frame = series.frame(i);
    if (!region_) return frame;
    Real const rim = 4 * scene.spacing;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < frame.type.size(); ++k)
    {
        auto const r = frame.data.position[k].array();
        if ((r >= region_->low.array() - rim).all() && (r <= region_->high.array() + rim).all()) kept.push_back(k);
    }
    auto const keep = [&kept](auto& values) {
        for (std::size_t k = 0; k < kept.size(); ++k) values[k] = values[kept[k]];
        values.resize(kept.size());
    };
    keep(frame.type);
    keep(frame.data.position);
    for (auto& [name, values] : frame.data.scalars) keep(values);
    for (auto& [name, values] : frame.data.vectors) keep(values);
    for (auto& [name, values] : frame.data.integers) keep(values);
    return frame;
}

void SpacePlot::findWalls(Series const& series, Scene& scene) const
{
    // Wall and ghost particles keep their order in all files, those of bodies too: what never moves is wall.
    ParticleFrame const first = series.frame(0), last = series.frame(series.times().size() - 1);
    std::vector<Vector> const before = first.solid(), after = last.solid();
    std::vector<Vector> places;
    std::vector<Real> behind;
    auto const within = [this](Vector const& r, Real margin) {
        return !region_ || ((r.array() >= region_->low.array() - margin).all() && (r.array() <= region_->high.array() + margin).all());
    };
    std::size_t k = 0;
    for (std::size_t i = 0; i < first.type.size(); ++i)
    {
        if (first.type[i] == static_cast<int>(ParticleKind::Fluid)) continue;
        Vector const& r = before[k];
        bool const still = k >= after.size() || (after[k] - r).norm() < 1e-4 * scene.spacing;
        ++k;
        if (!still || !within(r, 4 * scene.spacing)) continue; // the rim of what is cut off is left out below
        bool const ghost = first.type[i] == static_cast<int>(ParticleKind::Ghost);
        places.push_back(r);
        behind.push_back(ghost ? 1 : 0);
        if (ghost || !within(r, 0)) continue;
        scene.box.low = scene.box.low.cwiseMin(r + Vector::Constant(0.5 * scene.spacing));
        scene.box.high = scene.box.high.cwiseMax(r - Vector::Constant(0.5 * scene.spacing));
    }
    if (!walls_ || places.empty()) return;
    WaterSurfaceControls controls;
    controls.spacing = scene.spacing;
    controls.radius = 1.5; // rows are orderly: corners stay sharper than in water
    scene.walls = waterSurface(places, {}, controls);
    // The side towards the fluid is nearest to a wall particle, the outer one to ghosts.
    KernelMean const mean(places, 1.3 * scene.spacing);
    std::vector<Real> const outer = mean.at(scene.walls.points, behind);
    std::erase_if(scene.walls.triangles, [&](auto const& triangle) {
        Real sum = 0;
        bool cut = false;
        for (int const i : triangle)
        {
            sum += outer[static_cast<std::size_t>(i)];
            cut = cut || !within(scene.walls.points[static_cast<std::size_t>(i)], 0);
        }
        return cut || sum > 1.5;
    });
}

void SpacePlot::growBox(PostCase const& postCase, ParticleFrame const& frame, Scene& scene) const
{
    auto const take = [&scene](Vector const& r) {
        scene.box.low = scene.box.low.cwiseMin(r);
        scene.box.high = scene.box.high.cwiseMax(r);
    };
    if (scene.box.low.x() > scene.box.high.x()) // no walls
        for (Vector const& r : frame.fluid())
            for (Real const side : {-0.5, 0.5})
                if (!isCutAway(r)) take(r + Vector::Constant(side * scene.spacing));
    for (std::string const& body : scene.bodies)
        for (auto const& outline : bodyOutlines(postCase, body, frame.time, where_))
            for (Vector const& r : outline)
                if (!region_) take(r);
    bool const some = (scene.box.low.array() < scene.box.high.array()).all();
    require(some, where_, "there is nothing to show in " + frame.file, "a larger region, or none");
}

SpacePlot::Scene SpacePlot::sceneOf(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen) const
{
    require(postCase.dimensions == 3, where_, "a picture of space needs a case of three dimensions",
            "type particles; without view, or dimensions 3; in constant/particleProperties");
    Scene scene;
    scene.spacing = postCase.requireSpacing();
    scene.up = postCase.up;
    scene.box = {Vector::Constant(1e300), Vector::Constant(-1e300)};
    scene.bodies = bodies_ ? *bodies_ : seriesNames(postCase);
    if (!bodies_) std::erase(scene.bodies, series_);
    findWalls(series, scene);
    growBox(postCase, frameOf(series, chosen.front(), scene), scene);
    scene.bar.palette = palette_;
    scene.bar.label = label_;
    RangeFinder finder;
    for (std::size_t const i : chosen)
        if (coloured()) finder.add(colouredValues(frameOf(series, i, scene), scene));
    require(range_ || !coloured() || !finder.empty(), where_, "there is no fluid to colour at these times");
    if (coloured() && !categorical()) finder.set(scene.bar, range_, fromZero_);
    std::vector<Real> times;
    for (std::size_t const i : chosen) times.push_back(series.times()[i]);
    scene.decimals = decimalsThatDiffer(times, 2);
    return scene;
}

void SpacePlot::draw(PostCase const& postCase) const
{
    Series const series(postCase, series_, where_);
    auto const times = series.times();
    auto const chosen = chooseTimes(times, postCase.times, times_, where_);
    require(!contactSheet_ || chosen.size() <= 36, where_, "there are " + std::to_string(chosen.size()) + " times, too many for one sheet",
            "at most 36: times ( ... );");
    Scene const scene = sceneOf(postCase, series, chosen);
    if (contactSheet_) drawSheet(postCase, series, chosen, scene, name());
    for (std::size_t k = 0; k < chosen.size() && !contactSheet_; ++k)
        drawSheet(postCase, series, {chosen[k]}, scene,
                  frames_ ? frameName(name(), k) : name() + "_t" + fixedNumber(times[chosen[k]], scene.decimals));
}

} // namespace mpsDem::postGauges
