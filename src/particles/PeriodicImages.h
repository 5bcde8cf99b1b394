#pragma once

#include "particles/ParticleSet.h"
#include <array>

namespace mpsDem {

/// Periodic directions: copies of the particles near one side stand as halo behind the other side.
class PeriodicImages
{
public:
    /// No periodic direction.
    PeriodicImages() = default;
    /// @param low, high  Corners of the periodic box [m]; a direction with low >= high is not periodic.
    PeriodicImages(Vector const& low, Vector const& high);

    [[nodiscard]] bool any() const { return periodic_[0] || periodic_[1] || periodic_[2]; }

    /// False for a point outside of the box in a periodic direction: an image stands there, if anything.
    [[nodiscard]] bool contains(Vector const& r) const;

    /// Moves particles that have left the box to the other side.
    void wrap(ParticleSet& particles) const;
    /// Makes the halo: images within `reach` of the box, with all state of their originals.
    void rebuild(ParticleSet& particles, Real reach);
    /// Copies new values of the originals to the halo.
    template <class T>
    void update(Field<T>& field, Range const& halo) const
    {
        for (int i : halo) field[i] = field[source_[i - halo.first]];
    }
    /// Original of a halo particle; of any other particle itself.
    [[nodiscard]] int source(ParticleSet const& particles, int i) const
    {
        return i < particles.owned().last ? i : source_[i - particles.owned().last];
    }

private:
    Vector low_ = Vector::Zero(), high_ = Vector::Zero();
    std::array<bool, 3> periodic_{false, false, false};
    Field<int> source_;
    Field<Vector> shift_; ///< From the original to its image [m].
};

} // namespace mpsDem
