#pragma once

#include <span>

#include "particles/CellGrid.h"
#include "particles/Kernel.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Effective radii of the operators [m].
struct Radii
{
    Real gradient;  ///< Of eqs 4 and 5, number density and surface vector.
    Real laplacian; ///< Of eqs 6 and 7.

    [[nodiscard]] Real largest() const { return gradient > laplacian ? gradient : laplacian; }
};

/// Flat list of neighbours: those of particle i are index[k], k = start[i] .. start[i+1].
///
/// Rows exist for fluid particles and for boundary particles that have fluid within reach; all others are empty (a dry wall costs
/// nothing). Weights are stored once per pair; distances are recomputed from the positions, which stay in the cache.
class NeighbourList
{
public:
    /// @param allWallRows  Also rows for wall particles far from fluid (needed where DBL is off).
    NeighbourList(Radii const& radii, bool allWallRows) : radii_(radii), allWallRows_(allWallRows) {}

    /// Builds grid and list for the present positions.
    void update(ParticleSet const& particles);

    /// The order in which points lie in the cells of the list. Its grid is used for that: update() has to follow before the list is.
    std::span<int const> orderByCells(std::span<Vector const> points, int dimensions)
    {
        grid_.build(points, radii_.largest(), dimensions);
        return grid_.order();
    }

    [[nodiscard]] Radii const& radii() const { return radii_; }
    [[nodiscard]] CellGrid const& grid() const { return grid_; }

    [[nodiscard]] int first(int i) const { return start_[i]; }
    [[nodiscard]] int last(int i) const { return start_[i + 1]; }
    [[nodiscard]] int const* index() const { return index_.data(); }
    /// w(r_ij) with the gradient radius; zero beyond it.
    [[nodiscard]] Real const* gradientWeight() const { return gradientWeight_.data(); }
    /// w(r_ij) with the Laplacian radius; zero beyond it.
    [[nodiscard]] Real const* laplacianWeight() const { return separate() ? laplacianWeight_.data() : gradientWeight_.data(); }

    [[nodiscard]] std::size_t pairs() const { return static_cast<std::size_t>(start_.empty() ? 0 : start_.back()); }

private:
    [[nodiscard]] bool separate() const { return radii_.gradient != radii_.laplacian; }
    /// Address space for as many pairs as an even lattice has: pages are taken as the list grows into them, and it is never copied.
    void reserve(Lattice const& lattice, int rows);
    void markFluidCells(ParticleSet const& particles);
    [[nodiscard]] bool wanted(ParticleSet const& particles, int i) const;
    /// Writes neighbours and r^2 of particle i from `end` on. @return where they end.
    int appendRow(ParticleSet const& particles, int i, int end);
    void makeRoom(int pairs);
    void computeWeights();

    Radii radii_;
    bool allWallRows_;
    CellGrid grid_;
    Field<std::uint8_t> fluidInCell_; ///< For each cell of the grid: dry walls are found so without a look at their neighbours.
    Field<int> start_, index_;        ///< index and weights have room behind the last pair.
    Field<Real> gradientWeight_, laplacianWeight_;
};

} // namespace mpsDem
