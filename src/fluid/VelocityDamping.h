#pragma once

#include <memory>

#include "core/Dictionary.h"
#include "particles/Lattice.h"
#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/PeriodicImages.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Damping of what neighbouring velocities have beyond a linear field: `velocityDamping { type deviation; }`.
/// \f[ \mathbf u_i^* \mathrel{+}= \Delta t\,\beta\sqrt{\pi g/l_0}\;\frac{1}{n^0}\sum_j w_{ij}
///     \left(\mathbf u_j - \mathbf u_i - \tfrac12(\mathbf L_i+\mathbf L_j)\,\mathbf r_{ij}\right),\qquad
///     \mathbf L_i = \frac{d}{n^0}\sum_j w_{ij}\frac{(\mathbf u_j-\mathbf u_i)\otimes\mathbf r_{ij}}{r_{ij}^2}\,\mathbf C_i \f]
/// over pairs of fluid particles below the surface. The pressure can't act on eddies of a spacing's size: they live for ever and mix momentum like a
/// viscosity. A linear field is not touched, nor (in the interior) a quadratic one, so that a wave of n
/// spacings loses of the order of (2 pi/n)^4 of what it would lose to a viscosity. Momentum is conserved pair by pair. The rate is that of
/// SurfaceDamping; without gravity nothing is done.
///
/// | key | meaning | unit | default | range |
/// | type | deviation, none | - | none; set `waves`: deviation | - |
/// | coefficient | beta | - | 1 | 0..10 |
class VelocityDamping
{
public:
    /// @param velocityDamping  The dictionary. @param n0  Of the gradient radius. @param gravity [m/s2].
    /// @return nothing where it is switched off or the case has no gravity.
    static std::unique_ptr<VelocityDamping> read(Dictionary const& velocityDamping, SchemeSet set, Lattice const& lattice, Real n0,
                                                 Real gravity);

    /// Adds to uStar of the fluid, from u. @param dt [s].
    void addTo(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt);

private:
    VelocityDamping(Real rate, Real n0) : rate_(rate), n0_(n0) {}
    template <int d>
    void findGradients(ParticleSet const& particles, NeighbourList const& neighbours);

    Real rate_; ///< beta sqrt(pi g/l0) [1/s].
    Real n0_;
    Field<Tensor> gradient_;      ///< L of the fluid particles [1/s].
    Field<std::uint8_t> defined_; ///< Whether a particle takes part: not on the free surface, enough neighbours for L.
};

} // namespace mpsDem
