#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Damping of ripples a spacing long: `freeSurfaceSchemes { damping 0.1; }`.
/// \f[ \mathbf u_i^* \mathrel{+}= \Delta t\,\beta\sqrt{\pi g/l_0}\;\frac{1}{w_l}\sum_j w_{ij}\,(\mathbf u_j - \mathbf u_i) \f]
/// over pairs of fluid particles that are both on or next to the free surface; w_l is the sum of w over a straight row of particles.
/// sqrt(pi g/l0) is the frequency of the shortest gravity wave that the particles carry. The consistent pressure gradient has nothing that
/// would damp it, and in still water its amplitude grows to a tenth of a spacing. Momentum is conserved pair by pair. Without gravity there
/// are no such waves, and nothing is done.
///
/// | key | meaning | unit | default (standard, paper) | range |
/// | damping | beta | - | 0.1, 0 | 0..1 |
class SurfaceDamping
{
public:
    /// @return nothing where the case has no gravity or a damping of 0.
    static std::unique_ptr<SurfaceDamping> read(Dictionary const& freeSurfaceSchemes, SchemeSet set, Lattice const& lattice,
                                                Real gradientRadius, Real gravity);

    /// Adds to uStar of the fluid. @param dt [s].
    void addTo(ParticleSet& particles, NeighbourList const& neighbours, Real dt) const;

private:
    explicit SurfaceDamping(Real rate) : rate_(rate) {}

    Real rate_; ///< beta sqrt(pi g/l0)/w_l [1/s].
};

} // namespace mpsDem
