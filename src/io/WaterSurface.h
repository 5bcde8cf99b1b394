#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/Types.h"
#include "particles/CellGrid.h"

namespace mpsDem {

/// Half space; what lies on the side to which the normal points is cut away.
struct CutPlane
{
    Vector point;  ///< [m]
    Vector normal; ///< Unit vector.
};

/// How a surface is laid around particles.
struct WaterSurfaceControls
{
    Real spacing = 0;           ///< Of the particles [m].
    Real resolution = 2;        ///< Cells of the grid on a spacing.
    Real radius = 2;            ///< Of the kernel [spacings].
    int smoothing = 20;         ///< Rounds of smoothing (Taubin, windowed sinc); 0: none.
    std::vector<CutPlane> cuts; ///< Cut the water open.
};

/// Closed surface of triangles with a normal at each point.
struct SurfaceMesh
{
    std::vector<Vector> points;                ///< [m]
    std::vector<Vector> normals;               ///< Unit vectors out of the water.
    std::vector<std::array<int, 3>> triangles; ///< Corners counter-clockwise as seen from outside.

    /// Volume within, positive [m3].
    [[nodiscard]] Real volume() const;
};

/// Surface of the water around particles in 3-D, closed at walls and bodies.
///
/// Every particle is spread over its neighbourhood with the C2 kernel w of Wendland (1995): F(r) = l0^3 sum_fluid w(|r - r_j|), and W the
/// same over wall, ghost and body particles. The water is where the share of filled space among what walls leave free,
/// min(F / (1 - W), 1 - W), is above 1/2: 1/2 on a level surface, beside a wall too, and on the wall itself. Sampled on a grid, contoured
/// by flying edges (Schroeder et al. 2015), smoothed without shrinking. A lone particle leaves no surface.
/// @param fluid  Positions of fluid particles [m]. @param solid  Of wall, ghost and body particles [m]; may be empty.
/// @throw CaseError (Memory) for a grid of more than 1e9 points.
SurfaceMesh waterSurface(std::span<Vector const> fluid, std::span<Vector const> solid, WaterSurfaceControls const& controls);

/// The share of filled space at each of the fluid particles themselves: below 1/2 the surface passes the particle by, which is a drop too
/// small for it, or has strayed into a wall.
std::vector<Real> filledShare(std::span<Vector const> fluid, std::span<Vector const> solid, WaterSurfaceControls const& controls);

/// Means of particles' values at other places: kernel-weighted over those within `radius`; where there is none, 0.
class KernelMean
{
public:
    /// @param positions  [m]. @param radius  [m].
    KernelMean(std::span<Vector const> positions, Real radius);

    [[nodiscard]] std::vector<Real> at(std::span<Vector const> places, std::span<Real const> values) const;
    [[nodiscard]] std::vector<Vector> at(std::span<Vector const> places, std::span<Vector const> values) const;

private:
    CellGrid grid_;
    Real radius_;
};

} // namespace mpsDem
