#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/TriSurface.h"
#include "dem/Facets.h"

namespace mpsDem {

/// A triangle as contact needs it. Side k runs from corner k to corner k + 1.
struct MeshFace
{
    std::array<Vector, 3> corner;  ///< [m].
    std::array<Vector, 3> outward; ///< Unit vectors in the plane of the triangle, out of it through side k.
    Vector normal;                 ///< Into the free space.
    Vector origin;                 ///< A point of its plane [m].
    int patch;                     ///< As in TriSurface::Triangle.
    TriSurface::Corners vertex;    ///< Numbers of the corners.
    TriSurface::Corners edge;      ///< Numbers of the sides.

    /// Length by which r lies beyond side k [m]; negative inside.
    [[nodiscard]] Real beyond(std::size_t k, Vector const& r) const { return (r - corner[k]).dot(outward[k]); }
    [[nodiscard]] Real height(Vector const& r) const { return (r - origin).dot(normal); }
    /// Nearest point of the triangle to r.
    [[nodiscard]] Vector nearest(Vector const& r) const;
};

/// An edge as contact needs it: it runs from a to b, in the sense of rotation of `left`.
struct MeshEdge
{
    Facet::Joint joint;                  ///< Free: a rim. Flat: its two faces are one plane. Concave: a valley. Convex: a ridge.
    Real turn;                           ///< Sine of the angle between the faces.
    Vector a, b;                         ///< [m].
    Vector tangent;                      ///< Unit vector.
    int left, right;                     ///< Faces; right is -1 at a rim.
    std::size_t leftSide, rightSide = 0; ///< Which side of the face it is.
};

/// Part of a rim that lies on another surface, which goes on there.
struct RimCover
{
    int edge;        ///< Number of the rim.
    Real begin, end; ///< Along it from its point a [m].
    bool valley;     ///< The other surface rises into the free space.
};

std::vector<MeshFace> meshFaces(TriSurface const& surface);
/// Gives all faces of a patch one plane where its corners lie on that within `tolerance` [m]: rounding in small or thin triangles is not felt.
void sharePlanes(std::vector<MeshFace>& faces, int patches, Real tolerance);
std::vector<MeshEdge> meshEdges(TriSurface const& surface, std::vector<MeshFace> const& faces);

/// Parts of the rims of surface `own` that lie (within `tolerance` [m]) on one of all surfaces, itself included: the rim of a ramp on a
/// floor, of a floor beside a floor, or where one mesh is cut into finer triangles than its neighbour. Where two rims make a ridge, the
/// surface that comes first keeps it. Sorted by edge.
std::vector<RimCover> rimCovers(std::span<TriSurface const> surfaces, std::size_t own, Real tolerance);

} // namespace mpsDem
