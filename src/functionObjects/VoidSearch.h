#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/Types.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Finds empty pockets that fluid closes in, by flood fill on a grid of cells around all particles.
///
/// 1. Every particle (fluid, wall, ghost, halo) covers the cells whose centre lies within `reach` of it.
/// 2. From the rim of the grid, which is larger than the particles' box, and from `openAt`, empty cells are filled over common faces: they
///    are open air, or lie behind the walls.
/// 3. Empty cells that are left are gathered over faces, edges and corners. A group is a void where it borders on a cell that fluid covers.
///    The inside of a body is none: nothing but the ghost rows of the body border on it.
/// 4. A particle stands for a square (cube) of one spacing, but covers more. Volume of a void: that of its cells and of a
///    rim around them, less what the particles' squares fill of both. A lattice without m of its particles gives m particle volumes.
///
/// The same in 2-D and 3-D. The memory of a search is used again by the next.
class VoidSearch
{
public:
    struct Controls
    {
        Real reach = 0;               ///< [spacings]
        int resolution = 2;           ///< Cells on a spacing.
        Real smallest = 0;            ///< Smaller voids are gaps of a disordered arrangement and do not count [particle volumes].
        std::optional<Vector> openAt; ///< In open air that walls close off from the surroundings [m].

        /// What suits disordered particles; see etc/doc/function-objects.md for how it was found.
        static Controls defaults(int dimensions);
    };

    struct Void
    {
        Vector centre; ///< Mean of its empty cells [m].
        Real volume;   ///< [m3]
    };

    explicit VoidSearch(Controls const& controls) : controls_(controls) {}

    /// Voids of this moment, the largest first.
    std::vector<Void> const& find(ParticleSet const& particles);

    [[nodiscard]] Controls const& controls() const { return controls_; }

private:
    using Cell = std::array<int, 3>;

    /// A group of empty cells that is not open air: a stretch of `cells_`.
    struct Group
    {
        int first, last;
        Real filled; ///< Cells' volumes that particles fill of group and rim.
        int rim;     ///< Number of cells in the rim.
    };

    void layOut(ParticleSet const& particles);
    void closeRim();
    void cover(ParticleSet const& particles);
    void coverAround(Vector const& r, bool fluid);
    void openAir();
    void openFrom(int cell);
    [[nodiscard]] int emptyCellAt(Vector const& r) const;
    void gather();
    [[nodiscard]] bool gatherFrom(int cell);
    void addRims();
    void fill(ParticleSet const& particles);
    void fillBy(Vector const& r);
    void measure();

    [[nodiscard]] int number(Cell const& c) const { return (c[2] * count_[1] + c[1]) * count_[0] + c[0]; }
    [[nodiscard]] Vector centreOf(int cell) const;
    /// Last argument is called with the number of every cell of the box between two cells, both included.
    template <class Visit>
    void forEachCell(Cell const& low, Cell const& high, Visit visit) const;

    Controls controls_;
    Lattice lattice_;
    Real size_ = 0;  ///< Edge of a cell [m].
    Real reach_ = 0; ///< [m]
    Vector origin_ = Vector::Zero();
    Cell count_{1, 1, 1};
    std::vector<int> faces_, neighbours_; ///< Differences of cell numbers.
    Field<int> content_;                  ///< Of each cell: one of the words in VoidSearch.cpp, or the number of a group.
    Field<int> stack_, cells_;
    std::vector<Group> groups_;
    std::vector<Void> voids_;
};

} // namespace mpsDem
