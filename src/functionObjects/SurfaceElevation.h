#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "particles/CellGrid.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Keys of the free surface, the same for all objects that look for it:
///
/// | key | meaning | unit | default | range |
/// | method | volume or top | - | volume | |
/// | width | width of a column | spacings | 2 | 1 to 20 |
/// | splash | groups of fewer fluid particles are drops | - | 20 | 1 to 1e6 |
/// | zero | level that counts as elevation 0, along `up` | m | 0 | |
struct SurfaceElevationControls
{
    enum class Method
    {
        Volume,
        Top
    };

    Method method = Method::Volume;
    Real width = 2;
    int splash = 20;
    Real zero = 0;

    /// Reads the keys above. @throw CaseError BadInput for an unknown word or a number out of its range.
    static SurfaceElevationControls read(Dictionary const& dict);
    /// Reads `splash` and `zero` alone.
    static SurfaceElevationControls readDrops(Dictionary const& dict);
    /// One line for the head of a table.
    [[nodiscard]] std::string str() const;
};

/// Elevation of the free surface above given places, for the positions that the particles have at update().
///
/// Drops: fluid particles nearer to each other than 1.5 spacings form a group; a group of fewer than `splash` is not seen. The top of a
/// column is its highest fluid particle that is seen. Wall and ghost particles below that top count as filled, so that a film on a
/// slope is seen as deep as it is; those above it (a side wall) do not.
///
/// Volume: every particle is a square (cube) of one spacing. With V the part of them that lies in a column of width W (base W^2 in 3-D)
/// and above the level z0 = top + l0/2 - 3 l0: eta = z0 + V / W. Exact for a lattice with a level surface; the mean over the width;
/// an air pocket below the surface counts as missing water.
/// Top: the highest place on the vertical line through the location where the share of filled space C = sum_j V_j w(|r - r_j|) is 1/2,
/// its value on a plane surface; w is the C2 kernel of Wendland (1995) with a radius of 2.5 spacings. A layer too thin to reach 1/2 ends
/// half a spacing above its top particle.
class SurfaceElevation
{
public:
    /// @param up  Unit vector against gravity.
    SurfaceElevation(ParticleSet const& particles, SurfaceElevationControls const& controls, Vector const& up);

    /// Takes in the particles of now. Must be called before elevation().
    void update();

    /// Coordinate of the surface along `up`, less `zero` [m]; the height of the location does not matter. Nothing where the column has no fluid.
    [[nodiscard]] std::optional<Real> elevation(Vector const& location) const;

    /// Whether a fluid particle, by its number among the fluid, belongs to a group that is not seen.
    [[nodiscard]] bool isDrop(int fluid) const;

    /// Smallest and largest coordinate of the fluid along `direction` [m]; zero for no fluid.
    [[nodiscard]] std::pair<Real, Real> extent(Vector const& direction) const;

private:
    /// A particle near the column.
    struct Member
    {
        Vector aside; ///< Horizontal place from the location [m].
        Real height;  ///< Along up [m].
        int fluid;    ///< Number in the fluid range, -1 for a boundary particle.
    };

    [[nodiscard]] Vector project(Vector const& r) const;
    /// Particles less than `reach` aside, the highest first.
    [[nodiscard]] std::vector<Member> near(Vector const& centre, Real reach) const;
    /// Those of them below the highest fluid particle in the column that is seen, without drops. Empty where the column is dry.
    [[nodiscard]] std::vector<Member> filled(std::vector<Member> const& all) const;
    /// Part of a particle's base that lies in the column.
    [[nodiscard]] Real share(Member const& member) const;
    [[nodiscard]] Real byVolume(std::vector<Member> const& members) const;
    [[nodiscard]] Real byFill(std::vector<Member> const& members) const;

    ParticleSet const& particles_;
    SurfaceElevationControls controls_;
    Vector up_, across_, along_;
    Field<Vector> fluid_;     ///< Positions.
    Field<Vector> projected_; ///< (across, along, 0) of the fluid, then of the boundary.
    Field<Real> height_;      ///< In the same order.
    CellGrid fluidGrid_, columnGrid_;
};

} // namespace mpsDem
