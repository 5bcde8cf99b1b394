#include "boundaries/WallGuard.h"

namespace mpsDem {

namespace {

constexpr Real reach = 1.5;        ///< Of a wall particle's tangent plane, in spacings.
constexpr Real wallRowDepth = 0.5; ///< Of wall particles behind their surface, in spacings.

} // namespace

void WallGuard::findSuspects(ParticleSet const& particles, NeighbourList const& neighbours)
{
    suspects_.clear();
    suspect_.assign(static_cast<std::size_t>(particles.size()), 0);
    Real const far = reach * spacing_, low = (wallRowDepth - deepest) * spacing_;
    for (int j : particles.wall())
    {
        if (particles.body[j] >= 0) continue;
        for (int k = neighbours.first(j); k < neighbours.last(j); ++k)
        {
            int const i = neighbours.index()[k];
            if (!particles.fluid().contains(i)) continue;
            Vector const rji = particles.r[i] - particles.r[j];
            if (rji.dot(particles.normal[j]) >= low || rji.squaredNorm() >= far * far) continue;
            if (suspect_[static_cast<std::size_t>(i)] != 0) continue;
            suspect_[static_cast<std::size_t>(i)] = 1;
            suspects_.push_back(i);
        }
    }
}

WallGuard::Exchange WallGuard::apply(ParticleSet& particles, NeighbourList const& neighbours)
{
    findSuspects(particles, neighbours);
    Exchange exchange;
    for (int const i : suspects_)
    {
        auto const near = tree_.nearest(particles.r[i]);
        Real const depth = -near.distance;
        if (depth <= deepest * spacing_ || depth > reach * spacing_ || near.atRim) continue;
        Vector const way = (near.point - particles.r[i]) / depth;
        Real const into = std::max(Real(0), -particles.u[i].dot(way));
        particles.r[i] += (depth - deepest * spacing_) * way;
        particles.u[i] += into * way;
        exchange.energyTaken += 0.5 * into * into;
        exchange.impulseGiven += into * way;
        ++putBack_;
    }
    return exchange;
}

} // namespace mpsDem
