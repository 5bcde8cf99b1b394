#pragma once

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Pressure of the boundary particles that are no unknowns, as the gradient of the fluid sees it.
///
/// Ghost particles get a Shepard mean over fluid and wet wall particles of their own body, with the hydrostatic change along the normal:
/// \f[ p_G = \frac{\sum_j w_{Gj}\,[\,p_j + \rho\,((\mathbf g-\mathbf a_w)\cdot\mathbf n)\,(\mathbf n\cdot(\mathbf r_G-\mathbf r_j))\,]}{\sum_j w_{Gj}} \f]
/// Dry walls carry none (p = 0, what is written); they and ghosts without donors are marked `mirror`: a fluid neighbour sees its own pressure there.
/// @param positiveOnly  Clamp at zero, as the fluid's pressure is.
void extrapolateBoundaryPressure(ParticleSet& particles, NeighbourList const& neighbours, Vector const& gravity, Real density,
                                 bool positiveOnly);

} // namespace mpsDem
