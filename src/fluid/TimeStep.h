#pragma once

#include "core/Dictionary.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Length of the next step from the state of the fluid. Keys of system/controlDict:
/// \f[ \Delta t = \min\left( C\,\frac{l_0}{|\mathbf u|_{max}},\; C_p \frac{l_0}{\sqrt{p_{95}/\rho}},\; \Delta t_\nu,\; \Delta t_{max},\; 1.1\,\Delta t_{last} \right) \f]
/// with p_95 the 95th percentile of the pressure: in still water sqrt(p/rho) ~ sqrt(g H) limits the step where |u| = 0 does not.
///
/// | key | meaning | unit | default | range |
/// | adjustTimeStep | no: every step is deltaT | - | yes | - |
/// | deltaT | first step, or every step | s | none | > 0 |
/// | maxCo | C | - | 0.25 | 0..2 |
/// | maxPressureCo | C_p | - | 0.25 | 0..2 |
/// | maxDeltaT | upper bound | s | 1e300 | > 0 |
class TimeStep
{
public:
    TimeStep(Dictionary const& controlDict, Lattice const& lattice);

    /// adjustTimeStep; the longest step allowed [s]; the first step [s].
    [[nodiscard]] bool adjustable() const { return adjustable_; }
    [[nodiscard]] Real largest() const { return adjustable_ ? maxDeltaT_ : deltaT_; }
    [[nodiscard]] Real first() const { return deltaT_; }

    /// What the flow allows: all bounds of \f$\Delta t\f$ but that by the last step; deltaT where the step is fixed [s].
    /// @param bodySpeed   Largest speed of a point of a moving body [m/s].
    /// @param viscousDt   Limit of the viscous term [s].
    [[nodiscard]] Real limit(ParticleSet const& particles, Real density, Real bodySpeed, Real viscousDt) const;
    /// The next step of what the flow allows [s].
    /// @param last        Length of the last step before it was cut to meet a write time [s]; first() at the start.
    [[nodiscard]] Real next(Real limit, Real last) const;

    /// Numbers of the last call, for the log: |u| dt / l0, mean and largest.
    struct Courant
    {
        Real mean = 0, max = 0;
    };
    /// Over the fluid, for a step dt [s].
    [[nodiscard]] Courant courant(ParticleSet const& particles, Real dt) const;

private:
    [[nodiscard]] Real pressurePercentile(ParticleSet const& particles) const;

    Lattice lattice_;
    bool adjustable_;
    Real deltaT_, maxCo_, maxPressureCo_, maxDeltaT_;
    mutable Field<Real> work_;
};

} // namespace mpsDem
