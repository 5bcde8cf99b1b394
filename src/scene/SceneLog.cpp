#include <cmath>
#include <iomanip>

#include "core/Log.h"
#include "core/OnceLog.h"
#include "parallel/Reduce.h"
#include "scene/Scene.h"

namespace mpsDem {

void Scene::logStep(Step const& step, double executionTime, double clockTime) const
{
    std::ostream& os = info();
    if (fluid_)
    {
        TimeStep::Courant const courant = timeStep_->courant(particles_, step.dt);
        os << "Courant Number mean: " << courant.mean << " max: " << courant.max << '\n';
        if (courant.max > 1 && !timeStep_->adjustable())
            warn("time " + time_->format(step.time) + " s: Courant number above 1, particles may pass through walls: take a smaller deltaT",
                 "courant", 3);
        if (fluid_->fluid().viscosity())
        {
            Real const diffusion = fluid_->fluid().nu() * step.dt / (dicts_.lattice.spacing * dicts_.lattice.spacing);
            os << "Diffusion Number mean: " << diffusion << " max: " << diffusion << '\n';
        }
    }
    os << "deltaT = " << step.dt << '\n' << "Time = " << time_->format(step.time) << '\n' << '\n';
    if (solved_)
    {
        os << lastSolve_.solverName << ":  Solving for p, Initial residual = " << lastSolve_.initialResidual
           << ", Final residual = " << lastSolve_.finalResidual << ", No Iterations " << lastSolve_.iterations << '\n';
        // Volume error of the cloud: deviation of the number density in the interior.
        auto const inside = [&](int i) { return particles_.surface[i] == SurfaceLabel::Interior; };
        auto const error = [&](int i) { return inside(i) ? particles_.n[i] - 1 : 0; };
        Real const local = sumOver(particles_.fluid(), Real(0), [&](int i) { return std::abs(error(i)); });
        Real const global = sumOver(particles_.fluid(), Real(0), error);
        Real const n = static_cast<Real>(std::max(std::int64_t{1}, countOver(particles_.fluid(), inside)));
        cumulativeError_ += global / n;
        os << "time step continuity errors : sum local = " << local / n << ", global = " << global / n
           << ", cumulative = " << cumulativeError_ << '\n';
    }
    for (auto const& body : bodies_)
    {
        if (!body->report()) continue;
        os << "Rigid body " << body->name() << ": centre (" << body->centre().transpose() << "), velocity (" << body->velocity().transpose()
           << "), contact sub-steps " << solids_->subSteps() << '\n';
    }
    os << "ExecutionTime = " << executionTime << " s  ClockTime = " << clockTime << " s\n" << std::endl;
}

void Scene::logRequest(std::string const& who, std::string const& what) const
{
    std::int64_t const now = time_->stepNumber(), interval = FluidStage::sortInterval;
    info() << "Request by " << who << " received at time " << time_->format(time_->time()) << " s, step " << now << ": " << what;
    if (atSeam())
        info() << " at once";
    else
        info() << " after step " << (now / interval + 1) * interval << " at the latest, or at a write time or the end before it";
    info() << '\n' << std::endl;
}

void Scene::logStop() const
{
    info() << "Stopped on request at time " << time_->format(time_->time()) << " s, step " << time_->stepNumber() << "; ";
    if (lastCheckpoint_ == time_->stepNumber())
        info() << "the state of this step is saved: checkpoint/" << lastCheckpoint_;
    else
        info() << "the state of this step is not saved; a restart goes on from the newest one in checkpoint/, or from the start";
    info() << '\n' << std::endl;
}

void Scene::logEnd(Cost const& loop) const
{
    if (nothingRun()) return;
    if (fluid_)
    {
        info() << "Particles: " << sumOverRanks(particles_.fluid().size()) << " fluid, " << sumOverRanks(particles_.boundary().size())
               << " boundary; " << fluid_->escaped() << " left the domain; pressure displacements limited " << fluid_->fluid().limited()
               << " times";
        if (particles_.lattice().dimensions == 3) info() << "; put back from behind walls " << fluid_->putBack() << " times";
        info() << "\n\n";
    }
    guard_->report(info());
    tellSeldom(info());
    printBill(info(), loop, particleSteps_);
    info() << std::endl;
}

} // namespace mpsDem
