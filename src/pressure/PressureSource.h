#pragma once

#include "core/Step.h"
#include "particles/NumberDensity.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Right side of eq 8: `sourceSchemes { type mixed; }`.
/// \f[ \langle\nabla^2 p\rangle_i = (1-\gamma)\frac{\rho}{\Delta t}\nabla\cdot\mathbf u_i^* - \gamma\frac{\rho}{\Delta t^2} e_i,\qquad e_i = \frac{n_i-n^0}{n^0} \f]
/// With this right side the pressure enforces eq 1, which is div u = 0 where the density is constant: u* has a divergence, u^{m+1} has none.
/// On walls e = 0. With a relaxation time tau instead of gamma: gamma = min(dt/tau, maxGamma), so that density errors decay in the
/// time tau whatever the time step, and the noise does not grow as dt falls.
///
/// | key | meaning | unit | default (standard, paper) | range |
/// | type | mixed, density (first term off), divergence (second term off, gamma = 0) | - | mixed | - |
/// | relaxationTime | tau; 0: use gamma | s | 0.05, 0 | 0..10 |
/// | gamma | gamma where relaxationTime is 0 | - | 0.01 | 0..1 |
/// | maxGamma | upper bound of dt/tau | - | 0.1 | 0..1 |
/// | densityClip | bound of abs(e); 0: none. A clip of 0.02 leaves foam above the submarine wedge that never closes | - | 0 | 0..1 |
/// | rampSteps | gamma grows from 0 over the first steps of a run from rest | - | 20, 0 | 0..1000 |
class PressureSource
{
public:
    PressureSource(Dictionary const& sourceSchemes, SchemeSet set, Real density);

    /// gamma of this step [-].
    [[nodiscard]] Real gamma(Step const& step) const;

    /// Share of rho div u*/dt in the right side: 1 - gamma, 0 where the term is off [-].
    [[nodiscard]] Real divergenceShare(Step const& step) const { return type_ == Type::Density ? 0 : 1 - gamma(step); }

    /// Right side of eq 8 for particle i [Pa/m2].
    [[nodiscard]] Real evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                                Step const& step, int i) const;

private:
    enum class Type
    {
        Mixed,
        Density,
        Divergence
    };

    Type type_;
    Real density_, relaxationTime_, gamma_, maxGamma_, clip_;
    int rampSteps_;
};

} // namespace mpsDem
