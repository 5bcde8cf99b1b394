#pragma once

#include <memory>
#include <string>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Gradient model of the pressure: `gradSchemes { grad(p) corrected; }`.
///
/// symmetric  eq 4 as printed, pairwise antisymmetric, contains p = 0 outside:
///            \f[ \langle\nabla p\rangle_i = \frac{d}{n^0}\sum_j \frac{p_j+p_i}{r_{ij}^2}\mathbf r_{ij} w_{ij} \f]
/// corrected  exact for linear fields (Khayyer and Gotoh 2011):
///            \f[ \langle\nabla p\rangle_i = \frac{d}{n^0} C_i \sum_j \frac{p_j-p_i}{r_{ij}^2}\mathbf r_{ij} w_{ij}, \quad
///                C_i^{-1} = \frac{d}{n^0}\sum_j \frac{\mathbf r_{ij}\mathbf r_{ij}^T}{r_{ij}^2} w_{ij} \f]
///            and eq 4 where det(C^-1) < 0.2, at the edges of jets and drops (default)
/// hybrid     corrected in the interior, eq 4 at and near the free surface; keeps the surface tidy, and takes 9 tenths of the
///            amplitude of a standing wave in ten periods
class GradientScheme
{
public:
    /// The scheme `name`; an unknown one is refused with the known ones. `grad(p)` of gradSchemes.
    static std::unique_ptr<GradientScheme> read(Dictionary const& gradSchemes, SchemeSet set);

    /// The name alone.
    static std::string readName(Dictionary const& gradSchemes, SchemeSet set);

    virtual ~GradientScheme() = default;

    /// Gradient of particles.p at every fluid particle into `gradient`, sized as the particles; other entries are left alone.
    /// Neighbours with mirror = 1 are seen with the asking particle's own pressure.
    virtual void evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                          Field<Vector>& gradient) const = 0;
};

} // namespace mpsDem
