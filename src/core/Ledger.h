#pragma once

#include <map>
#include <string>

#include "core/State.h"
#include "core/Types.h"

namespace mpsDem {

/// Running sums that the stages of a step keep for budgets, by name: energies [J] and impulses [N s].
///
/// A stage asks for its entry once, in its constructor, and adds to it. A budget reads whatever entries exist, so an effect that is off has none.
///   energy:  "energy/collision", "energy/contactDissipated", "energy/contactStored",
///            "energy/latch", "energy/walls" (taken by WallGuard in 3-D)
///   impulse: "impulse/gravityOnBodies", "impulse/contactAndSupport", "impulse/collisionWithWalls"; only for an observer that asks:
///            "impulse/gravityOnFluid", "impulse/walls" (all from outside on water plus bodies)
/// A new entry of a stage belongs in the list in Ledger.cpp, too.
class Ledger
{
public:
    /// The entry `name`, zero when new; the reference stays valid.
    Vector& impulse(std::string const& name) { return impulses_.try_emplace(name, Vector::Zero()).first->second; }
    Real& energy(std::string const& name) { return energies_.try_emplace(name, 0.0).first->second; }

    [[nodiscard]] std::map<std::string, Real> const& energies() const { return energies_; }
    [[nodiscard]] std::map<std::string, Vector> const& impulses() const { return impulses_; }

    /// Entries that exist now, and zero for each stage's whose effect is off: nothing was added to it.
    void save(State& state) const;
    /// Loads the entries that exist now. One of an observer that the state does not know begins at zero, and the log says so.
    /// @throw CaseError InputOutput where an entry of a stage is missing.
    void load(State const& state);

private:
    std::map<std::string, Real> energies_;
    std::map<std::string, Vector> impulses_;
};

} // namespace mpsDem
