#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/Errors.h"
#include "dem/ContactPoints.h"
#include "dem/MeshSurface.h"
#include "dem/SurfaceLines.h"
#include "dem/SurfaceTiles.h"

namespace mpsDem {

namespace {

/// Pieces of a surface that share their area among their points: a plane patch that is large enough, else small patches that go on into
/// one another without a sharp edge.
struct Pieces
{
    std::vector<int> ofTriangle; ///< Number of the piece.
    std::vector<std::vector<int>> triangles;
    std::vector<char> plane;
    std::vector<Real> area;

    Pieces(TriSurface const& surface, Real leastPlane)
    {
        std::vector<Real> patchArea(static_cast<std::size_t>(surface.patches()), 0);
        for (auto const& t : surface.triangles()) patchArea[static_cast<std::size_t>(t.patch)] += t.area;
        std::vector<int> parent(patchArea.size());
        std::iota(parent.begin(), parent.end(), 0);
        auto const root = [&](int p) {
            while (parent[static_cast<std::size_t>(p)] != p) p = parent[static_cast<std::size_t>(p)];
            return p;
        };
        for (auto const& edge : surface.edges())
        {
            auto const& left = surface.triangles()[static_cast<std::size_t>(edge.left)];
            auto const& right = surface.triangles()[static_cast<std::size_t>(edge.right)];
            bool const small =
                std::max(patchArea[static_cast<std::size_t>(left.patch)], patchArea[static_cast<std::size_t>(right.patch)]) < leastPlane;
            if (!small || left.normal.dot(right.normal) < sharpEdge - 1e-9) continue;
            int const a = root(left.patch), b = root(right.patch);
            parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        }
        number(surface, patchArea, root);
    }

private:
    template <class Root>
    void number(TriSurface const& surface, std::vector<Real> const& patchArea, Root const& root)
    {
        std::vector<int> piece(patchArea.size(), -1);
        int index = 0;
        for (auto const& t : surface.triangles())
        {
            int const first = root(t.patch);
            int& own = piece[static_cast<std::size_t>(first)];
            if (own < 0)
            {
                own = static_cast<int>(triangles.size());
                triangles.emplace_back();
                plane.push_back(1);
                area.push_back(0);
            }
            auto const k = static_cast<std::size_t>(own);
            if (t.patch != first) plane[k] = 0;
            triangles[k].push_back(index++);
            area[k] += t.area;
            ofTriangle.push_back(own);
        }
    }
};

/// A sphere of one face stays clear of faces beyond a sharp edge by this part of its radius, so that they touch with their own points only.
constexpr Real clearance = 0.25;

/// Largest radius <= `radius` of a sphere inside the body that touches the given face at r.
Real inscribedRadius(MeshSurface const& skin, int face, Vector const& r, Real radius)
{
    std::vector<int> near;
    skin.grid().near(r, (2 + clearance) * radius, near);
    auto const at = [&](int f) -> MeshFace const& { return skin.faces()[static_cast<std::size_t>(f)]; };
    auto const room = [&](int f) { return at(f).normal.dot(at(face).normal) < sharpEdge - 1e-9 ? 1 + clearance : 1 - 1e-9; };
    auto const fits = [&](Real candidate) {
        Vector const centre = r - candidate * at(face).normal;
        return std::all_of(near.begin(), near.end(), [&](int f) {
            return at(f).patch == at(face).patch || (at(f).nearest(centre) - centre).norm() >= candidate * room(f);
        });
    };
    if (fits(radius)) return radius;
    Real low = 0;
    Real high = radius;
    for (int step = 0; step < 50; ++step)
    {
        Real const middle = 0.5 * (low + high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

/// Number of the triangle of a piece that is nearest to the centre of one of its tiles.
int nearestTriangle(MeshSurface const& skin, Pieces const& pieces, std::size_t piece, Vector const& r, Real spacing)
{
    std::vector<int> near;
    skin.grid().near(r, spacing, near);
    std::erase_if(near, [&](int f) { return pieces.ofTriangle[static_cast<std::size_t>(f)] != static_cast<int>(piece); });
    std::vector<int> const& choice = near.empty() ? pieces.triangles[piece] : near;
    auto const distance = [&](int f) { return (skin.faces()[static_cast<std::size_t>(f)].nearest(r) - r).squaredNorm(); };
    return *std::min_element(choice.begin(), choice.end(), [&](int a, int b) { return distance(a) < distance(b); });
}

/// Radius-0 point with the pieces whose area it takes part of.
struct EdgePoint
{
    Vector position;
    Real area;
    std::vector<int> pieces; ///< A piece that is on both sides of it counts twice.
};

std::vector<EdgePoint> edgePoints(TriSurface const& surface, Pieces const& pieces, Real spacing)
{
    std::vector<EdgePoint> points;
    for (LinePoint const& point : pointsOnSharpLines(surface, spacing))
    {
        auto const& edge = surface.edges()[point.edge];
        points.push_back(
            {point.position,
             0.5 * spacing * point.length,
             {pieces.ofTriangle[static_cast<std::size_t>(edge.left)], pieces.ofTriangle[static_cast<std::size_t>(edge.right)]}});
    }
    std::vector<int> const corners = sharpCorners(surface);
    std::size_t const first = points.size();
    for (int const v : corners) points.push_back({surface.points()[static_cast<std::size_t>(v)], 0.5 * spacing * spacing, {}});
    for (std::size_t t = 0; t < surface.triangles().size(); ++t)
        for (int const v : surface.triangles()[t].corner)
        {
            auto const corner = std::lower_bound(corners.begin(), corners.end(), v);
            if (corner == corners.end() || *corner != v) continue;
            auto& list = points[first + static_cast<std::size_t>(corner - corners.begin())].pieces;
            if (std::find(list.begin(), list.end(), pieces.ofTriangle[t]) == list.end()) list.push_back(pieces.ofTriangle[t]);
        }
    return points;
}

/// Cuts the areas of edge points so that no piece gives them more than half of its own. @return what each piece has left [m2].
std::vector<Real> shareArea(Pieces const& pieces, std::vector<EdgePoint>& points)
{
    std::vector<Real> asked(pieces.area.size(), 0);
    for (EdgePoint const& point : points)
        for (int const p : point.pieces) asked[static_cast<std::size_t>(p)] += point.area;
    std::vector<Real> left = pieces.area;
    for (EdgePoint& point : points)
    {
        Real part = 1;
        for (int const p : point.pieces)
            part = std::min(part, 0.5 * pieces.area[static_cast<std::size_t>(p)] / asked[static_cast<std::size_t>(p)]);
        point.area *= part;
        for (int const p : point.pieces) left[static_cast<std::size_t>(p)] -= point.area;
    }
    return left;
}

} // namespace

void ContactPointSet::addSurface(TriSurface const& surface, Real spacing)
{
    require(surface.closed(), {}, "surface \"" + surface.name() + "\" of a body is not closed", "a closed surface");
    MeshSurface const skin(surface, spacing);
    Pieces const pieces(surface, 2 * spacing * spacing);
    std::vector<EdgePoint> edges = edgePoints(surface, pieces, spacing);
    std::vector<Real> const left = shareArea(pieces, edges);
    Real const cell = spacing * spacing;
    largestSide_ = cell;
    for (std::size_t p = 0; p < left.size(); ++p)
    {
        bool const plane = pieces.plane[p] != 0;
        if (plane) largestSide_ = std::max(largestSide_, pieces.area[p]);
        for (SurfaceTile const& tile : cutIntoTiles(surface, pieces.triangles[p], plane, spacing))
        {
            int const face = nearestTriangle(skin, pieces, p, tile.centre, spacing);
            MeshFace const& side = skin.faces()[static_cast<std::size_t>(face)];
            Vector const r = side.nearest(tile.centre);
            Real const radius = inscribedRadius(skin, face, r, 0.5 * spacing);
            Real const area = tile.area * left[p] / pieces.area[p];
            points_.push_back({r - radius * side.normal, radius, 0.5 * spacing, area, area / cell});
        }
    }
    for (EdgePoint const& point : edges) points_.push_back({point.position, 0, 0.5 * spacing, point.area, point.area / cell});
}

} // namespace mpsDem
