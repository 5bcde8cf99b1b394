#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/PeriodicImages.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Pressure of the particles on the free surface: `freeSurfaceSchemes { pressure halfSpacing; }`.
///
/// The water ends half a spacing outside of the centre of a surface particle, and p = 0 holds there, not at the centre:
/// \f[ p_i = \max\Bigl(0, -\frac{l_0}{2}\,\mathbf n_i\cdot\langle\nabla p\rangle_i\Bigr), \qquad \mathbf n_i = \mathbf F_i/|\mathbf F_i| \f]
/// with the corrected gradient of the last step's pressure over fluid and wet walls, averaged with the surface particles beside it, and at
/// most half the largest pressure around. It is zero in free flight. With p = 0 at the centres and a consistent gradient all pressure is
/// rho g l0/2 too low; eq 4 (`symmetric`, `hybrid`) contains the half spacing already.
///
/// | key | meaning | default |
/// | pressure | halfSpacing, or zero: p = 0 at the centres | halfSpacing where `grad(p)` is corrected, else zero |
class SurfacePressure
{
public:
    /// @return nothing where it is zero.
    static std::unique_ptr<SurfacePressure> read(Dictionary const& freeSurfaceSchemes, Dictionary const& gradSchemes, SchemeSet set);

    /// From the pressure of the last step and the present positions and labels.
    void evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                  PeriodicImages const& images);

    /// Of a fluid particle or wet wall particle with the label Surface [Pa].
    [[nodiscard]] Real operator[](int i) const { return value_[i]; }

    /// Writes it to particles.p of all owned particles with the label Surface that are fluid or wet wall.
    void assign(ParticleSet& particles) const;

private:
    void average(ParticleSet const& particles, NeighbourList const& neighbours, int i);

    Field<Real> single_, value_; ///< Before and after the average [Pa].
};

} // namespace mpsDem
