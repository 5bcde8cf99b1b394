#pragma once

#include <span>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// A contact point as a surface sees it: a sphere; radius 0 for a corner.
struct Sphere
{
    Vector centre; ///< In the axes of the surface [m].
    Real radius;   ///< [m].
};

/// Where one sphere is near one patch of a surface.
struct ContactFeature
{
    int sphere;    ///< Index of the sphere.
    int patch;     ///< Key of the history: equal along a run of collinear segments.
    Vector normal; ///< Unit vector from the surface to the sphere, in the axes of the surface.
    Real gap;      ///< [m]; negative: overlap.
    Real radius;   ///< Radius of curvature of the surface [m]; 0 for a flat one.
};

/// Box along the axes.
struct Box
{
    Vector low = Vector::Constant(1e300);
    Vector high = Vector::Constant(-1e300);

    void add(Vector const& r)
    {
        low = low.cwiseMin(r);
        high = high.cwiseMax(r);
    }
    /// Distance from r to the box, 0 inside [m].
    [[nodiscard]] Real distance(Vector const& r) const { return (low - r).cwiseMax(r - high).cwiseMax(0).norm(); }
};

/// What contact points can touch: polylines and discs in 2-D, triangle surfaces and balls in 3-D, planes.
class ContactSurface
{
public:
    virtual ~ContactSurface() = default;

    /// Appends all features with gap < reach, in the order of the spheres, those of one sphere by patch.
    ///
    /// One sphere has more than one feature only where they differ: at most one within each 5 degrees of normal direction,
    /// faces before corners, the deepest first.
    /// @param reach  0 for contact; above it for what could touch soon [m].
    virtual void collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const = 0;

    /// Appends the numbers, rising, of all spheres that may touch once they have moved by no more than `reach` [m], whatever side of the
    /// surface they are on, and perhaps of some others.
    virtual void findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const = 0;
};

/// A centre may be found so many depths away from a surface: beyond the end of a face in a valley, one depth behind it.
inline constexpr Real farthestDepths = 1.5;

/// Normals with a greater cosine count as one direction: cos 5 deg.
inline constexpr Real sameDirection = 0.99619469809174555;

} // namespace mpsDem
