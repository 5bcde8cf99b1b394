#pragma once

#include <cmath>
#include <vector>

#include "core/Surface.h"
#include "core/TriangleBoxes.h"

namespace mpsDem {

/// Where straight lines cross surfaces, lines (2-D) or triangles (3-D). Lines count as strips across the x-y plane.
class SurfaceRays
{
public:
    struct Hit
    {
        Vector point;  ///< [m]
        Vector normal; ///< Of the surface there, into the fluid.
        Real share;    ///< Of the way.
    };

    explicit SurfaceRays(std::vector<Surface> const& surfaces);

    /// Calls visit(hit) for each crossing between two points, in no order of the way. A line through an edge crosses both triangles; one along a
    /// surface does not cross it.
    template <class Visit>
    void forEachHit(Vector const& from, Vector const& to, Visit visit) const
    {
        if (triangles_.empty()) return;
        Vector const low = from.cwiseMin(to), high = from.cwiseMax(to);
        boxes_.forEachInBox(low, high, [&](int number) {
            Hit hit;
            if (crosses(triangles_[static_cast<std::size_t>(number)], from, to, hit)) visit(hit);
        });
    }

private:
    void add(Vector const& a, Vector const& b, Vector const& c, Vector const& normal);
    static bool crosses(TriangleBoxes::Triangle const& triangle, Vector const& from, Vector const& to, Hit& hit);

    std::vector<TriangleBoxes::Triangle> triangles_;
    TriangleBoxes boxes_;
};

} // namespace mpsDem
