#include "particles/NeighbourList.h"

#include <cmath>

namespace mpsDem {

void NeighbourList::update(ParticleSet const& particles)
{
    Real const reach = radii_.largest();
    grid_.build(particles.r, reach, particles.lattice().dimensions);
    int const owned = particles.owned().last;
    start_.resize(static_cast<std::size_t>(owned) + 1);
    index_.clear();
    gradientWeight_.clear();
    laplacianWeight_.clear();
    start_[0] = 0;
    for (int i : particles.owned())
    {
        if (wanted(particles, i)) appendRow(particles, i);
        start_[i + 1] = static_cast<int>(index_.size());
    }
}

bool NeighbourList::wanted(ParticleSet const& particles, int i) const
{
    if (particles.isFluid(i) || (allWallRows_ && particles.type[i] == ParticleType::Wall)) return true;
    Real const reach2 = radii_.largest() * radii_.largest();
    bool found = false;
    grid_.forEachRun(particles.r[i], radii_.largest(), [&](int first, int last) {
        for (int slot = first; slot < last && !found; ++slot)
            found = particles.isFluid(grid_.order()[slot]) && (grid_.sortedPositions()[slot] - particles.r[i]).squaredNorm() < reach2;
    });
    return found;
}

void NeighbourList::appendRow(ParticleSet const& particles, int i)
{
    Kernel const gradient{radii_.gradient}, laplacian{radii_.laplacian};
    bool const ghost = particles.type[i] == ParticleType::Ghost;
    grid_.forEachWithin(particles.r[i], radii_.largest(), [&](int j, Vector const&, Real r2) {
        if (j == i || (ghost && particles.type[j] == ParticleType::Ghost)) return;
        Real const r = std::sqrt(r2);
        index_.push_back(j);
        gradientWeight_.push_back(gradient(r));
        if (separate()) laplacianWeight_.push_back(laplacian(r));
    });
}

} // namespace mpsDem
