#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "core/Types.h"
#include "particles/Lattice.h"
#include "scene/FluidFilling.h"
#include "scene/Region.h"

namespace mpsDem {

/// Uniform numbers in [-1, 1) from the 53 leading bits of a Mersenne twister: the same on every machine.
class Jitter
{
public:
    explicit Jitter(std::uint64_t seed) : generator_(seed) {}
    Real next() { return 2 * (static_cast<Real>(generator_() >> 11) * 0x1p-53) - 1; }

private:
    std::mt19937_64 generator_;
};

/// The cells of the lattice over all regions; one layer in 2-D.
struct FillingCells
{
    /// @throw CaseError BadInput for more than 200 million cells.
    FillingCells(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice);

    /// Of the cell of these numbers along x, y and z [m].
    [[nodiscard]] Vector middle(std::int64_t i, std::int64_t j, std::int64_t k = 0) const
    {
        Real const z = dimensions == 2 ? 0 : static_cast<Real>(k) + 0.5;
        return origin + spacing * Vector(static_cast<Real>(i) + 0.5, static_cast<Real>(j) + 0.5, z);
    }

    /// The corner of that cell with the lowest coordinates [m]; in 3-D.
    [[nodiscard]] Vector corner(std::int64_t i, std::int64_t j, std::int64_t k) const
    {
        return origin + spacing * Vector(static_cast<Real>(i), static_cast<Real>(j), static_cast<Real>(k));
    }

    int dimensions;
    Vector origin;
    Real spacing;
    std::array<std::int64_t, 3> low{}, high{}; ///< Half-open.
};

/// Number of the last region that holds a point; -1 where none does.
int lastRegion(std::vector<std::unique_ptr<Region>> const& regions, Vector const& r);

inline constexpr Real clearance = 0.45;         ///< Of fluid on the lattice from solids, in spacings.
inline constexpr Real jitteredClearance = 0.25; ///< Of jittered fluid, in spacings.

/// fillRegions() in 3-D.
FluidFilling fillSpace(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                       Obstacles const& obstacles);

} // namespace mpsDem
