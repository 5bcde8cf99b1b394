#include "core/Ledger.h"

#include <algorithm>
#include <array>

#include "core/Log.h"

namespace mpsDem {

namespace {

/// Entries that every saved state has.
constexpr std::array stageEnergies{"energy/collision", "energy/contactDissipated", "energy/contactStored", "energy/latch", "energy/walls"};
constexpr std::array stageImpulses{"impulse/collisionWithWalls", "impulse/contactAndSupport", "impulse/gravityOnBodies"};
/// Entries that exist only while an observer asks for them.
constexpr std::array observerImpulses{"impulse/gravityOnFluid", "impulse/walls"};

std::string blockOf(std::string const& name) { return "ledger/" + name; }

} // namespace

void Ledger::save(State& state) const
{
    for (std::string const name : stageEnergies) state.set(blockOf(name), Real(0));
    for (std::string const name : stageImpulses) state.set(blockOf(name), Vector(Vector::Zero()));
    for (auto const& [name, value] : energies_) state.set(blockOf(name), value);
    for (auto const& [name, value] : impulses_) state.set(blockOf(name), value);
}

void Ledger::load(State const& state)
{
    for (auto& [name, value] : energies_) value = state.real(blockOf(name));
    for (auto& [name, value] : impulses_)
    {
        bool const observed = std::find(observerImpulses.begin(), observerImpulses.end(), name) != observerImpulses.end();
        bool const fresh = observed && !state.has(blockOf(name));
        value = fresh ? Vector(Vector::Zero()) : state.vector(blockOf(name));
        if (fresh)
            info() << "Saved state without " << name << ": no function object asked for it; it is summed up from now on" << std::endl;
    }
}

} // namespace mpsDem
