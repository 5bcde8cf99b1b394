#pragma once

#include <optional>
#include <vector>

#include "core/Polyline.h"
#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// Outline of a body in its own axes, the centre of mass at the origin: a closed polyline or a disc in 2-D, a closed triangle surface or
/// a sphere in 3-D.
struct ContactShape
{
    Polyline outline;               ///< Closed, normals outwards; empty for other shapes.
    std::optional<Real> radius;     ///< Of a disc or a sphere around the centre of mass [m].
    std::optional<TriSurface> skin; ///< Closed, normals outwards.

    static ContactShape polygon(Polyline outline) { return {std::move(outline), std::nullopt, std::nullopt}; }
    static ContactShape disc(Real radius) { return {Polyline(), radius, std::nullopt}; }
    static ContactShape mesh(TriSurface skin) { return {Polyline(), std::nullopt, std::move(skin)}; }
    static ContactShape sphere(Real radius) { return disc(radius); }
};

/// One DEM particle of a body's surface, in body axes.
struct ContactPoint
{
    Vector centre;  ///< [m].
    Real radius;    ///< Of the sphere that touches; 0 for a corner [m].
    Real curvature; ///< Radius of curvature that Hertz's law works with [m].
    Real area;      ///< Part of the surface that it stands for, length times thickness [m2].
    Real count;     ///< Equal spheres side by side across the thickness [-].
};

/// DEM particles of one body such that the contact surface is the outline itself.
///
/// Spheres of radius dx/2 lie dx/2 inside each side at a distance of about dx, smaller ones where a sharp corner leaves no room; a
/// point of radius 0 sits on each corner with an interior angle below 150 degrees. A corner stands for half a spacing at most, the
/// spheres of a side share the rest: areas sum to the area of the side for every spacing. A disc is one sphere of its radius.
///
/// In 3-D a face is cut into tiles of about dx times dx, each with a sphere (SurfaceTiles); edges below 150 degrees have points of radius
/// 0 about dx apart, sharp vertices one each (SurfaceLines). An edge point stands for dx/2 times its part of the edge, a vertex for dx^2/2,
/// on each face that has it, and together for half of a face at most; the spheres share the rest of the face in the ratio of their tiles.
/// So the areas of all points of a face sum to its area for every spacing.
class ContactPointSet
{
public:
    /// @param spacing    dx [m].  @param thickness  Width in z of a polyline or disc; the spacing for a sphere [m].
    /// @throw CaseError BadInput for an outline or surface that is not closed.
    ContactPointSet(ContactShape const& shape, Real spacing, Real thickness);

    [[nodiscard]] std::vector<ContactPoint> const& points() const { return points_; }
    /// Area of the longest side or largest plane face; dx^2 where none is larger; that of the one sphere for a disc [m2].
    [[nodiscard]] Real largestSide() const { return largestSide_; }

private:
    void addDisc(Real radius, Real spacing, Real thickness);
    void addPolygon(Polyline const& outline, Real spacing, Real thickness);
    void addSurface(TriSurface const& surface, Real spacing);

    std::vector<ContactPoint> points_;
    Real largestSide_ = 0;
};

} // namespace mpsDem
