#include "particles/NeighbourList.h"

#include <cmath>
#include <numbers>

namespace mpsDem {

void NeighbourList::update(ParticleSet const& particles)
{
    Real const reach = radii_.largest();
    grid_.build(particles.r, reach, particles.lattice().dimensions);
    int const owned = particles.owned().last;
    start_.resize(static_cast<std::size_t>(owned) + 1);
    start_[0] = 0;
    reserve(particles.lattice(), owned);
    markFluidCells(particles);
    for (int i : particles.owned()) start_[i + 1] = wanted(particles, i) ? appendRow(particles, i, start_[i]) : start_[i];
    computeWeights();
}

void NeighbourList::reserve(Lattice const& lattice, int rows)
{
    Real const a = radii_.largest() / lattice.spacing;
    Real const lengthOfRow = lattice.dimensions == 2 ? std::numbers::pi * a * a : 4 * std::numbers::pi / 3 * a * a * a;
    auto const most = static_cast<std::size_t>(lengthOfRow * rows);
    if (most <= index_.capacity()) return;
    index_.reserve(most);
    gradientWeight_.reserve(most);
    if (separate()) laplacianWeight_.reserve(most);
}

void NeighbourList::markFluidCells(ParticleSet const& particles)
{
    fluidInCell_.reserve(static_cast<std::size_t>(grid_.mostCells()));
    fluidInCell_.assign(static_cast<std::size_t>(grid_.cellCount()), 0);
    for (int const i : particles.fluid()) fluidInCell_[static_cast<std::size_t>(grid_.cellOfPoint(i))] = 1;
    for (int const i : particles.halo())
        if (particles.isFluid(i)) fluidInCell_[static_cast<std::size_t>(grid_.cellOfPoint(i))] = 1;
}

bool NeighbourList::wanted(ParticleSet const& particles, int i) const
{
    if (particles.isFluid(i) || (allWallRows_ && particles.type[i] == ParticleType::Wall)) return true;
    bool possible = false;
    grid_.forEachCellRun(particles.r[i], radii_.largest(), [&](int first, int last) {
        for (int cell = first; cell < last; ++cell) possible = possible || fluidInCell_[static_cast<std::size_t>(cell)] != 0;
    });
    if (!possible) return false;
    Real const reach2 = radii_.largest() * radii_.largest();
    bool found = false;
    grid_.forEachRun(particles.r[i], radii_.largest(), [&](int first, int last) {
        for (int slot = first; slot < last && !found; ++slot)
            found = particles.isFluid(grid_.order()[slot]) && (grid_.sortedPositions()[slot] - particles.r[i]).squaredNorm() < reach2;
    });
    return found;
}

int NeighbourList::appendRow(ParticleSet const& particles, int i, int end)
{
    Real const reach = radii_.largest(), reach2 = reach * reach;
    bool const ghost = particles.type[i] == ParticleType::Ghost;
    Vector const ri = particles.r[i];
    int const* const order = grid_.order().data();
    Vector const* const position = grid_.sortedPositions().data();
    grid_.forEachRun(ri, reach, [&](int first, int last) {
        makeRoom(end + last - first);
        int* const index = index_.data();
        Real* const square = gradientWeight_.data();
        int k = end;
        // Each candidate is written, and the end moves on where it counts: no branch that the processor would have to guess.
        for (int slot = first; slot < last; ++slot)
        {
            int const j = order[slot];
            Real const r2 = (position[slot] - ri).squaredNorm();
            index[k] = j;
            square[k] = r2;
            bool const hidden = ghost && particles.type[j] == ParticleType::Ghost;
            k += static_cast<int>(r2 < reach2) & static_cast<int>(j != i) & static_cast<int>(!hidden);
        }
        end = k;
    });
    return end;
}

void NeighbourList::makeRoom(int pairs)
{
    auto const wanted = static_cast<std::size_t>(pairs);
    if (wanted <= index_.size()) return;
    index_.resize(wanted + wanted / 16);
    gradientWeight_.resize(index_.size());
}

void NeighbourList::computeWeights()
{
    Kernel const gradient{radii_.gradient}, laplacian{radii_.laplacian};
    std::size_t const count = pairs();
    if (separate() && laplacianWeight_.size() < index_.size()) laplacianWeight_.resize(index_.size());
    Real* const w = gradientWeight_.data(); // r^2 until now
    for (std::size_t k = 0; k < count; ++k) w[k] = std::sqrt(w[k]);
    if (separate())
        for (std::size_t k = 0; k < count; ++k) laplacianWeight_[k] = laplacian(w[k]);
    for (std::size_t k = 0; k < count; ++k) w[k] = gradient(w[k]);
}

} // namespace mpsDem
