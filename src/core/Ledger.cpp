#include "core/Ledger.h"

namespace mpsDem {

void Ledger::save(State& state) const
{
    for (auto const& [name, value] : energies_) state.set("ledger/" + name, value);
    for (auto const& [name, value] : impulses_) state.set("ledger/" + name, value);
}

void Ledger::load(State const& state)
{
    for (auto& [name, value] : energies_)
        if (state.has("ledger/" + name)) value = state.real("ledger/" + name);
    for (auto& [name, value] : impulses_)
        if (state.has("ledger/" + name)) value = state.vector("ledger/" + name);
}

} // namespace mpsDem
