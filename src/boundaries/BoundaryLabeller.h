#pragma once

#include <memory>

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/ReferenceConstants.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Labels boundary particles as wall (wet, an unknown of eq 8) or ghost (dry, no pressure): `boundarySchemes { labelling dynamic; }`.
///
/// dynamic  Dynamic Boundary particle Labelling (paper, Fig 2): a wall particle k is wet while a fluid particle j lies on its fluid
///          side within the wet radius: \f$ |\mathbf r_{kj}| < R \f$ and \f$ \mathbf r_{kj}\cdot\mathbf n_k > 0.3 |\mathbf r_{kj}| \f$, with R = wetRadius, or keepWetRadius if it
///          was wet in the step before. The half-space test keeps the fluid beside a slide from wetting the contact face.
///          A wet wall has p = 0 if all the fluid that wets it is free surface.
/// off      Every wall particle is wet (to repeat the right halves of Figs 7 and 8). p = 0 by the test on n and |F| of the fluid.
///
/// | key | meaning | unit | default | range |
/// | labelling | dynamic or off | - | dynamic | - |
/// | wetRadius | R of a dry particle | spacings | 1.5 | 0.5..3 |
/// | keepWetRadius | R of a wet particle | spacings | 1.7 | wetRadius..3 |
class BoundaryLabeller
{
public:
    /// The labeller that `boundarySchemes` asks for. @throw CaseError BadInput for an unknown word or a radius out of its range.
    static std::unique_ptr<BoundaryLabeller> read(Dictionary const& boundarySchemes, Lattice const& lattice);

    virtual ~BoundaryLabeller() = default;

    /// Sets wet and surface of wall particles. @pre the fluid's surface labels are those of this step.
    virtual void label(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& constants) const = 0;

    /// True where wall particles far from fluid need neighbours as well.
    [[nodiscard]] virtual bool needsAllWalls() const = 0;
};

} // namespace mpsDem
