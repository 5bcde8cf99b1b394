#include "postGauges/WaterSurfacePlot.h"

#include <algorithm>
#include <filesystem>

#include "io/VtkFile.h"
#include "postGauges/ParticleColours.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace fs = std::filesystem;

namespace {

constexpr Colour waterBlue = {0.25F, 0.53F, 0.76F};
constexpr Colour plainWater = {0.62F, 0.77F, 0.90F}; ///< Of faces at walls and cuts, whose elevation says nothing of waves.
constexpr Real meanRadius = 2;                       ///< Of the values on the surface [spacings].
constexpr Real wallShare = 0.2;                      ///< Of walls and bodies among the particles near a face, above which it lies at one.
constexpr std::pair<Real, Real> tilt{0.5, 0.85};     ///< Upward part of its normal: plain below, coloured above.

Colour mixed(Colour const& a, Colour const& b, Real share)
{
    Colour result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<float>(a[c] + share * (static_cast<Real>(b[c]) - a[c]));
    return result;
}

/// Share of walls and bodies among the particles near places.
std::vector<Real> solidShare(ParticleFrame const& frame, std::vector<Vector> const& places, Real spacing)
{
    std::vector<Real> solid;
    for (int const type : frame.type) solid.push_back(type == static_cast<int>(ParticleKind::Fluid) ? 0 : 1);
    return KernelMean(frame.data.position, meanRadius * spacing).at(places, solid);
}

/// Adds a file to a series, in the order of time; entries of files that are gone are left out.
void addToSeries(fs::path const& path, SeriesEntry const& added)
{
    std::error_code ignored;
    std::vector<SeriesEntry> entries{added};
    if (fs::is_regular_file(path, ignored))
        for (SeriesEntry const& entry : readSeries(path))
            if (entry.file.filename() != added.file.filename() && fs::is_regular_file(entry.file, ignored)) entries.push_back(entry);
    std::sort(entries.begin(), entries.end(), [](SeriesEntry const& a, SeriesEntry const& b) { return a.time < b.time; });
    writeSeries(path, entries);
}

} // namespace

WaterSurfacePlot::WaterSurfacePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : SpacePlot(name, dict, pictures, "elevation"),
      zero_(dict.getOr("zero", 0.0)),
      opacity_(dict.getInRangeOr("opacity", 0.75, 0.05, 1)),
      absorption_(dict.getInRangeOr("absorption", 0, 0, 1e6)),
      resolution_(dict.getInRangeOr("resolution", 2, 1, 6)),
      smoothing_(static_cast<int>(dict.getInRangeOr("smoothing", 20, 0, 200))),
      drops_(dict.getOr("drops", true)),
      writeSurface_(dict.getOr("writeSurface", true))
{}

WaterSurfaceControls WaterSurfacePlot::controlsFor(Scene const& scene) const
{
    WaterSurfaceControls controls;
    controls.spacing = scene.spacing;
    controls.resolution = resolution_;
    controls.smoothing = smoothing_;
    controls.cuts = cuts();
    return controls;
}

std::vector<Real> WaterSurfacePlot::fluidValues(ParticleFrame const& frame, std::string const& field, Scene const& scene) const
{
    std::vector<Real> const all = field == "elevation" ? std::vector<Real>() : frame.field(field, where());
    std::vector<Real> values;
    for (std::size_t i = 0; i < frame.type.size(); ++i)
        if (frame.type[i] == static_cast<int>(ParticleKind::Fluid))
            values.push_back(all.empty() ? frame.data.position[i].dot(scene.up) - zero_ : all[i]);
    return values;
}

std::vector<Real> WaterSurfacePlot::colouredValues(ParticleFrame const& frame, Scene const& scene) const
{
    std::vector<Real> const all = fluidValues(frame, field(), scene);
    auto const flags = frame.data.integers.find("surface");
    bool const flagged = flags != frame.data.integers.end(), elevation = field() == "elevation";
    auto const walls = elevation ? solidShare(frame, frame.data.position, scene.spacing) : std::vector<Real>(frame.type.size(), 0);
    Real const rise = elevation ? 0.5 * scene.spacing : 0; // from the centre of a particle to the surface
    std::vector<Real> values, others; // the latter, below the surface or among walls, only where there are no better ones
    std::size_t k = 0;
    for (std::size_t i = 0; i < frame.type.size(); ++i)
    {
        if (frame.type[i] != static_cast<int>(ParticleKind::Fluid)) continue;
        std::int64_t const flag = flagged ? flags->second[i] : 1;
        bool const free = !elevation || (flag == 1 && walls[i] < 0.5);
        if (flag != 0 && !isCutAway(frame.data.position[i])) (free ? values : others).push_back(scale() * (all[k] + rise));
        ++k;
    }
    return values.empty() ? others : values;
}

