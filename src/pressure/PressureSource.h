#pragma once

#include <optional>

#include "core/Step.h"
#include "particles/CorrectedDivergence.h"
#include "particles/NumberDensity.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Right side of eq 8: `sourceSchemes { type mixed; }`.
/// \f[ \langle\nabla^2 p\rangle_i = (1-\gamma)\frac{\rho}{\Delta t}\nabla\cdot\mathbf u_i^* - \gamma\frac{\rho}{\Delta t^2} e_i,\qquad e_i = \frac{n_i-n^0}{n^0} \f]
/// With this right side the pressure enforces eq 1, which is div u = 0 where the density is constant: u* has a divergence, u^{m+1} has none.
/// On walls e = 0. With a relaxation time tau instead of gamma: gamma = min(dt/tau, maxGamma), so that density errors decay in the
/// time tau whatever the time step, and the noise does not grow as dt falls.
///
/// | key | meaning | unit | default (standard and waves, paper) | range |
/// | type | mixed, density (first term off), divergence (second term off, gamma = 0) | - | mixed | - |
/// | relaxationTime | tau; 0: use gamma | s | 0.05 (waves: 0.02), 0 | 0..10 |
/// | gamma | gamma where relaxationTime is 0 | - | 0.01 | 0..1 |
/// | maxGamma | upper bound of dt/tau | - | 0.1 | 0..1 |
/// | densityClip | bound of abs(e); 0: none. A clip of 0.02 leaves foam above the submarine wedge that never closes | - | 0 | 0..1 |
/// | divergence | plain (eq 5), corrected (CorrectedDivergence.h) for fluid particles | - | plain; waves, and standard in 3-D: corrected | - |
/// | density | number (e as above); for fluid particles that have no surface beside them: smooth (SmoothDensity), balanced (0.7 smooth + 0.3 number) | - | number; waves: smooth; waves and standard in 3-D: balanced | - |
/// | rampSteps | gamma grows from 0 over the first steps of a run from rest | - | 20, 0 | 0..1000 |
class PressureSource
{
public:
    /// @param gradientRadius  [m]. @param density  rho [kg/m3].
    PressureSource(Dictionary const& sourceSchemes, SchemeSet set, Lattice const& lattice, Real gradientRadius, Real density);

    /// tau [s]; 0 where gamma is fixed, or no error of the density is corrected.
    [[nodiscard]] Real relaxationTime() const { return type_ == Type::Divergence ? 0 : relaxationTime_; }
    [[nodiscard]] bool corrected() const { return corrected_; }
    [[nodiscard]] bool smooth() const { return smooth_.has_value(); }
    /// Whether n has a share in that.
    [[nodiscard]] bool balanced() const { return numberShare_ > 0; }

    /// gamma of this step [-].
    [[nodiscard]] Real gamma(Step const& step) const;

    /// Share of rho div u*/dt in the right side: 1 - gamma, 0 where the term is off [-].
    [[nodiscard]] Real divergenceShare(Step const& step) const { return type_ == Type::Density ? 0 : 1 - gamma(step); }

    /// Divergence at particle i as the right side takes it, of a field phi(j) that need not be stored. [unit of phi per m]
    template <class Phi>
    [[nodiscard]] Real divergence(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                                  Phi const& phi, int i) const
    {
        if (!corrected_ || !particles.isFluid(i)) return mpsDem::divergence(particles, neighbours, constants, phi, i);
        return particles.lattice().dimensions == 2 ? correctedDivergence<2>(particles, neighbours, constants, phi, i)
                                                   : correctedDivergence<3>(particles, neighbours, constants, phi, i);
    }

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

    /// e of a fluid particle [-].
    [[nodiscard]] Real densityError(ParticleSet const& particles, NeighbourList const& neighbours, int i) const;

    Type type_;
    bool corrected_;
    std::optional<SmoothDensity> smooth_;
    Real numberShare_ = 0; ///< Of n in e, where the smooth density has the rest.
    Real density_, relaxationTime_, gamma_, maxGamma_, clip_;
    int rampSteps_;
};

} // namespace mpsDem
