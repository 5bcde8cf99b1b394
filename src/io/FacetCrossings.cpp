#include "io/FacetCrossings.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/TriangleBoxes.h"

namespace mpsDem {

namespace {

using Corners = std::array<Vector, 3>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Signed distances of corners from the plane of a triangle; nothing unless some lie on each side of it.
std::optional<std::array<Real, 3>> bothSides(Corners const& corners, Corners const& plane, Vector const& normal, Real tolerance)
{
    std::array<Real, 3> distance;
    for (std::size_t k = 0; k < 3; ++k) distance[k] = normal.dot(corners[k] - plane[0]);
    auto const [low, high] = std::minmax_element(distance.begin(), distance.end());
    if (*low >= -tolerance || *high <= tolerance) return std::nullopt;
    return distance;
}

/// Piece of the planes' common line within a triangle, as positions along it.
std::pair<Real, Real> pieceWithin(Corners const& corners, std::array<Real, 3> const& distance, Vector const& line, Vector const& origin)
{
    std::array<Real, 2> ends{};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k)
    {
        std::size_t const next = (k + 1) % 3;
        if ((distance[k] < 0) == (distance[next] < 0)) continue;
        Vector const r = corners[k] + distance[k] / (distance[k] - distance[next]) * (corners[next] - corners[k]);
        ends[found++] = line.dot(r - origin);
    }
    return std::minmax(ends[0], ends[1]);
}

/// The middle of the line along which two triangles cut each other.
std::optional<Vector> cut(Corners const& a, Corners const& b, Real tolerance)
{
    Vector const na = (a[1] - a[0]).cross(a[2] - a[0]).normalized(), nb = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
    auto const da = bothSides(a, b, nb, tolerance);
    if (!da) return std::nullopt;
    auto const db = bothSides(b, a, na, tolerance);
    if (!db) return std::nullopt;
    Vector const line = na.cross(nb).normalized();
    auto const [lowA, highA] = pieceWithin(a, *da, line, a[0]);
    auto const [lowB, highB] = pieceWithin(b, *db, line, a[0]);
    Real const low = std::max(lowA, lowB), high = std::min(highA, highB);
    if (!(high - low > tolerance)) return std::nullopt;
    // Any edge of a that crosses b's plane does so on the line.
    for (std::size_t k = 0; k < 3; ++k)
    {
        std::size_t const next = (k + 1) % 3;
        if (((*da)[k] < 0) == ((*da)[next] < 0)) continue;
        Vector const r = a[k] + (*da)[k] / ((*da)[k] - (*da)[next]) * (a[next] - a[k]);
        return r + ((low + high) / 2 - line.dot(r - a[0])) * line;
    }
    return std::nullopt;
}

Corners cornersOf(FacetMesh const& mesh, int t)
{
    TriSurface::Corners const& c = mesh.triangles[at(t)];
    return {mesh.points[at(c[0])], mesh.points[at(c[1])], mesh.points[at(c[2])]};
}

TriangleBoxes boxesOf(FacetMesh const& mesh)
{
    std::vector<TriangleBoxes::Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    {
        Corners const c = cornersOf(mesh, t);
        Vector const ab = c[1] - c[0], ac = c[2] - c[0];
        triangles.push_back({c[0], ab, ac, ab.cross(ac).normalized(), t});
    }
    return {std::move(triangles), 0};
}

bool share(TriSurface::Corners const& a, TriSurface::Corners const& b)
{
    return std::any_of(a.begin(), a.end(), [&](int corner) { return std::find(b.begin(), b.end(), corner) != b.end(); });
}

} // namespace

void requireNoCrossing(FacetMesh const& mesh, FacetSoup const& soup, std::string const& name, Real tolerance)
{
    TriangleBoxes const boxes = boxesOf(mesh);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    {
        Corners const own = cornersOf(mesh, t);
        int found = -1;
        Vector place = Vector::Zero();
        boxes.forEachInBox(own[0].cwiseMin(own[1]).cwiseMin(own[2]), own[0].cwiseMax(own[1]).cwiseMax(own[2]), [&](int other) {
            if (other <= t || (found >= 0 && other > found) || share(mesh.triangles[at(t)], mesh.triangles[at(other)])) return;
            auto const middle = cut(own, cornersOf(mesh, other), tolerance);
            if (!middle) return;
            found = other;
            place = *middle;
        });
        require(found < 0, soup.place(at(mesh.facet[at(t)])),
                "surface \"" + name + "\": facet " + std::to_string(mesh.facet[at(t)] + 1) + " and facet " +
                    std::to_string(found < 0 ? 0 : mesh.facet[at(found)] + 1) + " cut through each other at " + placeText(place) + " m",
                "a skin that does not cross itself; solids that overlap: united in a mesh tool");
    }
}

} // namespace mpsDem
