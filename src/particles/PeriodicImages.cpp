#include "particles/PeriodicImages.h"

#include <cmath>

namespace mpsDem {

PeriodicImages::PeriodicImages(Vector const& low, Vector const& high) : low_(low), high_(high)
{
    for (int d = 0; d < 3; ++d) periodic_[d] = high[d] > low[d];
}

bool PeriodicImages::contains(Vector const& r) const
{
    for (int d = 0; d < 3; ++d)
        if (periodic_[d] && (r[d] < low_[d] || r[d] >= high_[d])) return false;
    return true;
}

void PeriodicImages::wrap(ParticleSet& particles) const
{
    for (int d = 0; d < 3; ++d)
    {
        if (!periodic_[d]) continue;
        Real const length = high_[d] - low_[d];
        for (int i : particles.fluid()) particles.r[i][d] -= length * std::floor((particles.r[i][d] - low_[d]) / length);
    }
}

void PeriodicImages::rebuild(ParticleSet& particles, Real reach)
{
    if (!any()) return;
    particles.dropHalo();
    source_.clear();
    shift_.clear();
    auto const add = [&](int original, Vector const& shift) {
        source_.push_back(original);
        shift_.push_back(shift);
    };
    // Direction after direction, images of images included, so that edges and corners are filled.
    auto const imagesOf = [&](int original, Vector const& r, Vector const& shift, int d) {
        Vector const length = Vector::Unit(d) * (high_[d] - low_[d]);
        if (r[d] < low_[d] + reach) add(original, shift + length);
        if (r[d] > high_[d] - reach) add(original, shift - length);
    };
    for (int d = 0; d < 3; ++d)
    {
        if (!periodic_[d]) continue;
        std::size_t const before = source_.size();
        for (int i : particles.owned()) imagesOf(i, particles.r[i], Vector::Zero(), d);
        for (std::size_t k = 0; k < before; ++k) imagesOf(source_[k], particles.r[source_[k]] + shift_[k], Vector(shift_[k]), d);
    }
    particles.appendHalo(static_cast<int>(source_.size()));
    Range const halo = particles.halo();
    update(particles.r, halo);
    for (int i : halo) particles.r[i] += shift_[i - halo.first];
    update(particles.u, halo);
    update(particles.p, halo);
    update(particles.id, halo);
    update(particles.type, halo);
    update(particles.body, halo);
    update(particles.normal, halo);
    update(particles.wet, halo);
}

} // namespace mpsDem
