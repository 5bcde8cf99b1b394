#pragma once

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/ReferenceConstants.h"

namespace mpsDem {

/// Particle number density and surface vector of every particle with a row:
/// \f[ n_i = \frac{1}{n^0}\sum_{j\ne i} w(r_{ij}), \qquad \mathbf F_i = \frac{d}{n^0}\sum_{j\ne i}\frac{\mathbf r_i-\mathbf r_j}{r_{ij}} w(r_{ij}) \f]
/// Fluid, wall (wet or dry) and ghost neighbours count alike. Writes particles.n and particles.F.
void numberDensity(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& constants);

/// Divergence, eq 5, with the gradient radius for particle i and any vector field over all particles [1/s for velocities]:
/// \f[ \langle\nabla\cdot\Phi\rangle_i = \frac{d}{n^0}\sum_{j\ne i}\frac{(\Phi_j-\Phi_i)\cdot\mathbf r_{ij}}{r_{ij}^2} w(r_{ij}) \f]
Real divergence(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                Field<Vector> const& phi, int i);

} // namespace mpsDem