void WaterSurfacePlot::drawDrops(ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const
{
    std::vector<Vector> const fluid = frame.fluid();
    std::vector<Real> const share = filledShare(fluid, frame.solid(), controlsFor(scene));
    std::vector<Real> const walls = solidShare(frame, fluid, scene.spacing);
    std::vector<Real> const values = coloured() ? fluidValues(frame, field(), scene) : std::vector<Real>();
    for (std::size_t i = 0; i < fluid.size(); ++i)
    {
        if (share[i] >= 0.5 || isCutAway(fluid[i])) continue;
        Colour colour = coloured() ? scene.bar.colour(scale() * values[i]) : waterBlue;
        if (field() == "elevation" && walls[i] > wallShare) colour = plainWater;
        image.addSphere(fluid[i], 0.4 * scene.spacing, colour);
    }
}

std::vector<Colour> WaterSurfacePlot::elevationColours(ParticleFrame const& frame, Scene const& scene, SurfaceMesh const& mesh) const
{
    std::vector<Real> const walls = solidShare(frame, mesh.points, scene.spacing);
    std::vector<Colour> colours;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
        Colour const colour = scene.bar.colour(scale() * (mesh.points[i].dot(scene.up) - zero_));
        bool const aside = walls[i] > wallShare || isCutAway(mesh.points[i], -scene.spacing);
        Real const level = (mesh.normals[i].dot(scene.up) - tilt.first) / (tilt.second - tilt.first);
        colours.push_back(aside ? mixed(plainWater, colour, std::clamp(level, 0.0, 1.0)) : colour);
    }
    return colours;
}

void WaterSurfacePlot::drawFluid(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const
{
    std::vector<Vector> const fluid = frame.fluid();
    SurfaceMesh const mesh = waterSurface(fluid, frame.solid(), controlsFor(scene));
    std::vector<Colour> colours{waterBlue};
    if (field() == "elevation")
        colours = elevationColours(frame, scene, mesh);
    else if (coloured())
    {
        colours.clear();
        for (Real const value : KernelMean(fluid, meanRadius * scene.spacing).at(mesh.points, fluidValues(frame, field(), scene)))
            colours.push_back(scene.bar.colour(scale() * value));
    }
    if (drops_) drawDrops(frame, scene, image);
    Real const absorption = absorption_ > 0 ? absorption_ : 1 / (scene.box.high - scene.box.low).minCoeff();
    if (!mesh.triangles.empty()) image.addWater({mesh.points, mesh.normals, mesh.triangles, colours}, {opacity_, absorption});
    if (writeSurface_) write(postCase, frame, scene, mesh);
}

void WaterSurfacePlot::write(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene, SurfaceMesh const& mesh) const
{
    std::vector<Vector> const fluid = frame.fluid();
    KernelMean const mean(fluid, meanRadius * scene.spacing);
    TriangleCells cells;
    cells.points = mesh.points;
    cells.normals = mesh.normals;
    cells.triangles = mesh.triangles;
    std::vector<Real> elevation;
    for (Vector const& r : mesh.points) elevation.push_back(r.dot(scene.up) - zero_);
    cells.scalars.emplace_back("elevation", elevation);
    std::vector<Real> pressure;
    if (frame.data.scalars.count("p") != 0) pressure = mean.at(mesh.points, fluidValues(frame, "p", scene));
    if (!pressure.empty()) cells.scalars.emplace_back("p", pressure);
    std::vector<Vector> velocity;
    if (auto const found = frame.data.vectors.find("U"); found != frame.data.vectors.end())
    {
        std::vector<Vector> own;
        for (std::size_t i = 0; i < frame.type.size(); ++i)
            if (frame.type[i] == static_cast<int>(ParticleKind::Fluid)) own.push_back(found->second[i]);
        velocity = mean.at(mesh.points, own);
        cells.vectors.emplace_back("U", velocity);
    }
    fs::path const file = postCase.surfaces() / name() / (name() + "_" + number(frame.time) + ".vtp");
    writeTriangles(file, cells, frame.time);
    addToSeries(postCase.surfaces() / (name() + ".vtp.series"), {frame.time, file});
}

} // namespace mpsDem::postGauges
