#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Finds the fluid particles of the free surface (eq 9 and eq 10 are missing in the paper's text): `freeSurfaceSchemes { type cone; }`.
///
/// With n_i and F_i as numberDensity() leaves them and |F|_0 the value of a plane surface, particle i is on the surface if
///   cone           n_i < lowDensity (0.7; 0.65 in 3-D), or |F_i| > 0.5 |F|_0 and no neighbour of any type lies within coneRadius
///                  (2.1 spacings) in the cone of half-angle coneAngle (45 degrees) about F_i            (default of `standard`)
///   sjtu           n_i < 0.8, or n_i <= 0.97 and |F_i| > 0.9 |F|_0                                       (default of `paper`)
///   numberDensity  n_i < 0.97                                                                            (Koshizuka and Oka 1996)
///   none           never: a flow without free surface
///
/// | key | meaning | unit | default | range |
/// | lowDensity | below this n/n0 always surface | - | 0.7 (2-D), 0.65 (3-D), 0.8 (sjtu), 0.97 (numberDensity) | 0..1 |
/// | highDensity | above this n/n0 never surface (sjtu) | - | 0.97 | 0..2 |
/// | vectorThreshold | share of the plane surface's vector length | - | 0.5 (cone), 0.9 (sjtu) | 0..2 |
/// | coneRadius | reach of the cone | spacings | 2.1 | 1..4 |
/// | coneAngle | half-angle of the cone | degrees | 45 | 10..90 |
class FreeSurface
{
public:
    /// The test that `freeSurfaceSchemes` asks for, its defaults from the set. @throw CaseError BadInput
    static std::unique_ptr<FreeSurface> read(Dictionary const& freeSurfaceSchemes, SchemeSet set, Lattice const& lattice);

    virtual ~FreeSurface() = default;

    /// Sets particles.surface of the fluid to Surface or Interior.
    virtual void mark(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& constants) const = 0;
};

/// Changes Interior to NearSurface for fluid particles that have a surface particle within the gradient radius.
void markNearSurface(ParticleSet& particles, NeighbourList const& neighbours);

} // namespace mpsDem
