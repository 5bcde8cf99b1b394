#include "functionObjects/FreeSurfaceProfile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/Errors.h"
#include "functionObjects/Observed.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

constexpr Real mostPoints = 100000;

void addNumber(std::string& line, Real value)
{
    std::array<char, 32> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 10).ptr;
    if (!line.empty() && line.back() != '\n') line += ' ';
    line.append(buffer.data(), end);
}

/// A point given as (x y z) or as x alone.
std::optional<Vector> readPoint(Dictionary const& dict, std::string const& key)
{
    if (!dict.found(key)) return std::nullopt;
    if (dict.entryTokens(key).size() == 1) return Vector(dict.get<Real>(key), 0, 0);
    return dict.get<Vector>(key);
}

RunContext const& withFluid(RunContext const& context, Dictionary const& dict)
{
    requireFluid(context, dict);
    return context;
}

} // namespace

FreeSurfaceProfile::FreeSurfaceProfile(std::string const& name, Dictionary const& dict, RunContext const& context)
    : context_(withFluid(context, dict)),
      controls_(SurfaceElevationControls::read(dict)),
      surface_(context.particles, controls_, readUp(context, dict)),
      folder_(context.caseRoot / "postProcessing" / name / startTimeName(context.startTime)),
      times_(dict.getOr<std::vector<Real>>("times", {}))
{
    for (Real const time : times_)
        require(std::isfinite(time) && time > 0, dict.where("times"), "a time of a profile is not positive", "times after the very start");
    require(!dict.found("times") || !times_.empty(), dict.where("times"), "times is an empty list", "at least one time, or no such entry");
    std::sort(times_.begin(), times_.end());
    readLine(dict);
}

void FreeSurfaceProfile::readLine(Dictionary const& dict)
{
    from_ = readPoint(dict, "from");
    to_ = readPoint(dict, "to");
    bool const planar = context_.particles.lattice().dimensions == 2;
    require(planar || (from_ && to_), dict.where(), "a profile in 3-D needs the ends of its line", "from (x y z); to (x y z);");
    require(!from_ || !to_ || (*to_ - *from_).norm() > 0, dict.where("to"), "the ends of the profile are the same point", "different ends");
    require(!dict.found("spacing") || !dict.found("count"), dict.where("count"), "both spacing and count are given", "one of them");
    Vector const up = readUp(context_, dict);
    if (from_) warnOfPlacesOutside(context_, dict, "from", {*from_}, up);
    if (to_) warnOfPlacesOutside(context_, dict, "to", {*to_}, up);
    Real const particleSpacing = context_.particles.lattice().spacing;
    spacing_ = dict.getInRangeOr("spacing", particleSpacing, 1e-3 * particleSpacing, 1e12);
    count_ = dict.found("count") ? static_cast<int>(dict.getInRange("count", 2, mostPoints)) : 0;
}

Real FreeSurfaceProfile::wantedTime(Real t) const
{
    auto const next = std::upper_bound(times_.begin(), times_.end(), t + 1e-9 * std::max(Real(1), std::abs(t)));
    return next == times_.end() ? std::numeric_limits<Real>::infinity() : *next;
}

void FreeSurfaceProfile::execute(Step const& step)
{
    written_.clear();
    Real const slack = 1e-6 * step.dt;
    for (Real const time : times_)
        if (step.begin() + slack < time && time <= step.time + slack) writeProfile(step.time);
}

void FreeSurfaceProfile::write(Step const& step)
{
    if (times_.empty()) writeProfile(step.time);
}

std::vector<Vector> FreeSurfaceProfile::line() const
{
    auto const extent = surface_.extent(Vector::UnitX());
    Vector const from = from_.value_or(Vector(extent.first, 0, 0)), to = to_.value_or(Vector(extent.second, 0, 0));
    Real const length = (to - from).norm();
    Real const pieces = count_ > 0 ? count_ - 1 : std::clamp(std::round(length / spacing_), Real(1), mostPoints);
    std::vector<Vector> points;
    for (int k = 0; k <= static_cast<int>(pieces); ++k) points.push_back(from + k / pieces * (to - from));
    return points;
}

void FreeSurfaceProfile::writeProfile(Real time)
{
    bool const planar = context_.particles.lattice().dimensions == 2;
    surface_.update();
    std::string table = "# Free surface at time ";
    addNumber(table, time);
    table += " s [m]\n# " + controls_.str() + (planar ? "\n# x eta\n" : "\n# x y z eta\n");
    for (Vector const& point : line())
    {
        auto const eta = surface_.elevation(point);
        if (!eta) continue;
        addNumber(table, point.x());
        if (!planar)
        {
            addNumber(table, point.y());
            addNumber(table, point.z());
        }
        addNumber(table, *eta);
        table += '\n';
    }
    written_ = "profile_" + startTimeName(time) + ".dat";
    atomicWrite(folder_ / written_, table, Durability::Process);
}

} // namespace mpsDem
