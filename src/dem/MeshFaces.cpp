#include "dem/MeshFaces.h"

#include <algorithm>
#include <cmath>

#include "dem/TriangleGrid.h"

namespace mpsDem {

namespace {

constexpr Real flatTurn = 1e-6;     ///< Sine up to which two faces are one plane.
constexpr Real ridgeFacing = 0.087; ///< Sine of 5 degrees: a face that leans away by more makes a ridge with what ends on it.

/// Part [begin, end] of a line, cut by conditions that are linear along it.
struct Interval
{
    Real begin, end;

    /// Keeps where value + slope s <= 0.
    void cut(Real value, Real slope)
    {
        if (slope > 0)
            end = std::min(end, -value / slope);
        else if (slope < 0)
            begin = std::max(begin, -value / slope);
        else if (value > 0)
            end = begin - 1;
    }
};

/// Looks for the parts of one rim that lie on faces of one surface.
class RimSearch
{
public:
    RimSearch(MeshFace const& face, MeshEdge const& edge, int number, Real tolerance)
        : face_(face),
          edge_(edge),
          number_(number),
          tolerance_(tolerance),
          length_((edge.b - edge.a).norm())
    {}

    [[nodiscard]] Real length() const { return length_; }

    /// @param first  The other surface comes before this one. @param rims  Which sides of the other face are rims.
    void add(MeshFace const& other, std::array<bool, 3> const& rims, bool first, std::vector<RimCover>& covers) const
    {
        Real const facing = other.normal.dot(face_.outward[edge_.leftSide]);
        Interval part{0, length_};
        Real const height = other.height(edge_.a), climb = other.normal.dot(edge_.tangent);
        part.cut(height - tolerance_, climb);
        part.cut(-height - tolerance_, -climb);
        for (std::size_t k = 0; k < 3; ++k) part.cut(other.beyond(k, edge_.a) - tolerance_, other.outward[k].dot(edge_.tangent));
        if (facing <= ridgeFacing)
        {
            keep(part, facing < -1e-4, covers);
            return;
        }
        for (std::size_t k = 0; k < 3; ++k)
        {
            if (!first || !rims[k]) continue;
            Interval along = part;
            along.cut(-other.beyond(k, edge_.a) - tolerance_, -other.outward[k].dot(edge_.tangent));
            keep(along, false, covers);
        }
    }

private:
    void keep(Interval const& part, bool valley, std::vector<RimCover>& covers) const
    {
        if (part.end - part.begin > 10 * tolerance_) covers.push_back({number_, part.begin - tolerance_, part.end + tolerance_, valley});
    }

