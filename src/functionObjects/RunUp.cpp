#include "functionObjects/RunUp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/Errors.h"
#include "core/Log.h"
#include "functionObjects/Observed.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
constexpr Real flattest = 0.02; ///< Sine of a slope that can be climbed.
constexpr Real mostPlaces = 100000;

ParticleSet const& particlesOf(RunContext const& context, Dictionary const& dict)
{
    requireFluid(context, dict);
    return context.particles;
}

Real orNone(Real value) { return value > -1e299 ? value : none; }

} // namespace

RunUp::RunUp(std::string const& name, Dictionary const& dict, RunContext const& context)
    : context_(context),
      block_("functionObject/" + name + "/"),
      folder_(context.caseRoot / "postProcessing" / name / startTimeName(context.startTime)),
      controls_(SurfaceElevationControls::readDrops(dict)),
      up_(readUp(context, dict)),
      surface_(particlesOf(context, dict), controls_, up_),
      reach_(dict.getInRangeOr("reach", 1.5, 1, 4) * context.particles.lattice().spacing),
      axis_(dict.getOr<Vector>("axis", Vector::UnitZ())),
      lookedAt_(none),
      table_(makeTable(context, name, "runUp", {"height", "distance", "place", "heightMax", "distanceMax", "placeMax", "timeOfMax"},
                       {"Highest water on the walls: height above zero and distance along the slope [m], place along the axis [m]",
                        "now, and the largest height so far with its time [s]; nan: no water touches the walls"}))
{
    require(axis_.allFinite() && axis_.norm() > 0, dict.where("axis"), "the axis of the places is zero", "axis (0 0 1);");
    axis_.normalize();
    readWalls(dict);
    readPlaces(dict);
}

void RunUp::readWalls(Dictionary const& dict)
{
    std::vector<int> const patches = readPatches(context_, dict, "patches");
    ParticleSet const& particles = context_.particles;
    Real const steepest = dict.getInRangeOr("steepest", 90, 1, 180);
    Real const least = std::cos(steepest * std::numbers::pi / 180) - 1e-6; // of the normal along up
    std::vector<Vector> places;
    for (int i : particles.wall())
    {
        Vector const& n = particles.normal[i];
        bool const own = std::find(patches.begin(), patches.end(), context_.wallOf[i]) != patches.end();
        if (!own || up_.dot(n) < least || (up_ - up_.dot(n) * n).norm() < flattest) continue;
        walls_.push_back(i);
        places.push_back(particles.r[i]);
    }
    require(!walls_.empty(), dict.where("patches"), "nothing of these surfaces has a slope for run-up",
            "slopes of more than 1:50, up to " + shortNumber(steepest) + " degrees");
    grid_.build(places, reach_, particles.lattice().dimensions);
}

void RunUp::readPlaces(Dictionary const& dict)
{
    Lattice const& lattice = context_.particles.lattice();
    placeSpacing_ = dict.getInRangeOr("spacing", 2 * lattice.spacing, 1e-3 * lattice.spacing, 1e12);
    Real low = 1e300, high = -1e300;
    for (int const i : walls_)
    {
        low = std::min(low, context_.particles.r[i].dot(axis_));
        high = std::max(high, context_.particles.r[i].dot(axis_));
    }
    // The walls' particles stand half a spacing from the ends; a whole number of places between them.
    Real const length = high - low + lattice.spacing;
    Real const count = lattice.dimensions == 2 ? 1 : std::max(1.0, std::round(length / placeSpacing_));
    require(count <= mostPlaces, dict.where("spacing"), "there are more than 100000 places along the axis", "a larger spacing");
    placeSpacing_ = length / count;
    firstPlace_ = low - 0.5 * lattice.spacing + 0.5 * placeSpacing_;
    now_.resize(static_cast<std::size_t>(count));
    largest_.resize(static_cast<std::size_t>(count));
}

std::size_t RunUp::placeOf(Vector const& r) const
{
    Real const place = std::round((r.dot(axis_) - firstPlace_) / placeSpacing_);
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<Real>(now_.size() - 1)));
}

void RunUp::take(int fluid, Real time)
{
    ParticleSet const& particles = context_.particles;
    Real const half = 0.5 * particles.lattice().spacing;
    Vector const& r = particles.r[fluid];
    Reached& place = now_[placeOf(r)];
    if (r.dot(up_) - controls_.zero + 2 * (half + reach_) < place.height) return; // too low whatever the wall is like
    int nearest = -1;
    Real distance = 1e300;
    grid_.forEachWithin(r, reach_, [&](int k, Vector const&, Real r2) {
        if (r2 >= distance) return;
        distance = r2;
        nearest = walls_[static_cast<std::size_t>(k)];
    });
    if (nearest < 0) return;
    Vector const& n = particles.normal[nearest];
    Vector const slope = up_ - up_.dot(n) * n;
    Vector const edge = r - ((r - particles.r[nearest]).dot(n) - half) * n + half * slope.normalized();
    Real const height = edge.dot(up_) - controls_.zero;
    if (height <= place.height || surface_.isDrop(fluid - particles.fluid().first)) return;
    place = {height, height / slope.norm(), time};
}

void RunUp::look(Real time)
{
    if (time == lookedAt_) return;
    lookedAt_ = time;
    surface_.update();
    std::fill(now_.begin(), now_.end(), Reached());
    for (int i : context_.particles.fluid()) take(i, time);
    for (std::size_t k = 0; k < now_.size(); ++k)
        if (now_[k].height > largest_[k].height) largest_[k] = now_[k];
}

void RunUp::execute(Step const& step) { look(step.time); }

void RunUp::write(Step const& step)
{
    look(step.time);
    auto const lower = [](Reached const& a, Reached const& b) { return a.height < b.height; };
    auto const now = std::max_element(now_.begin(), now_.end(), lower), most = std::max_element(largest_.begin(), largest_.end(), lower);
    auto const place = [&](auto const& all, auto const& best) {
        return best->time > Reached::lowest ? coordinate(static_cast<std::size_t>(best - all.begin())) : none;
    };
    std::array<Real, 7> const row{orNone(now->height),    orNone(now->distance), place(now_, now),  orNone(most->height),
                                  orNone(most->distance), place(largest_, most), orNone(most->time)};
    table_.add(step.time, row);
    writePlaces(step.time);
}

void RunUp::writePlaces(Real time) const
{
    std::string table = "# Water on the walls at time " + shortNumber(time) +
                        " s: height above zero, distance along the slope [m], and the largest until then\n"
                        "# place height distance heightMax distanceMax timeOfMax\n";
    for (std::size_t k = 0; k < now_.size(); ++k)
        addNumbers(table, {coordinate(k), orNone(now_[k].height), orNone(now_[k].distance), orNone(largest_[k].height),
                           orNone(largest_[k].distance), orNone(largest_[k].time)});
    atomicWrite(folder_ / ("places_" + startTimeName(time) + ".dat"), table, Durability::Process);
}

void RunUp::save(State& state) const
{
    std::vector<Real> values;
    for (Reached const& reached : largest_) values.insert(values.end(), {reached.height, reached.distance, reached.time});
    state.set(block_ + "largest", std::span<Real const>(values));
}

void RunUp::load(State const& state)
{
    if (!state.has(block_ + "largest")) return; // added at a restart: counts from there
    auto const& values = state.reals(block_ + "largest");
    if (values.size() != 3 * largest_.size())
    {
        warn("runUp: its places have changed since the state was saved; the largest heights begin anew (" + block_ + ")");
        return;
    }
    for (std::size_t k = 0; k < largest_.size(); ++k) largest_[k] = {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
}

} // namespace mpsDem
