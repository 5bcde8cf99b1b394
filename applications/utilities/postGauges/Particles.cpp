#include "postGauges/Particles.h"

#include <algorithm>

#include "io/VtkFile.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace fs = std::filesystem;

namespace {

constexpr char const* seriesEnding = ".vtp.series";

/// Component of a name like "Ux": 0, 1, 2, or -1.
int componentOf(std::string const& name)
{
    static std::string const letters = "xyz";
    std::size_t const place = name.empty() ? std::string::npos : letters.find(name.back());
    return place == std::string::npos ? -1 : static_cast<int>(place);
}

std::vector<std::string> fieldNames(PointCloudData const& data)
{
    std::vector<std::string> names;
    for (auto const& [name, values] : data.scalars) names.push_back(name);
    for (auto const& [name, values] : data.integers) names.push_back(name);
    for (auto const& [name, values] : data.vectors)
        for (std::string const& field : {"mag" + name, name + "x", name + "y", name + "z"}) names.push_back(field);
    return names;
}

std::vector<Vector> pick(ParticleFrame const& frame, bool fluid)
{
    std::vector<Vector> picked;
    for (std::size_t i = 0; i < frame.type.size(); ++i)
        if ((frame.type[i] == static_cast<int>(ParticleKind::Fluid)) == fluid) picked.push_back(frame.data.position[i]);
    return picked;
}

} // namespace

std::vector<Vector> ParticleFrame::fluid() const { return pick(*this, true); }

std::vector<Vector> ParticleFrame::solid() const { return pick(*this, false); }

std::vector<Real> ParticleFrame::field(std::string const& name, Location const& where) const
{
    if (auto const found = data.scalars.find(name); found != data.scalars.end()) return found->second;
    if (auto const found = data.integers.find(name); found != data.integers.end()) return {found->second.begin(), found->second.end()};
    std::vector<Real> values;
    auto const whole = name.starts_with("mag") ? data.vectors.find(name.substr(3)) : data.vectors.end();
    if (whole != data.vectors.end())
    {
        for (Vector const& value : whole->second) values.push_back(value.norm());
        return values;
    }
    int const component = componentOf(name);
    auto const part = component >= 0 ? data.vectors.find(name.substr(0, name.size() - 1)) : data.vectors.end();
    require(part != data.vectors.end(), where, "there is no field \"" + name + "\" in " + file,
            knownWords("fields", name, fieldNames(data)));
    for (Vector const& value : part->second) values.push_back(value[component]);
    return values;
}

std::vector<std::string> readKinds(Dictionary const& dict, std::vector<std::string> const& standard)
{
    static std::vector<std::string> const known = {"fluid", "wall", "ghost"};
    auto kinds = dict.getOr("show", standard);
    for (std::string const& kind : kinds)
        require(std::find(known.begin(), known.end(), kind) != known.end(), dict.where("show"), "show: \"" + kind + "\" is not known",
                knownWords("kinds of particles", kind, known));
    return kinds;
}

std::vector<std::string> seriesNames(PostCase const& postCase)
{
    std::vector<std::string> names;
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(postCase.root / "VTK", error))
    {
        std::string const name = entry.path().filename().string();
        if (name.ends_with(seriesEnding)) names.push_back(name.substr(0, name.size() - std::string(seriesEnding).size()));
    }
    std::sort(names.begin(), names.end());
    return names;
}

Series::Series(PostCase const& postCase, std::string const& name, Location const& where)
{
    fs::path const path = postCase.root / "VTK" / (name + seriesEnding);
    if (!fs::is_regular_file(path))
        throw CaseError(ExitCode::InputOutput, where, "there is no " + postCase.shown(path) + ": has the solver been run?",
                        knownWords("series", name, seriesNames(postCase)));
    entries_ = readSeries(path);
    std::stable_sort(entries_.begin(), entries_.end(), [](SeriesEntry const& a, SeriesEntry const& b) { return a.time < b.time; });
}

std::vector<Real> Series::times() const
{
    std::vector<Real> times;
    for (SeriesEntry const& entry : entries_) times.push_back(entry.time);
    return times;
}

ParticleFrame Series::frame(std::size_t i) const
{
    ParticleFrame frame;
    frame.time = entries_[i].time;
    frame.file = entries_[i].file.string();
    frame.data = readPointCloud(entries_[i].file);
    for (Real const type : frame.field("type", Location{frame.file, 0, {}})) frame.type.push_back(static_cast<int>(type));
    return frame;
}

std::vector<std::vector<Vector>> bodyOutlines(PostCase const& postCase, std::string const& body, Real time, Location const& where)
{
    Series const series(postCase, body, where);
    SurfaceData const surface = readSurface(series.file(nearestTime(series.times(), time, where)));
    std::vector<std::vector<Vector>> outlines;
    auto const add = [&](std::vector<std::int64_t> const& cell) {
        outlines.emplace_back();
        for (std::int64_t const point : cell) outlines.back().push_back(surface.points[static_cast<std::size_t>(point)]);
    };
    for (auto const& cell : surface.polygons) add(cell);
    if (surface.polygons.empty())
        for (auto const& cell : surface.lines) add(cell);
    return outlines;
}

std::string outlineRows(std::vector<std::vector<Vector>> const& outlines)
{
    std::string rows;
    for (auto const& outline : outlines)
    {
        for (Vector const& point : outline) addRow(rows, {point.x(), point.y()});
        if (!outline.empty()) addRow(rows, {outline.front().x(), outline.front().y()});
        rows += '\n';
    }
    return rows;
}

} // namespace mpsDem::postGauges
