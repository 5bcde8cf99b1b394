#include "fluid/SurfaceDamping.h"

#include <cmath>
#include <numbers>

#include "particles/Kernel.h"

namespace mpsDem {

namespace {

/// Sum of w over the neighbours on a straight row of particles.
Real rowSum(Real radius, Real spacing)
{
    Kernel const w{radius};
    Real sum = 0;
    for (int k = 1; k * spacing < radius; ++k) sum += 2 * w(k * spacing);
    return sum;
}

} // namespace

std::unique_ptr<SurfaceDamping> SurfaceDamping::read(Dictionary const& freeSurfaceSchemes, SchemeSet set, Lattice const& lattice,
                                                     Real gradientRadius, Real gravity)
{
    Real const damping = freeSurfaceSchemes.getInRangeOr("damping", set == SchemeSet::Paper ? 0 : 0.1, 0, 1);
    if (damping <= 0 || gravity <= 0) return nullptr;
    Real const frequency = std::sqrt(std::numbers::pi * gravity / lattice.spacing);
    return std::unique_ptr<SurfaceDamping>(new SurfaceDamping(damping * frequency / rowSum(gradientRadius, lattice.spacing)));
}

void SurfaceDamping::addTo(ParticleSet& particles, NeighbourList const& neighbours, Real dt) const
{
    Real const* const w = neighbours.gradientWeight();
    auto const counts = [&](int j) { return particles.isFluid(j) && particles.surface[j] != SurfaceLabel::Interior; };
    for (int i : particles.fluid())
    {
        if (particles.surface[i] == SurfaceLabel::Interior) continue;
        Vector const ui = particles.u[i];
        Vector sum = Vector::Zero();
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            int const j = neighbours.index()[k];
            if (counts(j)) sum += w[k] * (particles.u[j] - ui);
        }
        particles.uStar[i] += dt * rate_ * sum;
    }
}

} // namespace mpsDem
