#include "scene/SurfaceRays.h"

namespace mpsDem {

namespace {

constexpr Real edge = 1e-9;  ///< Width of edges, in sides of a triangle.
constexpr Real along = 1e-9; ///< Sine of the angle below which a line runs along a triangle.

} // namespace

SurfaceRays::SurfaceRays(std::vector<Surface> const& surfaces)
{
    for (Surface const& surface : surfaces)
    {
        if (surface.flat())
        {
            Vector const across = Vector::UnitZ();
            for (auto const& segment : surface.line().segments())
            {
                add(segment.a - across, segment.b - across, segment.b + across, segment.normal);
                add(segment.a - across, segment.b + across, segment.a + across, segment.normal);
            }
            continue;
        }
        TriSurface const& mesh = surface.triangles();
        for (auto const& t : mesh.triangles()) add(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), t.normal);
    }
    if (!triangles_.empty()) boxes_ = TriangleBoxes(triangles_, 0);
}

void SurfaceRays::add(Vector const& a, Vector const& b, Vector const& c, Vector const& normal)
{
    triangles_.push_back({a, b - a, c - a, normal, static_cast<int>(triangles_.size())});
}

bool SurfaceRays::crosses(TriangleBoxes::Triangle const& triangle, Vector const& from, Vector const& to, Hit& hit)
{
    Vector const way = to - from;
    Real const rise = triangle.normal.dot(way);
    if (std::abs(rise) <= along * way.norm()) return false;
    Real const share = triangle.normal.dot(triangle.a - from) / rise;
    if (!(share >= 0 && share <= 1)) return false;
    Vector const point = from + share * way, ap = point - triangle.a;
    Vector const across = triangle.ab.cross(triangle.ac);
    Real const twice = across.squaredNorm();
    Real const s = ap.cross(triangle.ac).dot(across) / twice, t = triangle.ab.cross(ap).dot(across) / twice;
    if (s < -edge || t < -edge || s + t > 1 + edge) return false;
    hit = {point, triangle.normal, share};
    return true;
}

} // namespace mpsDem
