#pragma once

#include <optional>
#include <vector>

#include "boundaries/SegmentTree.h"
#include "boundaries/TriangleTree.h"
#include "core/Surface.h"

namespace mpsDem {

/// Nearest place on a set of surfaces, all lines (2-D, SegmentTree) or all triangles (3-D, TriangleTree).
class SurfaceTree
{
public:
    struct Nearest
    {
        Vector point = Vector::Zero();  ///< On a surface [m].
        Real distance = 0;              ///< Signed [m]: positive on the fluid side.
        Vector normal = Vector::Zero(); ///< Of the surface there, into the fluid.
        int surface = -1;               ///< Number of the surface.
        bool atRim = false;             ///< The point is an open end of a line or lies on a rim of triangles.
    };

    explicit SurfaceTree(std::vector<Surface> const& surfaces);

    [[nodiscard]] bool empty() const { return (!segments_ || segments_->empty()) && !triangles_; }
    /// @pre not empty.
    [[nodiscard]] Nearest nearest(Vector const& r) const;
    /// Signed distance [m]; infinity where there is no surface.
    [[nodiscard]] Real distance(Vector const& r) const { return triangles_ ? triangles_->distance(r) : segments_->distance(r); }
    /// Corners of the box that holds all surfaces [m]; low > high where there is none.
    [[nodiscard]] Vector const& low() const { return low_; }
    [[nodiscard]] Vector const& high() const { return high_; }

private:
    std::optional<SegmentTree> segments_;
    std::optional<TriangleTree> triangles_;
    std::vector<Vector> openEnds_; ///< Of lines: two a surface; empty ones stand for a closed line.
    Vector low_, high_;
};

} // namespace mpsDem
