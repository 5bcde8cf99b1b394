#include "scene/StepGuard.h"

#include <algorithm>
#include <limits>
#include <span>
#include <sstream>

#include "core/Errors.h"
#include "core/Log.h"
#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

/// A step shorter than this share of what the flow allows is tiny; so many of them one after the other end the run.
constexpr Real tinyShare = 1e-3;
constexpr int mostTiny = 50;
/// A shorter try is better where it leaves at most this share of the excess.
constexpr Real clearly = 0.75;
constexpr int linesInLog = 10;
constexpr Real infinity = std::numeric_limits<Real>::infinity();

std::string percent(Real share) { return shortNumber(100 * share, 3) + " %"; }

} // namespace

StepGuard::StepGuard(Dictionary const& controlDict, SchemeSet set, bool adjustable, Vector const& gravity, Real density)
    : adjustable_(adjustable),
      gravity_(gravity),
      density_(density)
{
    Dictionary const dict = controlDict.subDictOrEmpty("redoSteps");
    active_ = dict.getOr<bool>("active", set != SchemeSet::Paper);
    largestRise_ = dict.getInRangeOr("energyRise", 0.001, 0, 1);
    largestLimited_ = dict.getInRangeOr("limited", 0.005, 0, 1);
    largestGain_ = dict.getInRangeOr("energyGain", 0.2, 0, 1e6);
}

void StepGuard::take(StepGuard const& edited)
{
    active_ = edited.active_;
    adjustable_ = edited.adjustable_;
    largestRise_ = edited.largestRise_;
    largestLimited_ = edited.largestLimited_;
    largestGain_ = edited.largestGain_;
}

void StepGuard::choose(Step const& step, Real limit)
{
    tried_ = 0;
    last_ = false;
    if (!redoes()) return;
    longest_ = std::max(longest_, step.dt);
    bool const isTiny = step.dt < tinyShare * std::min(limit, longest_);
    tiny_ = isTiny ? tiny_ + 1 : 0;
    if (tiny_ <= mostTiny) return;
    std::ostringstream text;
    text << "time " << step.begin() << " s, step " << step.number << ": the time step collapsed: for " << mostTiny
         << " steps it has been below a thousandth of the " << limit << " s that the flow allows, now " << step.dt << " s";
    throw CaseError(ExitCode::Solver, text.str(),
                    "see the warnings above; other schemes of system/mpsSchemes, or redoSteps { active no; }");
}

Real StepGuard::energy(ParticleSet const& particles) const
{
    Real const mass = density_ * particles.lattice().particleVolume();
    return mass * sumOver(particles.fluid(), Real(0),
                          [&](int i) { return 0.5 * particles.u[i].squaredNorm() - gravity_.dot(particles.r[i]) - lowest_; });
}

void StepGuard::begin(ParticleSet const& particles)
{
    if (!begun_)
    {
        auto const height = [&](int i) { return -gravity_.dot(particles.r[i]); };
        lowest_ = minOver(particles.owned(), std::numeric_limits<Real>::max(), height).value;
        begun_ = true;
        given_ = std::max(Real(0), energy(particles));
    }
    begin_ = energy(particles);
    available_ = std::max(available_, begin_);
}

bool StepGuard::accepts(Step const& step, ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies, int limited,
                        int crossed)
{
    std::int64_t const count = sumOverRanks(static_cast<std::int64_t>(particles.fluid().size()));
    if (count == 0) return true;
    Real work = 0; // of the bodies on the water
    for (auto const& body : bodies)
        work -= step.dt * (body->fluid.force.dot(body->velocity()) + body->fluid.moment.dot(body->angularVelocity()));
    work = std::max(Real(0), work);
    Real const rise = energy(particles) - begin_ - work;
    if (!judge(step, available_ > 0 ? rise / available_ : 0, limited / static_cast<Real>(count), crossed)) return false;
    given_ += work;
    balance_ += rise;
    least_ = std::min(least_, balance_);
    return true;
}

bool StepGuard::judge(Step const& step, Real rise, Real share, int crossed)
{
    Real const byRise = largestRise_ > 0 ? rise / largestRise_ : 0, byShare = largestLimited_ > 0 ? share / largestLimited_ : 0;
    Real const byWall = crossed > 0 ? 1 + crossed : 0;
    if (std::max({byRise, byShare, byWall}) <= 1) return true;
    if (byWall > std::max(byRise, byShare))
        return !refuse(step, Wall, byWall, "particles go through the wall at " + std::to_string(crossed) + " places");
    if (byShare > byRise)
        return !refuse(step, Limiter, byShare,
                       "the displacement by the pressure gradient was limited for " + percent(share) +
                           " of the particles (allowed: " + percent(largestLimited_) + ")");
    return !refuse(step, Energy, byRise,
                   "the energy of the water rises by " + percent(rise) + " of all there is (allowed: " + percent(largestRise_) + ")");
}