    MeshFace const& face_;
    MeshEdge const& edge_;
    int number_;
    Real tolerance_;
    Real length_;
};

std::array<bool, 3> rimsOf(MeshFace const& face, TriSurface const& surface)
{
    std::array<bool, 3> rims{};
    for (std::size_t k = 0; k < 3; ++k) rims[k] = surface.edges()[static_cast<std::size_t>(face.edge[k])].rim();
    return rims;
}

} // namespace

Vector MeshFace::nearest(Vector const& r) const
{
    if (beyond(0, r) <= 0 && beyond(1, r) <= 0 && beyond(2, r) <= 0) return r - height(r) * normal;
    Vector best = corner[0];
    for (std::size_t k = 0; k < 3; ++k)
    {
        Vector const side = corner[(k + 1) % 3] - corner[k];
        Real const along = std::clamp((r - corner[k]).dot(side) / side.squaredNorm(), Real(0), Real(1));
        Vector const point = corner[k] + along * side;
        if ((point - r).squaredNorm() < (best - r).squaredNorm()) best = point;
    }
    return best;
}

std::vector<MeshFace> meshFaces(TriSurface const& surface)
{
    std::vector<MeshFace> faces;
    faces.reserve(surface.triangles().size());
    for (auto const& t : surface.triangles())
    {
        MeshFace face{{surface.point(t, 0), surface.point(t, 1), surface.point(t, 2)},
                      {},
                      t.normal,
                      surface.point(t, 0),
                      t.patch,
                      t.corner,
                      {-1, -1, -1}};
        for (std::size_t k = 0; k < 3; ++k) face.outward[k] = (face.corner[(k + 1) % 3] - face.corner[k]).cross(t.normal).normalized();
        faces.push_back(face);
    }
    for (std::size_t e = 0; e < surface.edges().size(); ++e)
        for (int const t : {surface.edges()[e].left, surface.edges()[e].right})
        {
            if (t < 0) continue;
            MeshFace& face = faces[static_cast<std::size_t>(t)];
            int const a = surface.edges()[e].a, b = surface.edges()[e].b;
            for (std::size_t k = 0; k < 3; ++k)
            {
                int const from = face.vertex[k], to = face.vertex[(k + 1) % 3];
                if ((from == a && to == b) || (from == b && to == a)) face.edge[k] = static_cast<int>(e);
            }
        }
    return faces;
}

void sharePlanes(std::vector<MeshFace>& faces, int patches, Real tolerance)
{
    auto const count = static_cast<std::size_t>(patches);
    std::vector<Vector> normals(count, Vector::Zero()), origins(count, Vector::Constant(1e300));
    for (MeshFace const& face : faces)
    {
        auto const p = static_cast<std::size_t>(face.patch);
        if (normals[p].isZero()) origins[p] = face.corner[0];
        normals[p] += (face.corner[1] - face.corner[0]).cross(face.corner[2] - face.corner[0]);
    }
    for (Vector& normal : normals) normal.normalize();
    std::vector<char> bent(count, 0);
    for (MeshFace const& face : faces)
    {
        auto const p = static_cast<std::size_t>(face.patch);
        for (Vector const& corner : face.corner)
            if (std::abs((corner - origins[p]).dot(normals[p])) > tolerance) bent[p] = 1;
    }
    for (MeshFace& face : faces)
    {
        auto const p = static_cast<std::size_t>(face.patch);
        if (bent[p]) continue;
        face.normal = normals[p];
        face.origin = origins[p];
    }
}

std::vector<MeshEdge> meshEdges(TriSurface const& surface, std::vector<MeshFace> const& faces)
{
    auto const sideOf = [&](int face, std::size_t e) {
        auto const& edges = faces[static_cast<std::size_t>(face)].edge;
        return static_cast<std::size_t>(std::find(edges.begin(), edges.end(), static_cast<int>(e)) - edges.begin());
    };
    std::vector<MeshEdge> edges;
    edges.reserve(surface.edges().size());
    for (std::size_t e = 0; e < surface.edges().size(); ++e)
    {
        TriSurface::Edge const& s = surface.edges()[e];
        Vector const& a = surface.points()[static_cast<std::size_t>(s.a)];
        Vector const& b = surface.points()[static_cast<std::size_t>(s.b)];
        MeshEdge edge{Facet::Joint::Free, s.turn, a, b, (b - a).normalized(), s.left, s.right, sideOf(s.left, e), 0};
        if (!s.rim())
        {
            edge.rightSide = sideOf(s.right, e);
            bool const folded = faces[static_cast<std::size_t>(s.left)].normal.dot(faces[static_cast<std::size_t>(s.right)].normal) < 0;
            bool const flat = !folded && std::abs(s.turn) <= flatTurn;
            edge.joint = flat ? Facet::Joint::Flat : (s.turn < 0 ? Facet::Joint::Concave : Facet::Joint::Convex);
        }
        edges.push_back(edge);
    }
    return edges;
}

std::vector<RimCover> rimCovers(std::span<TriSurface const> surfaces, std::size_t own, Real tolerance)
{
    std::vector<RimCover> covers;
    std::vector<MeshFace> const faces = meshFaces(surfaces[own]);
    std::vector<MeshEdge> const edges = meshEdges(surfaces[own], faces);
    if (surfaces[own].closed()) return covers;
    std::vector<int> near;
    for (std::size_t other = 0; other < surfaces.size(); ++other)
    {
        TriangleGrid const grid(surfaces[other], std::max(100 * tolerance, (surfaces[other].high() - surfaces[other].low()).norm() / 50));
        std::vector<MeshFace> const targets = meshFaces(surfaces[other]);
        for (std::size_t e = 0; e < edges.size(); ++e)
        {
            if (edges[e].right >= 0) continue;
            RimSearch const search(faces[static_cast<std::size_t>(edges[e].left)], edges[e], static_cast<int>(e), tolerance);
            grid.near(0.5 * (edges[e].a + edges[e].b), 0.5 * search.length() + tolerance, near);
            for (int const t : near)
            {
                MeshFace const& target = targets[static_cast<std::size_t>(t)];
                if (other == own && target.patch == faces[static_cast<std::size_t>(edges[e].left)].patch) continue;
                search.add(target, rimsOf(target, surfaces[other]), other < own || (other == own && t < edges[e].left), covers);
            }
        }
    }
    std::stable_sort(covers.begin(), covers.end(), [](RimCover const& a, RimCover const& b) { return a.edge < b.edge; });
    return covers;
}

} // namespace mpsDem
