#pragma once

#include <optional>
#include <vector>

#include "core/Types.h"

namespace mpsDem::postGauges {

enum class SurfaceMethod
{
    Volume,
    Top
};

/// How the free surface is found.
struct SurfaceSettings
{
    Real spacing = 0;            ///< [m]
    int dimensions = 2;          ///< 2: x-y plane; 3.
    Vector up = Vector::UnitY(); ///< Unit vector against gravity.
    SurfaceMethod method = SurfaceMethod::Volume;
    Real width = 2;  ///< Width of the column in spacings.
    int splash = 20; ///< Groups of fewer fluid particles are drops and are not seen.
};

/// Elevation of the free surface above given places, from the particles of one time.
///
/// Drops: fluid particles nearer to each other than 1.5 spacings form a group; only groups of at least `splash` particles count (the largest
/// one always does). The top of a column is its highest counting fluid particle. Wall, ghost and body particles below that top count as
/// filled, so that a film on a slope is seen as deep as it is; those above (a side wall) do not.
///
/// Volume (default): every particle is a square (cube) of one spacing; with V the part of them in the column of width W (area W, W^2 in
/// 3-D) above the level z0 = top - 3 spacings: eta = z0 + V / W. Exact for a lattice with a level surface; an air pocket below the surface
/// counts as missing water. A wave of length L is lowered by
/// (pi W / L)^2 / 6 of its height: 0.3 % for L = 50 spacings.
/// Top: the highest place on the vertical line through the gauge where the fill fraction C = sum_j V_j w(|r - r_j|) is 1/2, with the
/// C2 kernel of Wendland (1995) of radius 2.5 spacings; 1/2 is its value on a plane surface.
class FreeSurface
{
public:
    /// @param fluid  Positions of fluid particles [m]. @param solid  Of wall, ghost and body particles [m].
    FreeSurface(std::vector<Vector> const& fluid, std::vector<Vector> const& solid, SurfaceSettings settings);

    /// Coordinate of the surface along `up` [m] above `location`, whose own height does not matter; nothing where the column holds no fluid.
    [[nodiscard]] std::optional<Real> elevation(Vector const& location) const;

    /// Fluid particles that count as drops.
    [[nodiscard]] std::size_t drops() const { return drops_; }

private:
    struct Point
    {
        Real across = 0; ///< First horizontal coordinate [m].
        Real along = 0;  ///< Second one; 0 in 2-D.
        Real height = 0; ///< Along `up`.
        bool fluid = false;
    };

    [[nodiscard]] Point pointAt(Vector const& position, bool fluid) const;
    [[nodiscard]] std::vector<Point> column(Point const& centre, Real halfWidth) const;
    [[nodiscard]] std::optional<Real> topOf(std::vector<Point> const& points, Point const& centre) const;
    [[nodiscard]] Real share(Point const& point, Point const& centre) const;
    [[nodiscard]] Real byVolume(Point const& centre, Real top) const;
    [[nodiscard]] Real byFill(Point const& centre, Real top) const;

    SurfaceSettings settings_;
    Vector across_;
    Vector along_;
    std::vector<Point> points_; ///< Sorted by `across`.
    std::size_t drops_ = 0;
};

/// Size of the group that each particle belongs to: particles nearer than `reach` are in one group.
std::vector<int> groupSizes(std::vector<Vector> const& positions, Real reach);

} // namespace mpsDem::postGauges
