#include "particles/NumberDensity.h"

#include <cmath>

namespace mpsDem {

namespace {

/// W(q) = (1 - q)^4 (1 + 4 q), zero from q = 1.
Real wendland(Real q)
{
    Real const a = std::max(Real(0), 1 - q), square = a * a;
    return square * square * (1 + 4 * q);
}

} // namespace

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

SmoothDensity::SmoothDensity(Lattice const& lattice, Real radius) : perRadius_(1 / radius), lattice_(0)
{
    int const n = static_cast<int>(radius / lattice.spacing), depth = lattice.dimensions == 3 ? n : 0;
    for (int x = -n; x <= n; ++x)
        for (int y = -n; y <= n; ++y)
            for (int z = -depth; z <= depth; ++z) lattice_ += wendland(lattice.spacing * perRadius_ * Vector(x, y, z).norm());
}

Real SmoothDensity::operator()(ParticleSet const& particles, NeighbourList const& neighbours, int i) const
{
    Real sum = 1;
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        sum += wendland(perRadius_ * (particles.r[neighbours.index()[k]] - particles.r[i]).norm());
    return sum / lattice_;
}

} // namespace mpsDem
