#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "boundaries/PlacedPoints.h"
#include "core/Types.h"
#include "scene/FillingCells.h"

namespace mpsDem {

/// Particles for cells of the lattice that a solid cuts: as many as the free shares of the cells add up to. What a cell has too little or too
/// much is carried on to the next one, as in the dithering of a picture (Floyd & Steinberg 1976); a particle that is due is pushed out of the
/// solid.
class CutCells
{
public:
    CutCells(std::vector<std::unique_ptr<Region>> const& regions, Obstacles const& obstacles, FillingCells const& cells)
        : regions_(regions),
          obstacles_(obstacles),
          cells_(cells),
          pushed_(cells.spacing)
    {}

    /// Decides about the next cell. @param free  Share of it that is in a region and in no solid. @param clear  Its middle is: it gets a particle.
    /// @param r  Its middle [m]; moved where the particle must be. @return whether it gets one.
    bool take(Real free, bool clear, std::array<std::int64_t, 3> const& cell, Vector& r);

private:
    [[nodiscard]] bool pushOut(Vector& r, std::array<std::int64_t, 3> const& cell);
    [[nodiscard]] bool crowded(Vector const& r, std::array<std::int64_t, 3> const& cell) const;

    std::vector<std::unique_ptr<Region>> const& regions_;
    Obstacles const& obstacles_;
    FillingCells const& cells_;
    PlacedPoints pushed_;
    Real carry_ = 0; ///< Free share of the cells passed over less the particles in them.
};

} // namespace mpsDem
