#pragma once

#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/ReferenceConstants.h"

namespace mpsDem {

/// Particle number density and surface vector of every particle with a row:
/// \f[ n_i = \frac{1}{n^0}\sum_{j\ne i} w(r_{ij}), \qquad \mathbf F_i = \frac{d}{n^0}\sum_{j\ne i}\frac{\mathbf r_i-\mathbf r_j}{r_{ij}} w(r_{ij}) \f]
/// Fluid, wall (wet or dry) and ghost neighbours count alike. Writes particles.n and particles.F.
void numberDensity(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& constants);

/// Number density over that of the lattice with a smooth weight, the particle itself included:
/// \f[ \frac{1}{W^0}\Bigl(1+\sum_{j\ne i} W(r_{ij}/r_e)\Bigr), \qquad W(q) = (1-q)^4(1+4q) \f]
/// (Wendland 1995). A lattice drawn out by .15 along its rows at constant volume gives 1.0013, where n gives 1.028 to 1.033.
class SmoothDensity
{
public:
    /// @param radius  Effective radius r_e [m]: that of the gradient.
    SmoothDensity(Lattice const& lattice, Real radius);

    [[nodiscard]] Real operator()(ParticleSet const& particles, NeighbourList const& neighbours, int i) const;

private:
    Real perRadius_, lattice_; ///< 1/r_e [1/m]; W^0 [-].
};

/// Divergence, eq 5, with the gradient radius for particle i:
/// \f[ \langle\nabla\cdot\Phi\rangle_i = \frac{d}{n^0}\sum_{j\ne i}\frac{(\Phi_j-\Phi_i)\cdot\mathbf r_{ij}}{r_{ij}^2} w(r_{ij}) \f]
///
/// @param phi  phi(j) is the field at particle j. @return 1/s for velocities.
template <class Phi>
Real divergence(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants, Phi const& phi, int i)
{
    int const* const index = neighbours.index();
    Real const* const w = neighbours.gradientWeight();
    Vector const ri = particles.r[i], phi_i = phi(i);
    Real sum = 0;
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = index[k];
        Vector const rij = particles.r[j] - ri;
        sum += w[k] * (phi(j) - phi_i).dot(rij) / (rij.squaredNorm() + tiny);
    }
    return particles.lattice().dimensions / constants.n0 * sum;
}

} // namespace mpsDem
