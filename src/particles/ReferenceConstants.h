#pragma once

#include "particles/Kernel.h"
#include "particles/Lattice.h"

namespace mpsDem {

/// Sums over the full cubic lattice of the start, for one effective radius. Computed at start-up, never typed in.
struct ReferenceConstants
{
    Real n0;           ///< Particle number density n^0 = sum of w [-].
    Real lambda;       ///< eq 7 [m2].
    Real planeSurface; ///< |F|_0, length of the surface vector of a particle on a plane free surface [-].

    /// Factor 2 d / (n0 lambda) of eq 6 [1/m2].
    [[nodiscard]] Real laplacianFactor(int dimensions) const { return 2.0 * dimensions / (n0 * lambda); }
};

/// @param radius  Effective radius r_e [m]; up to 8 spacings.
ReferenceConstants referenceConstants(Lattice const& lattice, Real radius);

} // namespace mpsDem
