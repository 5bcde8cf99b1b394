#include "particles/NumberDensity.h"

#include <cmath>

namespace mpsDem {

void numberDensity(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& constants)
{
    int const* const index = neighbours.index();
    Real const* const w = neighbours.gradientWeight();
    Real const factor = particles.lattice().dimensions / constants.n0;
    for (int i : particles.owned())
    {
        Vector const ri = particles.r[i];
        Vector F = Vector::Zero();
        Real n = 0;
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            Vector const rij = particles.r[index[k]] - ri;
            n += w[k];
            F -= w[k] / std::sqrt(rij.squaredNorm() + tiny) * rij;
        }
        particles.n[i] = n / constants.n0;
        particles.F[i] = factor * F;
    }
}

Real divergence(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                Field<Vector> const& phi, int i)
{
    int const* const index = neighbours.index();
    Real const* const w = neighbours.gradientWeight();
    Vector const ri = particles.r[i], phi_i = phi[i];
    Real sum = 0;
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = index[k];
        Vector const rij = particles.r[j] - ri;
        sum += w[k] * (phi[j] - phi_i).dot(rij) / (rij.squaredNorm() + tiny);
    }
    return particles.lattice().dimensions / constants.n0 * sum;
}

} // namespace mpsDem
