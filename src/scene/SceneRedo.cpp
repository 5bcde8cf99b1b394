#include <limits>

#include "core/Timers.h"
#include "parallel/Reduce.h"
#include "scene/Scene.h"

namespace mpsDem {

Step Scene::nextStep()
{
    Real const bodySpeed = solids_ ? solids_->largestSpeed() : 0;
    Viscosity const* const viscosity = fluid_ ? fluid_->fluid().viscosity() : nullptr;
    Real const viscousDt = viscosity ? viscosity->largestStableDt() : std::numeric_limits<Real>::infinity();
    Real const limit = timeStep_->limit(particles_, fluid_ ? fluid_->fluid().density() : 1, bodySpeed, viscousDt);
    Step const step = stepOf(timeStep_->next(limit, time_->lastDt(timeStep_->first())));
    guard_->choose(step, limit);
    return step;
}

Step Scene::stepOf(Real wanted)
{
    Real const observed = observers_ ? observers_->nextTime(time_->time()) : std::numeric_limits<Real>::infinity();
    return time_->next(wanted, !timeStep_->adjustable(), observed);
}

Step Scene::takeStep(std::function<void(Step const&)> const& stages)
{
    Step step = nextStep();
    while (!succeeds(step, stages))
    {
        undo();
        step = stepOf(guard_->again());
    }
    return step;
}

bool Scene::succeeds(Step const& step, std::function<void(Step const&)> const& stages)
{
    if (stepStart_) stepStart_->forget();
    try
    {
        stages(step);
    }
    catch (CaseError const& error)
    {
        if (!stepStart_ || !stepStart_->known() || !guard_->mends(step, error)) throw;
        return false;
    }
    if (!guard_->active()) return true;
    Timers::Scope const timer(Timers::stage(guardTimer_));
    if (!fluid_ || guard_->accepts(step, particles_, bodies_, fluid_->fluid().limitedNow(), particlesThroughWalls())) return true;
    fluid_->fluid().forgetLimited();
    return false;
}

int Scene::particlesThroughWalls() const
{
    if (!stepStart_) return 0;
    NeighbourList const& neighbours = fluid_->neighbours();
    Real const half = dicts_.lattice.spacing / 2, quarter = half / 2;
    auto const passes = [&](int k, int j) {
        if (!particles_.fluid().contains(j)) return false;
        Vector const& normal = particles_.normal[k];
        Vector const now = particles_.r[j] - particles_.r[k];
        Real const height = now.dot(normal);
        if (height > 0 || (now - height * normal).squaredNorm() > half * half) return false;
        Vector const before = stepStart_->position(particles_, j) - particles_.r[k];
        return before.dot(normal) > 0 && (now - before).squaredNorm() > quarter * quarter; // what creeps through does so at any step
    };
    return static_cast<int>(countOver(particles_.wall(), [&](int k) {
        for (int m = neighbours.first(k); m < neighbours.last(k); ++m)
            if (passes(k, neighbours.index()[m])) return true;
        return false;
    }));
}

void Scene::rememberStart()
{
    if (!guard_->active()) return;
    Timers::Scope const timer(Timers::stage(guardTimer_));
    guard_->begin(particles_);
    if (stepStart_) stepStart_->remember(particles_, bodies_, solids_ ? std::as_const(*solids_).contacts() : nullptr, ledger_);
}

void Scene::undo() { stepStart_->restore(particles_, bodies_, solids_ ? solids_->contacts() : nullptr, ledger_); }

} // namespace mpsDem
