#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/PeriodicImages.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Viscous term nu <lap u> of eq 2 by eq 6: `viscositySchemes { type explicit; walls slip; }`. Built only where nu > 0 and type is not none.
///
/// The factor 2d/(n0 lambda) of eq 6 holds on the lattice. In a flow the cloud is disordered, the sum of w r^2 about 7 % larger than
/// n0 lambda, and the viscosity would be so, too. Each pair takes the share min(1, e B e) of the factor, mean of both its particles, with
/// e the direction from one to the other and \f$ B_i = \frac{n^0\lambda}{d}\bigl(\sum_j w_{ij}\mathbf r_{ij}\mathbf r_{ij}^T\bigr)^{-1} \f$.
///
/// | key | meaning | default |
/// | type | none, explicit, implicit, or auto: implicit where nu dt/dx^2 may exceed 1/8 with the largest time step | auto |
/// | walls | slip: wall and ghost particles take no part; noSlip: they do, with the wall's velocity on its surface | slip |
/// | tolerance | implicit: residual relative to the right side | 1e-8 |
class Viscosity
{
public:
    /// @param nu           Kinematic viscosity [m2/s].
    /// @param largestDt    Largest time step of the run [s], for `auto`.
    /// @return empty where the case has no viscous term.
    static std::unique_ptr<Viscosity> read(Dictionary const& viscositySchemes, Lattice const& lattice, Real nu, Real largestDt);

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
