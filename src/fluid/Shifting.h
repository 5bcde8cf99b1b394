#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Particle shifting: `shiftingSchemes { type surfaceVector; coefficient 0.2; }`. Keeps the cloud regular.
/// \f[ \mathbf s_i = c_i\,l_0\,\mathbf F_i, \qquad
///     \delta\mathbf r_i = \mathbf s_i - \frac{\sum_j w_{ij}\,\mathbf s_j}{\sum_j w_{ij}}, \qquad |\delta\mathbf r_i| \le 0.1\,l_0 \f]
/// c_i is half of the coefficient c at rest and c itself from a Courant number |u| dt/l0 of 0.05: a flow disorders the cloud, and in water
/// that hardly moves a shift is noise. Only what differs from the neighbours' mean is taken: the mean is a drift from crests to troughs,
/// which took 7 % of the energy of a standing wave in each of its periods. At and near the free surface only the part along the surface
/// counts; splash is left alone. The mean runs over fluid of the same kind, on the surface or below it.
///
/// | key | meaning | unit | default (standard, paper) | range |
/// | type | surfaceVector or none | - | surfaceVector, none | - |
/// | coefficient | c | - | 0.2 | 0..1 |
/// | limit | longest shift | spacings | 0.1 | 0..0.5 |
/// | minDensity | n/n0 up to which a particle is not shifted | - | 0.8 | 0..1 |
/// | minSurfaceDensity | the same for a particle on the surface | - | 0.5 | 0..1 |
class Shifting
{
public:
    /// The model that `shiftingSchemes` asks for; null for `none`. @throw CaseError BadInput
    static std::unique_ptr<Shifting> read(Dictionary const& shiftingSchemes, SchemeSet set, Lattice const& lattice);

    /// The shifts s of fluid particles [m]; F and labels are those of the beginning of the step. The caller fills in those of the halo.
    Field<Vector>& propose(ParticleSet const& particles, NeighbourList const& neighbours, Real dt);
    /// Moves fluid particles by what their proposal differs from their neighbours'.
    void apply(ParticleSet& particles, NeighbourList const& neighbours) const;

private:
    enum class Kind
    {
        Fixed,   ///< Not shifted: walls and splash.
        Below,   ///< In the fluid.
        Surface, ///< On the free surface.
    };

    Shifting(Dictionary const& dict, Lattice const& lattice);
    [[nodiscard]] Kind kindOf(ParticleSet const& particles, int i) const;

    Real spacing_, factor_, limit_, minDensity_, minSurfaceDensity_;
    Field<Vector> proposed_;
};

} // namespace mpsDem
