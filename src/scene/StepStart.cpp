#include "scene/StepStart.h"

#include <algorithm>

#include "core/Errors.h"

namespace mpsDem {

namespace {

template <class T>
void copyRange(Field<T> const& from, Range const& range, Field<T>& to)
{
    to.assign(from.begin() + range.first, from.begin() + range.last);
}

} // namespace

void StepStart::remember(ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies, ContactModel const* contacts,
                         Ledger const& ledger)
{
    copyRange(particles.r, particles.fluid(), position_);
    copyRange(particles.u, particles.fluid(), velocity_);
    copyRange(particles.p, particles.owned(), pressure_);
    copyRange(particles.wet, particles.owned(), wet_);
    copyRange(particles.surface, particles.owned(), surface_);
    bodies_.resize(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) bodies_[k] = bodies[k]->snapshot();
    if (contacts) contacts->copyTo(contacts_);
    energies_.clear();
    impulses_.clear();
    for (auto const& [name, value] : ledger.energies()) energies_.push_back(value);
    for (auto const& [name, value] : ledger.impulses()) impulses_.push_back(value);
    known_ = true;
}

void StepStart::restore(ParticleSet& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies, ContactModel* contacts,
                        Ledger& ledger) const
{
    particles.dropHalo();
    expect(known_ && particles.owned().size() == static_cast<int>(pressure_.size()), "the begin of this step is known");
    std::copy(position_.begin(), position_.end(), particles.r.begin() + particles.fluid().first);
    std::copy(velocity_.begin(), velocity_.end(), particles.u.begin() + particles.fluid().first);
    std::copy(pressure_.begin(), pressure_.end(), particles.p.begin());
    std::copy(wet_.begin(), wet_.end(), particles.wet.begin());
    std::copy(surface_.begin(), surface_.end(), particles.surface.begin());
    for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k]->restore(bodies_[k]);
    if (contacts) contacts->restore(contacts_);
    std::size_t k = 0;
    for (auto const& [name, value] : ledger.energies()) ledger.energy(name) = energies_[k++];
    k = 0;
    for (auto const& [name, value] : ledger.impulses()) ledger.impulse(name) = impulses_[k++];
}

} // namespace mpsDem
