#pragma once

#include <memory>
#include <string>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/PeriodicImages.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Viscous term nu <lap u> of eq 2 by eq 6: `viscositySchemes { type explicit; walls slip; }`. Built only where it has an effect.
///
/// The factor 2d/(n0 lambda) of eq 6 holds on the lattice. In a flow the cloud is disordered and drawn into rows by the shear, and its second
/// moment sum of w r r^T is neither as large as on the lattice nor the same in all directions: nor would be the viscosity. Each pair takes the
/// share e S e of the factor, mean of both its particles, with e the direction from one to the other and S_i the symmetric tensor of
/// \f[ \sum_j w_{ij}\,r_{ij}^2\,(\mathbf e\cdot S_i\mathbf e)\,\mathbf e\,\mathbf e^T = \frac{n^0\lambda}{d}\,I : \f]
/// a uniform shear then has the stress of nu. Shares lie within 0.25 and 1.25 (1 at and near the free surface). Momentum is conserved pair by
/// pair, but for those with walls.
///
/// | key | meaning | default |
/// | type | none, explicit, implicit, or auto: with the largest time step none where walls slip and nu dt/dx^2 is at most 1e-5, implicit where it
///   may exceed 1/8, else explicit | auto |
/// | walls | slip: wall and ghost particles take no part; noSlip: they do, with the wall's velocity on its surface | slip |
/// | tolerance | implicit: residual relative to the right side | 1e-8 |
class Viscosity
{
public:
    /// @param nu           Kinematic viscosity [m2/s].
    /// @param largestDt    Largest time step of the run [s], for `auto`.
    /// @return empty where the case has no viscous term.
    static std::unique_ptr<Viscosity> read(Dictionary const& viscositySchemes, Lattice const& lattice, Real nu, Real largestDt);

    /// Why the case has none; empty where it has a viscous term. Arguments as of read().
    static std::string whyAbsent(Dictionary const& viscositySchemes, Lattice const& lattice, Real nu, Real largestDt);

    virtual ~Viscosity() = default;

    /// Adds dt nu <lap u> to u* of the fluid. On entry particles.uStar holds u + dt g for the fluid and the wall velocity for walls.
    virtual void addTo(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images,
                       ReferenceConstants const& laplacian, Real dt) = 0;

    /// Largest stable time step [s]; infinity for the implicit form.
    [[nodiscard]] virtual Real largestStableDt() const = 0;

    /// For the log, e.g. "explicit".
    [[nodiscard]] virtual char const* name() const = 0;
};

} // namespace mpsDem
