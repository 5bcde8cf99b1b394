#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/FluidBodyCoupling.h"
#include "dem/ContactModel.h"
#include "scene/FluidStage.h"

namespace mpsDem {

/// Rigid bodies, their contacts and, where there is fluid, their coupling to it: the stages of a step that a scene with bodies has.
class SolidStage
{
public:
    /// @param contacts  Empty where constant/contactProperties is absent: nothing touches anything then.
    SolidStage(std::vector<std::unique_ptr<RigidBody>>& bodies, std::unique_ptr<ContactModel> contacts,
               std::vector<FluidBodyCoupling> couplings, Vector const& gravity, Ledger& ledger);

    /// @throw CaseError NotFinite for a body whose place or motion is no number.
    static void requireFinite(RigidBody const& body);

    /// Before the fluid's neighbours: boundary particles follow their bodies.
    void moveParticles(ParticleSet& particles);
    /// u* of the boundary particles.
    void predictParticles(ParticleSet& particles, Step const& step);
    /// Eqs 15-16 for this step's pressure, added mass where the coupling is strong.
    void loadBodies(FluidStage& fluid, Step const& step);
    /// Contact sub-steps (eqs 11-12) and motion (eqs 13-14).
    void advance(Step const& step);
    /// What particles of the fluid gave up to the bodies in this step's collisions: a load of the next steps.
    void takeCollisions(std::span<Collision::Impulse const> impulses, Step const& step);
    /// Corrects pressure and loads for the acceleration found (strong coupling).
    void correctPressure(ParticleSet& particles);

    /// Largest speed of any surface point of a moving body [m/s].
    [[nodiscard]] Real largestSpeed() const;
    [[nodiscard]] ContactModel const* contacts() const { return contacts_.get(); }
    [[nodiscard]] ContactModel* contacts() { return contacts_.get(); }
    [[nodiscard]] std::vector<FluidBodyCoupling> const& couplings() const { return couplings_; }
    [[nodiscard]] std::vector<std::unique_ptr<RigidBody>> const& bodies() const { return bodies_; }
    /// Contact sub-steps of the last step.
    [[nodiscard]] int subSteps() const { return subSteps_; }

    void save(State& state) const;
    void load(State const& state);

private:
    std::vector<std::unique_ptr<RigidBody>>& bodies_;
    std::vector<RigidBody*> pointers_;
    std::unique_ptr<ContactModel> contacts_;
    std::vector<FluidBodyCoupling> couplings_;
    Vector gravity_;
    int subSteps_ = 1;
    Vector* contactImpulse_ = nullptr; ///< Ledger: contact, restraints, holds.
    Vector* gravityImpulse_ = nullptr;
    Real* contactDissipated_ = nullptr;
    Real* contactStored_ = nullptr;
    Real* latched_ = nullptr; ///< Ledger; only where there is a latch.
    int couplingTimer_ = -1, contactTimer_ = -1, motionTimer_ = -1;
};

} // namespace mpsDem
