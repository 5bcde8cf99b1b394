#include "functionObjects/ElevationMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Errors.h"
#include "core/Log.h"
#include "functionObjects/Observed.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
constexpr Real mostPlaces = 1e6;

ParticleSet const& particlesOf(RunContext const& context, Dictionary const& dict)
{
    requireFluid(context, dict);
    return context.particles;
}

/// Number of places along a side, one for a side without length, and the step between them.
std::pair<int, Vector> sideOf(Vector const& side, Real spacing)
{
    if (side.norm() < 1e-9 * spacing) return {1, Vector::Zero()};
    Real const pieces = std::max(1.0, std::round(side.norm() / spacing));
    return {static_cast<int>(std::min(pieces, mostPlaces)) + 1, side / pieces};
}

} // namespace

ElevationMap::ElevationMap(std::string const& name, Dictionary const& dict, RunContext const& context)
    : block_("functionObject/" + name + "/"),
      folder_(context.caseRoot / "postProcessing" / name / startTimeName(context.startTime)),
      controls_(SurfaceElevationControls::read(dict)),
      surface_(particlesOf(context, dict), controls_, readUp(context, dict)),
      threshold_(dict.getOr("threshold", context.particles.lattice().spacing)),
      particleSpacing_(context.particles.lattice().spacing),
      lookedAt_(none)
{
    require(std::isfinite(threshold_), dict.where("threshold"), "the threshold of arrival is no number");
    readGrid(dict, readUp(context, dict));
}

void ElevationMap::readGrid(Dictionary const& dict, Vector const& up)
{
    auto const from = dict.get<Vector>("from"), to = dict.get<Vector>("to");
    Real const spacing = dict.getInRangeOr("spacing", 2 * particleSpacing_, 1e-3 * particleSpacing_, 1e12);
    Vector const first = std::abs(up.x()) < 0.9 ? Vector::UnitX() : Vector::UnitY();
    Vector const across = (first - first.dot(up) * up).normalized(), along = across.cross(up);
    Vector const diagonal = to - from;
    require(diagonal.allFinite() && diagonal.norm() > 0, dict.where("to"), "the corners of the map are the same point",
            "different corners");
    auto const [columns, stepAcross] = sideOf(diagonal.dot(across) * across, spacing);
    auto const [rows, stepAlong] = sideOf(diagonal.dot(along) * along, spacing);
    require(static_cast<Real>(columns) * rows <= mostPlaces, dict.where(), "the map has more than 1000000 places", "a larger spacing");
    perRow_ = columns;
    for (int k = 0; k < rows; ++k)
        for (int i = 0; i < columns; ++i) places_.push_back(from + i * stepAcross + k * stepAlong);
    for (auto* const values : {&now_, &largest_, &timeOfLargest_, &arrival_}) values->assign(places_.size(), none);
}

void ElevationMap::look(Real time)
{
    if (time == lookedAt_) return;
    lookedAt_ = time;
    surface_.update();
    for (std::size_t i = 0; i < places_.size(); ++i)
    {
        now_[i] = surface_.elevation(places_[i]).value_or(none);
        if (std::isnan(now_[i])) continue;
        if (!(now_[i] <= largest_[i]))
        {
            largest_[i] = now_[i];
            timeOfLargest_[i] = time;
        }
        if (std::isnan(arrival_[i]) && now_[i] >= threshold_) arrival_[i] = time;
    }
}

void ElevationMap::execute(Step const& step) { look(step.time); }

void ElevationMap::write(Step const& step)
{
    look(step.time);
    std::string table = "# Free surface until time " + shortNumber(step.time) + " s; arrival: first time of an elevation of " +
                        shortNumber(threshold_) + " m or more [m, s]\n# " + controls_.str() +
                        "\n# nan: no fluid until now, or no wave\n# x y z eta etaMax timeOfMax arrival\n";
    for (std::size_t i = 0; i < places_.size(); ++i)
    {
        addNumbers(table, {places_[i].x(), places_[i].y(), places_[i].z(), now_[i], largest_[i], timeOfLargest_[i], arrival_[i]});
        if ((i + 1) % static_cast<std::size_t>(perRow_) == 0) table += '\n';
    }
    written_ = "map_" + startTimeName(step.time) + ".dat";
    atomicWrite(folder_ / written_, table, Durability::Process);
}

void ElevationMap::save(State& state) const
{
    // NaN is not saved: a time below all others says that there was nothing.
    auto const set = [&](char const* name, std::vector<Real> values) {
        for (Real& value : values)
            if (std::isnan(value)) value = std::numeric_limits<Real>::lowest();
        state.set(block_ + name, std::span<Real const>(values));
    };
    set("largest", largest_);
    set("timeOfLargest", timeOfLargest_);
    set("arrival", arrival_);
}

void ElevationMap::load(State const& state)
{
    if (!state.has(block_ + "largest")) return; // added at a restart: counts from there
    auto const stored = [&](char const* name) {
        auto values = state.reals(block_ + name);
        for (Real& value : values)
            if (value == std::numeric_limits<Real>::lowest()) value = none;
        return values;
    };
    auto const largest = stored("largest"), timeOfLargest = stored("timeOfLargest"), arrival = stored("arrival");
    bool const fits = largest.size() == places_.size() && timeOfLargest.size() == places_.size() && arrival.size() == places_.size();
    if (!fits)
    {
        warn("elevationMap: the grid has changed since the state was saved; the map begins anew (" + block_ + ")");
        return;
    }
    largest_ = largest;
    timeOfLargest_ = timeOfLargest;
    arrival_ = arrival;
}

} // namespace mpsDem
