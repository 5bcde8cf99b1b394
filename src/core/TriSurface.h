#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Oriented surface of triangles: a wall, a bathymetry or the skin of a body in 3-D.
///
/// The normal of each triangle points to the outside of the solid, that is into the fluid: its corners run counter-clockwise as the fluid
/// sees them.
class TriSurface
{
public:
    using Corners = std::array<int, 3>; ///< Numbers of points.

    struct Triangle
    {
        Corners corner; ///< Counter-clockwise as seen from the fluid.
        Vector normal;  ///< Unit vector into the fluid.
        Real area;      ///< [m2].
        int patch;      ///< Number of the plane piece of connected triangles to which it belongs; contact history survives within a patch.
    };

    /// Line between two points that one triangle (a rim) or two have in common.
    struct Edge
    {
        int a, b;  ///< Numbers of points, in the sense of rotation of `left`.
        int left;  ///< A triangle that has it.
        int right; ///< The other one; -1 at a rim.
        Real turn; ///< Sine of the angle between the normals: > 0 a ridge of the solid, < 0 a valley, 0 flat or a rim.
        [[nodiscard]] bool rim() const { return right < 0; }
    };

    TriSurface() = default;

    /// @param points     [m]; triangles that touch share points.
    /// @param triangles  Corners, counter-clockwise as seen from the fluid.
    /// @throw CaseError BadInput for no triangle, a number without a point, a point that is not finite, a triangle without area, an edge of
    ///        three or more triangles, and neighbours of opposite orientation.
    TriSurface(std::string name, std::vector<Vector> points, std::vector<Corners> const& triangles);

    [[nodiscard]] std::string const& name() const { return name_; }
    [[nodiscard]] std::vector<Vector> const& points() const { return points_; }
    [[nodiscard]] std::vector<Triangle> const& triangles() const { return triangles_; }
    [[nodiscard]] std::vector<Edge> const& edges() const { return edges_; }
    [[nodiscard]] int patches() const { return patches_; }
    /// True where no edge is a rim.
    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] Vector const& point(Triangle const& triangle, int k) const
    {
        return points_[static_cast<std::size_t>(triangle.corner[k])];
    }
    [[nodiscard]] Vector centre(Triangle const& t) const { return (point(t, 0) + point(t, 1) + point(t, 2)) / 3; }

    /// [m2].
    [[nodiscard]] Real area() const;
    /// Signed volume within a closed surface, sum of tetrahedra: positive where the normals point outwards [m3].
    [[nodiscard]] Real volume() const;
    /// Corners of the box that holds all points [m].
    [[nodiscard]] Vector low() const;
    [[nodiscard]] Vector high() const;

    /// The same surface after r -> centre + R r.
    [[nodiscard]] TriSurface moved(Tensor const& rotation, Vector const& centre) const;
    /// The same surface with its fluid on the other side.
    [[nodiscard]] TriSurface flipped() const;
    [[nodiscard]] TriSurface renamed(std::string name) const;

    /// Right prism over a polygon of the x-y plane between two heights z: skin of a body, normals outwards. Concave corners are allowed.
    /// @throw CaseError BadInput for fewer than three corners, a polygon that crosses itself, or low >= high.
    static TriSurface prism(std::string name, std::vector<Vector> const& corners, Real low, Real high);
    /// Strips over a chain of the x-y plane, between two heights z. @param left  The fluid is on the left when one walks along the chain.
    static TriSurface extruded(std::string name, std::vector<Vector> const& chain, bool closed, Real low, Real high, bool left);
    /// Strips over an open chain and the two walls at the ends, plane polygons that the straight line from the last to the first corner closes;
    /// the fluid lies between: a channel, open at that line.
    /// @throw CaseError BadInput as for prism.
    static TriSurface channel(std::string name, std::vector<Vector> const& chain, Real low, Real high);
    /// Sides of a box, normals outwards. @param open  Sides left out, in the order -x +x -y +y -z +z.
    static TriSurface box(std::string name, Vector const& low, Vector const& high, std::array<bool, 6> const& open = {});
    /// Closed circular cylinder of `sides` sides, normals outwards.
    static TriSurface cylinder(std::string name, Vector const& end1, Vector const& end2, Real radius, int sides);
    /// Sphere of 20 * 4^k triangles, normals outwards; no edge is longer than `edge`.
    static TriSurface sphere(std::string name, Vector const& centre, Real radius, Real edge);

private:
    void findEdges();
    void findPatches();

    std::string name_;
    std::vector<Vector> points_;
    std::vector<Triangle> triangles_;
    std::vector<Edge> edges_;
    int patches_ = 0;
    bool closed_ = false;
};

} // namespace mpsDem
