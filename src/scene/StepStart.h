#pragma once

#include <memory>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Ledger.h"
#include "dem/ContactModel.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Copy of what a step changes, taken at its begin so that the step can be undone.
///
/// The particles are those after periodic wrap and sorting, which no length of the step changes: a step that is taken again does both once
/// more without effect. The memory is kept from step to step.
class StepStart
{
public:
    /// @param contacts  Null where nothing touches.
    void remember(ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies, ContactModel const* contacts,
                  Ledger const& ledger);
    /// Whether the begin of the present step is remembered.
    [[nodiscard]] bool known() const { return known_; }
    void forget() { known_ = false; }

    /// Of fluid particle i [m].
    [[nodiscard]] Vector const& position(ParticleSet const& particles, int i) const { return position_[i - particles.fluid().first]; }

    /// Makes all as it was. @pre known()
    void restore(ParticleSet& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies, ContactModel* contacts,
                 Ledger& ledger) const;

private:
    bool known_ = false;
    Field<Vector> position_, velocity_; ///< Of the fluid.
    Field<Real> pressure_;              ///< Of all owned particles, as the next two.
    Field<std::uint8_t> wet_;
    Field<SurfaceLabel> surface_;
    std::vector<RigidBody::Snapshot> bodies_;
    ContactModel::History contacts_;
    std::vector<Real> energies_; ///< Of the ledger, in its order.
    std::vector<Vector> impulses_;
};

} // namespace mpsDem
