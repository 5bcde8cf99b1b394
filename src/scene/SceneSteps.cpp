#include <chrono>

#include "core/Log.h"
#include "core/Timers.h"
#include "io/Checkpoint.h"
#include "parallel/Reduce.h"
#include "scene/Scene.h"
#include "scene/StartChecks.h"

namespace mpsDem {

void Scene::moveBoundaries()
{
    if (solids_) solids_->moveParticles(particles_);
}

void Scene::updateNeighbours(Step const& step)
{
    if (fluid_) fluid_->updateNeighbours(step);
    rememberStart();
}

void Scene::label()
{
    if (fluid_) fluid_->label();
}

void Scene::predict(Step const& step)
{
    if (!fluid_) return;
    for (int i : particles_.boundary()) particles_.uStar[i] = particles_.u[i];
    if (solids_) solids_->predictParticles(particles_, step);
    fluid_->predict(step);
}

void Scene::solvePressure(Step const& step)
{
    if (!fluid_) return;
    lastSolve_ = fluid_->solvePressure(step);
    solved_ = true;
}

void Scene::loadBodies(Step const& step)
{
    if (fluid_ && solids_) solids_->loadBodies(*fluid_, step);
}

void Scene::advanceBodies(Step const& step)
{
    if (!solids_) return;
    solids_->advance(step);
    if (fluid_) solids_->correctPressure(particles_);
}

void Scene::correctFluid(Step const& step)
{
    if (!fluid_) return;
    accumulateImpulse(step);
    fluid_->correct(step);
    if (solids_ && fluid_->fluid().collision()) solids_->takeCollisions(fluid_->fluid().collision()->reactions(), step);
}

void Scene::accumulateImpulse(Step const& step)
{
    static std::vector<FluidBodyCoupling> const noCouplings;
    if (fixedSurfaces_.empty()) return;
    Timers::Scope const timer(Timers::stage(impulseTimer_));
    Real const density = fluid_->fluid().density();
    PressureIntegrationControls controls;
    controls.wetRadius = 1.5 * dicts_.lattice.spacing;
    controls.radius = 2.1 * dicts_.lattice.spacing;
    for (WettedSurface& surface : fixedSurfaces_)
    {
        surface.interpolate(
            particles_, fluid_->neighbours().grid(), particles_.p, gravity_, density, [](Vector const&) { return Vector(Vector::Zero()); },
            controls);
        surface.dryContactFaces(particles_, fluid_->neighbours().grid());
        *wallImpulse_ -= step.dt * surface.integrate(Vector::Zero()).force; // on the water: the reaction
    }
    // Pore pressure between a body and a wall presses on both: what dry points of a body carry, the wall gives back.
    for (FluidBodyCoupling const& coupling : solids_ ? solids_->couplings() : noCouplings)
    {
        WettedSurface const& surface = coupling.surface();
        for (std::size_t s = 0; s < surface.wet().size(); ++s)
            if (!surface.wet()[s]) *wallImpulse_ -= step.dt * surface.pressure()[s] * surface.area()[s] * surface.normal()[s];
    }
    Real const mass = density * dicts_.lattice.particleVolume() * sumOverRanks(particles_.fluid().size());
    *gravityImpulse_ += step.dt * mass * gravity_;
}

void Scene::observe(Step const& step)
{
    particleSteps_ += particles_.owned().size();
    time_->advance(step);
    if (observerTimer_ < 0) return;
    Timers::Scope const timer(Timers::stage(observerTimer_));
    observers_->execute(step);
}

State Scene::state() const
{
    State state;
    time_->save(state);
    particles_.save(state);
    saveSurfaces(state, surfaces_);
    saveWallOf(state, wallOf_);
    saveKernelRadius(state, rowsMadeFor_);
    for (std::size_t k = 0; k < bodies_.size(); ++k)
        saveOutline(state, bodies_[k]->name(), static_cast<int>(k), {outlines_[k], discRadii_[k]});
    if (fluid_) fluid_->save(state);
    if (solids_) solids_->save(state);
    ledger_.save(state);
    guard_->save(state);
    if (observers_) observers_->save(state);
    return state;
}

void Scene::writeCheckpointNow()
{
    Timers::Scope const timer(Timers::stage(checkpointTimer_));
    CheckpointInfo info;
    info.time = time_->time();
    info.step = time_->stepNumber();
    info.codeVersion = "mpsDem-" MPSDEM_VERSION;
    info.inputHash = output_->inputHash();
    info.effects = effects_.lines();
    writeCheckpoint(case_.root() / "checkpoint", std::to_string(info.step), state(), info, time_->purgeWrite());
    if (fluid_) fluid_->forget();
    lastCheckpoint_ = info.step;
    lastCheckpointClock_ = std::chrono::steady_clock::now();
}

void Scene::writeFields()
{
    output_->write(time_->time());
    if (fluid_) fluid_->checkOutside(time_->time());
}

void Scene::writeIfDue(Step const& step)
{
    bool const over = guard_->gainedTooMuch();
    if (!step.write && !over) return;
    writeFields();
    writeCheckpointNow();
    guard_->requireNoGain(step.time);
}

void Scene::writeStart()
{
    if (time_->stepNumber() == 0) writeFields();
}

void Scene::writeEnd()
{
    if (nothingRun())
    {
        info() << "The end time was reached before: nothing to run, nothing written\n" << std::endl;
        return;
    }
    if (lastCheckpoint_ == time_->stepNumber()) return;
    writeFields();
    writeCheckpointNow();
}

void Scene::serveCheckpoint()
{
    Real const interval = time_->checkpointInterval();
    Real const seconds = std::chrono::duration<Real>(std::chrono::steady_clock::now() - lastCheckpointClock_).count();
    if (interval > 0 && seconds > interval) checkpointDue_ = true;
    if (!(checkpointAsked_ || checkpointDue_) || !atSeam()) return;
    if (lastCheckpoint_ != time_->stepNumber()) writeCheckpointNow();
    if (stopAsked_)
        time_->stopNow();
    else if (checkpointAsked_)
        info() << "The state asked for is saved: time " << time_->format(time_->time()) << " s, checkpoint/" << lastCheckpoint_ << '\n'
               << std::endl;
    checkpointAsked_ = checkpointDue_ = false;
}

bool Scene::atSeam() const
{
    // After these steps an unbroken run, too, sorts its particles and starts its solver anew.
    return !fluid_ || time_->stepNumber() % FluidStage::sortInterval == 0 || lastCheckpoint_ == time_->stepNumber();
}

void Scene::askCheckpoint(std::string const& who)
{
    if (!checkpointAsked_) logRequest(who, "the state will be saved");
    checkpointAsked_ = true;
}

void Scene::askStop(std::string const& who)
{
    if (!stopAsked_) logRequest(who, "the run will save its state and stop");
    checkpointAsked_ = stopAsked_ = true;
}

} // namespace mpsDem
