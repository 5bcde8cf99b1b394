#pragma once

#include <string>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Oriented chain of straight segments in the x-y plane: a wall, a ramp or the outline of a body in 2-D.
///
/// The normal of each segment points to the outside of the solid, that is into the fluid.
class Polyline
{
public:
    /// One straight piece of the chain.
    struct Segment
    {
        Vector a;       ///< First point [m].
        Vector b;       ///< Second point [m].
        Vector tangent; ///< Unit vector from a to b.
        Vector normal;  ///< Unit normal into the fluid.
        Real length;    ///< [m].
        int patch;      ///< Number of the run of collinear segments to which it belongs; contact history survives within a patch.
    };

    /// Nearest point of the chain to some position.
    struct Closest
    {
        Vector point;  ///< On the chain [m].
        Real distance; ///< Signed [m]: positive on the fluid side.
        int segment;   ///< Index of the segment it lies on.
        bool atVertex; ///< True where the point is an end of the segment.
    };

    enum class FluidSide
    {
        Left,
        Right
    };

    Polyline() = default;

    /// @param points   Corners in order [m]; the third component is ignored and set to zero.
    /// @param closed   Joins the last point to the first.
    /// @param side     Where the fluid lies when one walks from the first point to the last.
    /// @throw CaseError BadInput for fewer than two points, a segment of zero length or a closed chain that crosses itself.
    Polyline(std::string name, std::vector<Vector> points, bool closed, FluidSide side);

    /// Outline of a body: closed, normals outwards whatever the order of the points.
    static Polyline outline(std::string name, std::vector<Vector> points);

    [[nodiscard]] std::string const& name() const { return name_; }
    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] std::vector<Vector> const& points() const { return points_; }
    [[nodiscard]] std::vector<Segment> const& segments() const { return segments_; }

    /// @pre At least one segment.
    [[nodiscard]] Closest closest(Vector const& r) const;

    /// Even-odd test; only for closed chains. True inside the loop, whichever side the fluid is on.
    [[nodiscard]] bool encloses(Vector const& r) const;

    /// Area within a closed chain, positive [m2].
    [[nodiscard]] Real area() const;

    /// The same chain after r -> centre + R r.
    [[nodiscard]] Polyline moved(Tensor const& rotation, Vector const& centre) const;

private:
    void buildSegments(FluidSide side);

    std::string name_;
    std::vector<Vector> points_;
    std::vector<Segment> segments_;
    bool closed_ = false;
};

} // namespace mpsDem
