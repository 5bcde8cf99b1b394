#include "scene/SolidStage.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/Errors.h"
#include "core/Timers.h"

namespace mpsDem {

SolidStage::SolidStage(std::vector<std::unique_ptr<RigidBody>>& bodies, std::unique_ptr<ContactModel> contacts,
                       std::vector<FluidBodyCoupling> couplings, Vector const& gravity, Ledger& ledger)
    : bodies_(bodies),
      contacts_(std::move(contacts)),
      couplings_(std::move(couplings)),
      gravity_(gravity)
{
    for (auto const& body : bodies_)
    {
        pointers_.push_back(body.get());
        body->setGravity(gravity);
    }
    gravityImpulse_ = &ledger.impulse("impulse/gravityOnBodies");
    contactImpulse_ = &ledger.impulse("impulse/contactAndSupport");
    if (contacts_)
    {
        contactDissipated_ = &ledger.energy("energy/contactDissipated");
        contactStored_ = &ledger.energy("energy/contactStored");
        if (!contacts_->latches().empty()) latched_ = &ledger.energy("energy/latch");
        contactTimer_ = Timers::add("contact", "contact");
    }
    motionTimer_ = Timers::add("body motion", "bodies");
    if (!couplings_.empty()) couplingTimer_ = Timers::add("pressure integration and added mass", "coupling");
}

void SolidStage::requireFinite(RigidBody const& body)
{
    bool const finite = body.centre().allFinite() && body.rotation().allFinite() && body.velocity().allFinite() &&
                        body.angularVelocity().allFinite() && body.acceleration().allFinite() && body.angularAcceleration().allFinite();
    if (finite) return;
    std::ostringstream text;
    text << "place or motion of body " << body.name() << " is not a finite number: centre (" << body.centre().transpose()
         << ") m, velocity (" << body.velocity().transpose() << ") m/s, acceleration (" << body.acceleration().transpose() << ") m/s2";
    throw CaseError(ExitCode::NotFinite, text.str(), "the last checkpoint is whole; a smaller maxCo or maxDeltaT may help");
}

void SolidStage::moveParticles(ParticleSet& particles)
{
    for (auto const& body : bodies_) requireFinite(*body);
    for (FluidBodyCoupling& coupling : couplings_) coupling.moveParticles(particles);
}

void SolidStage::predictParticles(ParticleSet& particles, Step const& step)
{
    for (FluidBodyCoupling& coupling : couplings_) coupling.predictParticles(particles, step.dt);
}

void SolidStage::loadBodies(FluidStage& fluid, Step const& step)
{
    if (couplings_.empty()) return;
    Timers::Scope const timer(Timers::stage(couplingTimer_));
    PressureResponse const response = [&](Field<Vector> const& acceleration, Field<Real>& pressure) {
        fluid.pressure().response(fluid.particles(), fluid.neighbours(), step, acceleration, pressure);
    };
    for (FluidBodyCoupling& coupling : couplings_) coupling.load(fluid.particles(), fluid.neighbours(), step, response);
    for (auto const& body : bodies_) body->fluid += body->handOverCollisions(step.dt);
}

void SolidStage::takeCollisions(std::span<Collision::Impulse const> impulses, Step const& step)
{
    for (std::size_t k = 0; k < std::min(impulses.size(), bodies_.size()); ++k)
    {
        if (!(impulses[k].amount > 0)) continue;
        RigidBody& body = *bodies_[k];
        Vector const centre = body.centre() - step.dt * body.velocity(); // where it was when the boundary particles were placed
        Load const about{impulses[k].linear, impulses[k].moment - centre.cross(impulses[k].linear)};
        body.addCollisions(about, impulses[k].amount, impulses[k].rate / impulses[k].amount);
    }
}

void SolidStage::advance(Step const& step)
{
    for (RigidBody* body : pointers_) body->beginStep();
    subSteps_ = contacts_ ? contacts_->subSteps(pointers_, step.dt) : 1;
    Real const h = step.dt / subSteps_;
    for (int k = 0; k < subSteps_; ++k)
    {
        if (contacts_)
        {
            Timers::Scope const timer(Timers::stage(contactTimer_));
            contacts_->addTo(pointers_, h);
        }
        Timers::Scope const timer(Timers::stage(motionTimer_));
        for (RigidBody* body : pointers_) body->advance(step.begin() + k * h, h);
    }
    for (RigidBody* body : pointers_)
    {
        body->endStep(step.dt);
        requireFinite(*body);
        *gravityImpulse_ += step.dt * body->gravityLoad().force;
        *contactImpulse_ += step.dt * (body->meanContactNormal().force + body->meanContactTangential().force + body->meanRestraint().force +
                                       body->meanReaction().force);
    }
    if (!contacts_) return;
    *contactDissipated_ = contacts_->dissipatedEnergy();
    *contactStored_ = contacts_->elasticEnergy();
    if (latched_ != nullptr) *latched_ = contacts_->latchedEnergy();
}

void SolidStage::correctPressure(ParticleSet& particles)
{
    for (FluidBodyCoupling& coupling : couplings_) coupling.correct(particles);
}

Real SolidStage::largestSpeed() const
{
    Real speed = 0;
    for (FluidBodyCoupling const& coupling : couplings_)
        for (Vector const& r : coupling.surface().position()) speed = std::max(speed, coupling.body().velocityAt(r).norm());
    for (auto const& body : bodies_) speed = std::max(speed, body->velocity().norm());
    return speed;
}

void SolidStage::save(State& state) const
{
    for (auto const& body : bodies_) body->save(state);
    for (FluidBodyCoupling const& coupling : couplings_) coupling.save(state);
    if (contacts_) contacts_->save(state);
}

void SolidStage::load(State const& state)
{
    for (FluidBodyCoupling& coupling : couplings_) coupling.load(state);
    if (contacts_) contacts_->load(state);
}

} // namespace mpsDem
