#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Particle shifting: `shiftingSchemes { type surfaceVector; coefficient 0.2; }`. Keeps the cloud regular.
/// \f[ \delta\mathbf r_i = c\,l_0\,\mathbf F_i, \qquad |\delta\mathbf r_i| \le 0.1\,l_0 \f]
/// Near the free surface only the part along the surface, on it and in splash (n/n0 <= minDensity) none.
///
/// | key | meaning | unit | default (standard, paper) | range |
/// | type | surfaceVector or none | - | surfaceVector, none | - |
/// | coefficient | c | - | 0.2 | 0..1 |
/// | limit | longest shift | spacings | 0.1 | 0..0.5 |
/// | minDensity | n/n0 up to which a particle is not shifted | - | 0.8 | 0..1 |
class Shifting
{
public:
    static std::unique_ptr<Shifting> read(Dictionary const& shiftingSchemes, SchemeSet set, Lattice const& lattice);

    /// Moves fluid particles; F and labels are those of the beginning of the step.
    void apply(ParticleSet& particles, NeighbourList const& neighbours) const;

private:
    Shifting(Dictionary const& dict, Lattice const& lattice);

    Real factor_, limit_, minDensity_;
};

} // namespace mpsDem