bool StepGuard::mends(Step const& step, CaseError const& error)
{
    if (error.code() != ExitCode::Solver || !redoes() || last_) return false;
    return refuse(step, Failure, infinity, error.what());
}

bool StepGuard::helpsToHalve() const
{
    if (tried_ > mostHalvings) return false;
    return tried_ == 1 || tries_[tried_ - 1].excess == infinity || tries_[tried_ - 1].excess < clearly * tries_[tried_ - 2].excess;
}

bool StepGuard::refuse(Step const& step, Cause cause, Real excess, std::string const& finding)
{
    if (last_ || !redoes())
    {
        ++kept_;
        if (!redoes()) tell(step, finding, "kept: adjustTimeStep is no");
        return false;
    }
    tries_[tried_++] = {step.dt, excess};
    if (tried_ == 1) ++redone_[cause];
    again_ = step.dt / 2;
    if (helpsToHalve())
    {
        tell(step, finding, "taken again with half the length");
        return true;
    }
    Try best = tries_[0]; // the longest one than which no shorter one is clearly better
    for (Try const& one : std::span(tries_).first(static_cast<std::size_t>(tried_)))
        if (one.excess < clearly * best.excess) best = one;
    if (best.excess == infinity) return false;
    last_ = true;
    again_ = best.dt;
    if (best.dt == step.dt) ++kept_;
    tell(step, finding, best.dt == step.dt ? "kept: no length does better" : "taken again with a longer step, which is kept");
    return best.dt != step.dt;
}

Real StepGuard::gain() const { return given_ > 0 ? (balance_ - least_) / given_ : 0; }

void StepGuard::requireNoGain(Real time) const
{
    if (!gainedTooMuch()) return;
    std::ostringstream text;
    text << "time " << time << " s: the energy of the water goes on rising: it has gained " << percent(gain())
         << " of what it began with and bodies gave to it (allowed: " << percent(largestGain_) << "); the state of this step is saved";
    throw CaseError(ExitCode::Solver, text.str(),
                    "smaller steps (maxCo, maxPressureCo, maxDeltaT or a fixed deltaT), other schemes of system/mpsSchemes, or a larger "
                    "redoSteps { energyGain ...; }");
}

void StepGuard::tell(Step const& step, std::string const& finding, std::string const& answer) const
{
    std::ostringstream text;
    text << "time " << step.begin() << " s, step " << step.number << " of " << step.dt << " s: " << finding << "; " << answer;
    warn(text.str(), "steps that went wrong", linesInLog);
}

void StepGuard::report(std::ostream& os) const
{
    if (redone() + kept_ == 0) return;
    os << "Steps taken again: " << redone() << " (energy " << redone_[Energy] << ", limited displacements " << redone_[Limiter]
       << ", walls " << redone_[Wall] << ", solver " << redone_[Failure] << "); kept although they went wrong: " << kept_ << "\n\n";
}

void StepGuard::save(State& state) const
{
    if (!active_) return;
    std::array<std::int64_t, 7> const counts = {redone_[Energy], redone_[Limiter], redone_[Wall], redone_[Failure], kept_, tiny_, begun_};
    state.set("stepGuard/counts", std::span<std::int64_t const>(counts));
    std::array<Real, 3> const numbers = {lowest_, available_, longest_};
    state.set("stepGuard/numbers", std::span<Real const>(numbers));
    std::array<Real, 3> const gains = {given_, balance_, least_};
    state.set("stepGuard/gains", std::span<Real const>(gains));
}

void StepGuard::load(State const& state)
{
    if (!active_ || !state.has("stepGuard/counts")) return; // switched on with the restart
    State::Integers const& counts = state.integers("stepGuard/counts");
    State::Reals const& numbers = state.reals("stepGuard/numbers");
    if (counts.size() != 7 || numbers.size() != 3) throw CaseError(ExitCode::InputOutput, "blocks stepGuard/... have a wrong length");
    std::copy(counts.begin(), counts.begin() + causes, redone_.begin());
    kept_ = counts[causes];
    tiny_ = counts[causes + 1];
    begun_ = counts[causes + 2] != 0;
    lowest_ = numbers[0];
    available_ = numbers[1];
    longest_ = numbers[2];
    given_ = available_;
    if (!state.has("stepGuard/gains")) return; // of an older version
    State::Reals const& gains = state.reals("stepGuard/gains");
    if (gains.size() != 3) throw CaseError(ExitCode::InputOutput, "block stepGuard/gains has a wrong length");
    given_ = gains[0];
    balance_ = gains[1];
    least_ = gains[2];
}

} // namespace mpsDem
