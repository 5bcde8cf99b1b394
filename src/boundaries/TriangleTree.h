#pragma once

#include <memory>
#include <span>

#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// Nearest place on a set of triangle surfaces, with a sign: positive on the fluid side.
///
/// Several walls of one case behave like one. The sign comes from the angle-weighted normal of the nearest face, edge or corner, over all
/// surfaces that have the point of it in common (within 1e-9 of the extent), so that a floor and a wall given as two surfaces join as one
/// would. Where a surface meets another one in its middle (a ramp across a box), what lies behind the ramp is solid although the box alone
/// would hold it free: a place whose nearest point lies behind the nearest other surface gets that surface's distance.
class TriangleTree
{
public:
    struct Nearest
    {
        Vector point = Vector::Zero();  ///< On a surface [m].
        Real distance = 0;              ///< Signed [m].
        Vector normal = Vector::Zero(); ///< Of the nearest triangle.
        int surface = -1;               ///< Number of the surface.
        int triangle = -1;              ///< Number of the triangle in it.
        bool atRim = false;             ///< The point lies on a rim that no other surface touches.
    };

    explicit TriangleTree(std::span<TriSurface const> surfaces);
    ~TriangleTree();
    TriangleTree(TriangleTree&&) noexcept;
    TriangleTree& operator=(TriangleTree&&) noexcept;

    [[nodiscard]] bool empty() const;
    /// @pre not empty.
    [[nodiscard]] Nearest nearest(Vector const& r) const;
    /// Signed distance [m]; infinity where there is no surface.
    [[nodiscard]] Real distance(Vector const& r) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace mpsDem
