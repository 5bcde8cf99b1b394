#include "boundaries/BoundaryPressure.h"

#include <algorithm>

namespace mpsDem {

void extrapolateBoundaryPressure(ParticleSet& particles, NeighbourList const& neighbours, Vector const& gravity, Real density,
                                 bool positiveOnly)
{
    for (int i : particles.wall())
    {
        particles.mirror[i] = particles.wet[i] ? 0 : 1;
        if (!particles.wet[i]) particles.p[i] = 0;
    }
    Real const* const w = neighbours.gradientWeight();
    for (int i : particles.ghost())
    {
        Vector const normal = particles.normal[i];
        Real const slope = density * (gravity - particles.wallAcceleration[i]).dot(normal);
        Real weight = 0, sum = 0;
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            int const j = neighbours.index()[k];
            bool const donor = particles.isFluid(j) || (particles.wet[j] && particles.body[j] == particles.body[i]);
            if (!donor) continue;
            weight += w[k];
            sum += w[k] * (particles.p[j] + slope * normal.dot(particles.r[i] - particles.r[j]));
        }
        particles.mirror[i] = weight > 0 ? 0 : 1;
        particles.p[i] = weight > 0 ? sum / weight : 0;
        if (positiveOnly) particles.p[i] = std::max(particles.p[i], Real(0));
    }
}

} // namespace mpsDem
