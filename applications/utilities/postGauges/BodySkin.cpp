#include "postGauges/BodySkin.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace mpsDem::postGauges {

namespace {

constexpr Real smooth = 0.82; ///< Cosine of 35 degrees.

using Key = std::array<Real, 3>;

Key keyOf(Vector const& r) { return {r.x(), r.y(), r.z()}; }

/// Where an edge meets the plane: from the same ends in either order the same point to the last bit.
Vector crossing(Vector a, Vector b, CutPlane const& plane)
{
    if (keyOf(b) < keyOf(a)) std::swap(a, b);
    Real const da = (a - plane.point).dot(plane.normal), db = (b - plane.point).dot(plane.normal);
    return a + da / (da - db) * (b - a);
}

/// Ends of what the plane cuts from each triangle.
std::vector<std::pair<Vector, Vector>> cutSegments(std::vector<std::vector<Vector>> const& polygons, CutPlane const& plane)
{
    std::vector<std::pair<Vector, Vector>> segments;
    auto const above = [&plane](Vector const& r) { return (r - plane.point).dot(plane.normal) >= 0; };
    for (auto const& polygon : polygons)
        for (std::size_t k = 2; k < polygon.size(); ++k)
        {
            std::array<Vector, 3> const corner = {polygon[0], polygon[k - 1], polygon[k]};
            std::vector<Vector> ends;
            for (std::size_t e = 0; e < 3; ++e)
                if (above(corner[e]) != above(corner[(e + 1) % 3])) ends.push_back(crossing(corner[e], corner[(e + 1) % 3], plane));
            if (ends.size() == 2 && keyOf(ends[0]) != keyOf(ends[1])) segments.emplace_back(ends[0], ends[1]);
        }
    return segments;
}

} // namespace

SurfaceMesh smoothSkin(std::vector<std::vector<Vector>> const& polygons)
{
    SurfaceMesh skin;
    std::vector<Vector> flat; // twice the area a triangle
    for (auto const& polygon : polygons)
        for (std::size_t k = 2; k < polygon.size(); ++k)
        {
            int const first = static_cast<int>(skin.points.size());
            for (std::size_t const corner : {std::size_t{0}, k - 1, k}) skin.points.push_back(polygon[corner]);
            skin.triangles.push_back({first, first + 1, first + 2});
            flat.push_back((polygon[k - 1] - polygon[0]).cross(polygon[k] - polygon[0]));
        }
    std::map<Key, std::vector<std::size_t>> at; // corners at each place
    for (std::size_t i = 0; i < skin.points.size(); ++i) at[keyOf(skin.points[i])].push_back(i);
    skin.normals.assign(skin.points.size(), Vector::Zero());
    for (auto const& [place, corners] : at)
        for (std::size_t const i : corners)
        {
            Vector const own = flat[i / 3].normalized();
            for (std::size_t const j : corners)
                if (flat[j / 3].dot(own) > smooth * flat[j / 3].norm()) skin.normals[i] += flat[j / 3];
            Real const length = skin.normals[i].norm();
            skin.normals[i] = length > 0 ? Vector(skin.normals[i] / length) : own;
        }
    return skin;
}

std::vector<std::vector<Vector>> cutChains(std::vector<std::vector<Vector>> const& polygons, CutPlane const& plane)
{
    auto const segments = cutSegments(polygons, plane);
    std::map<Key, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (Vector const& end : {segments[i].first, segments[i].second}) at[keyOf(end)].push_back(i);
    std::vector<bool> used(segments.size(), false);
    std::vector<std::vector<Vector>> chains;
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        if (used[i]) continue;
        used[i] = true;
        std::vector<Vector> chain{segments[i].first, segments[i].second};
        for (bool grows = true; grows;)
        {
            grows = false;
            for (std::size_t const next : at[keyOf(chain.back())])
            {
                if (used[next]) continue;
                used[next] = grows = true;
                chain.push_back(keyOf(segments[next].first) == keyOf(chain.back()) ? segments[next].second : segments[next].first);
                break;
            }
        }
        if (chain.size() > 3 && keyOf(chain.front()) == keyOf(chain.back())) chain.pop_back();
        chains.push_back(std::move(chain));
    }
    return chains;
}

} // namespace mpsDem::postGauges
