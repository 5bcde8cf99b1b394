#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/Types.h"
#include "scene/FillingCells.h"
#include "scene/FluidFilling.h"
#include "scene/Region.h"

namespace mpsDem {

/// Boxes around regions, a margin wider.
class RegionBoxes
{
public:
    RegionBoxes(std::vector<std::unique_ptr<Region>> const& regions, Real margin);
    /// Whether a box reaches into one of them.
    [[nodiscard]] bool touch(Vector const& low, Vector const& high) const;

private:
    Field<Vector> low_, high_;
};

/// How cells of the lattice lie to solids, found by blocks of them: few questions where solids are far.
class CoarseSolids
{
public:
    enum class Side : char
    {
        Unknown, ///< In no region's box.
        Clear,   ///< Farther than `reach` from solids, outside of them.
        Solid,   ///< The same, inside.
        Near     ///< To be asked for.
    };
    static constexpr int blockSize = 8; ///< Cells along a side of the largest blocks.
    static constexpr Real reach = 1.2;  ///< [spacings]: more than a cell's half diagonal, and than any jitter and the clearance after it.

    CoarseSolids(SolidDistance const& solids, FillingCells const& cells, RegionBoxes const& regions);

    /// Looks at the layers first <= k < last, no more than blockSize of them.
    void look(std::int64_t first, std::int64_t last);
    /// Of a cell of these layers.
    [[nodiscard]] Side side(std::int64_t i, std::int64_t j, std::int64_t k) const { return side_[index(i, j, k)]; }
    /// Signed distance of its middle r where solids are near, else plus or minus `reach` [m].
    [[nodiscard]] Real distance(std::int64_t i, std::int64_t j, std::int64_t k, Vector const& r) const
    {
        Side const known = side(i, j, k);
        if (known == Side::Near) return solids_.distance(r);
        return (known == Side::Clear ? reach : -reach) * cells_.spacing;
    }

private:
    using Numbers = std::array<std::int64_t, 3>;
    [[nodiscard]] std::size_t index(std::int64_t i, std::int64_t j, std::int64_t k) const
    {
        return static_cast<std::size_t>(((k - first_) * size_[1] + j - cells_.low[1]) * size_[0] + i - cells_.low[0]);
    }
    void settle(Numbers const& begin, Numbers const& end, int size);
    [[nodiscard]] Side sideOfBlock(Vector const& corner, int size) const;

    SolidDistance solids_;
    FillingCells const& cells_;
    RegionBoxes const& regions_;
    std::array<std::int64_t, 2> size_; ///< Cells along x and y.
    std::int64_t first_ = 0;
    std::vector<Side> side_;
};

} // namespace mpsDem
