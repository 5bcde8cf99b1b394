#include "dem/MeshSurface.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

using Joint = Facet::Joint;

namespace {

/// Where a point of a triangle lies: on corner `part` (0..2), on side `part` - 3, or inside (6).
struct OnTriangle
{
    Vector point;
    std::size_t part;
};

/// Nearest point of a triangle to a point that projects beyond at least one side.
OnTriangle nearestOnRim(MeshFace const& face, Vector const& r)
{
    OnTriangle best{face.corner[0], 0};
    Real least = 1e300;
    for (std::size_t k = 0; k < 3; ++k)
    {
        Vector const& a = face.corner[k];
        Vector const side = face.corner[(k + 1) % 3] - a;
        Real const along = std::clamp((r - a).dot(side) / side.squaredNorm(), Real(0), Real(1));
        Vector const point = a + along * side;
        Real const square = (r - point).squaredNorm();
        if (square >= least) continue;
        least = square;
        best = {point, along <= 0 ? k : (along >= 1 ? (k + 1) % 3 : 3 + k)};
    }
    return best;
}

/// Angle of a triangle at its corner k [rad].
Real angleAt(MeshFace const& face, std::size_t k)
{
    Vector const one = face.corner[(k + 1) % 3] - face.corner[k], two = face.corner[(k + 2) % 3] - face.corner[k];
    return std::atan2(one.cross(two).norm(), one.dot(two));
}

} // namespace

MeshSurface::MeshSurface(std::span<TriSurface const> all, std::size_t own, Real depth)
    : depth_(depth),
      faces_(meshFaces(all[own])),
      edges_(meshEdges(all[own], faces_)),
      covers_(rimCovers(all, own, 1e-3 * depth)),
      points_(all[own].points()),
      patches_(all[own].patches()),
      solid_(all[own].closed() && all[own].volume() > 0),
      grid_(all[own], depth)
{
    near_ = std::max(1e-9 * depth, 1e-14 * std::max(grid_.box().low.norm(), grid_.box().high.norm()));
    sharePlanes(faces_, patches_, near_);
    findValleys();
    findVertices(all[own]);
}

void MeshSurface::findValleys()
{
    for (MeshEdge const& edge : edges_)
    {
        if (edge.joint != Joint::Concave) continue;
        int const a = faces_[static_cast<std::size_t>(edge.left)].patch, b = faces_[static_cast<std::size_t>(edge.right)].patch;
        valleys_.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(valleys_.begin(), valleys_.end());
    valleys_.erase(std::unique(valleys_.begin(), valleys_.end()), valleys_.end());
}

void MeshSurface::findVertices(TriSurface const& surface)
{
    std::size_t const count = surface.points().size();
    vertices_.assign(count, {0, -1, false, Vector::Zero()});
    for (std::size_t f = faces_.size(); f-- > 0;)
        for (std::size_t k = 0; k < 3; ++k)
        {
            VertexRole& vertex = vertices_[static_cast<std::size_t>(faces_[f].vertex[k])];
            vertex.owner = static_cast<int>(f);
            vertex.normal += angleAt(faces_[f], k) * faces_[f].normal;
        }
    std::vector<int> degree(count, 0), ridges(count, 0), valleys(count, 0), covered(count, 0);
    for (std::size_t e = 0; e < edges_.size(); ++e)
        for (bool const atA : {true, false})
        {
            auto const v = static_cast<std::size_t>(atA ? surface.edges()[e].a : surface.edges()[e].b);
            ++degree[v];
            Real const along = atA ? 0 : (edges_[e].b - edges_[e].a).norm();
            RimCover const* const cover = coverAt(static_cast<int>(e), along);
            covered[v] += cover != nullptr;
            ridges[v] += edges_[e].joint == Joint::Convex || (edges_[e].joint == Joint::Free && cover == nullptr);
            valleys[v] += edges_[e].joint == Joint::Concave || (cover != nullptr && cover->valley);
        }
    int begin = 0;
    for (std::size_t v = 0; v < count; ++v)
    {
        vertices_[v].edges = begin;
        begin += degree[v];
        vertices_[v].innerCorner = valleys[v] > 0 && ridges[v] == 0;
        if (ridges[v] == 0 || covered[v] > 0) vertices_[v].owner = -1;
    }
    vertices_.push_back({begin, -1, false, Vector::Zero()});
    directions_.resize(static_cast<std::size_t>(begin));
    std::fill(degree.begin(), degree.end(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e)
        for (bool const atA : {true, false})
        {
            auto const v = static_cast<std::size_t>(atA ? surface.edges()[e].a : surface.edges()[e].b);
            directions_[static_cast<std::size_t>(vertices_[v].edges + degree[v]++)] = atA ? edges_[e].tangent : -edges_[e].tangent;
        }
}

RimCover const* MeshSurface::coverAt(int edge, Real along) const
{
    auto cover = std::lower_bound(covers_.begin(), covers_.end(), edge, [](RimCover const& c, int e) { return c.edge < e; });
    for (; cover != covers_.end() && cover->edge == edge; ++cover)
        if (along >= cover->begin && along <= cover->end) return &*cover;
    return nullptr;
}

bool MeshSurface::inside(MeshFace const& face, Vector const& r, Real height) const
{
    for (std::size_t k = 0; k < 3; ++k)
    {
        MeshEdge const& edge = edges_[static_cast<std::size_t>(face.edge[k])];
        bool const straightOn = edge.joint == Joint::Flat || edge.joint == Joint::Free;
        Real const allowed = straightOn ? near_ + std::abs(height * edge.turn) : Real(0);
        if (face.beyond(k, r) > allowed) return false;
    }
    return true;
}

bool MeshSurface::beyondAValley(MeshFace const& face, Vector const& r) const
{
    Vector const foot = r - face.height(r) * face.normal;
    OnTriangle const nearest = nearestOnRim(face, foot);
    if ((foot - nearest.point).squaredNorm() > depth_ * depth_) return false;
    if (nearest.part < 3) return vertices_[static_cast<std::size_t>(face.vertex[nearest.part])].innerCorner;
    int const e = face.edge[nearest.part - 3];
    MeshEdge const& edge = edges_[static_cast<std::size_t>(e)];
    if (edge.joint != Joint::Free) return edge.joint == Joint::Concave;
    RimCover const* const cover = coverAt(e, (nearest.point - edge.a).dot(edge.tangent));
    return cover != nullptr && cover->valley;
}

void MeshSurface::addFace(int number, Sphere const& sphere, Real limit, Query& query) const
{
    MeshFace const& face = faces_[static_cast<std::size_t>(number)];
    Real const height = face.height(sphere.centre);
    if (height < -depth_ || height > limit) return;
    if (!inside(face, sphere.centre, height) && !(height < 0 && beyondAValley(face, sphere.centre))) return;
    query.candidates.push_back(
        {{0, face.patch, face.normal, height - sphere.radius, 0}, height, number, face.patch, Kind::Face, Vector::Zero()});
}

void MeshSurface::addEdges(int number, Sphere const& sphere, Real limit, Query& query) const
{
    MeshFace const& face = faces_[static_cast<std::size_t>(number)];
    for (std::size_t k = 0; k < 3; ++k)
    {
        int const e = face.edge[k];
        MeshEdge const& edge = edges_[static_cast<std::size_t>(e)];
        if (edge.left != number || (edge.joint != Joint::Convex && edge.joint != Joint::Free)) continue;
        if (face.beyond(k, sphere.centre) <= 0) continue;
        if (edge.right >= 0 && faces_[static_cast<std::size_t>(edge.right)].beyond(edge.rightSide, sphere.centre) <= 0) continue;
        Vector const arm = sphere.centre - edge.a;
        Real const along = arm.dot(edge.tangent);
        if (along <= 0 || (sphere.centre - edge.b).dot(edge.tangent) >= 0) continue;
        if (edge.joint == Joint::Free && (face.height(sphere.centre) <= 0 || coverAt(e, along) != nullptr)) continue;
        Vector const across = arm - along * edge.tangent;
        Real const distance = across.norm();
        if (distance > limit || distance <= 0) continue;
        query.candidates.push_back({{0, patches_ + e, across / distance, distance - sphere.radius, 0},
                                    distance,
                                    e,
                                    -1,
                                    Kind::Edge,
                                    edge.a + along * edge.tangent});
    }
}

void MeshSurface::addVertices(int number, Sphere const& sphere, Real limit, Query& query) const
{
    for (int const v : faces_[static_cast<std::size_t>(number)].vertex)
    {
        VertexRole const& vertex = vertices_[static_cast<std::size_t>(v)];
        if (vertex.owner != number) continue;
        Vector const& point = points_[static_cast<std::size_t>(v)];
        Vector const arm = sphere.centre - point;
        Real const distance = arm.norm();
        if (distance > limit || distance <= 0 || arm.dot(vertex.normal) <= 0) continue;
        auto const begin = directions_.begin() + vertex.edges;
        auto const end = directions_.begin() + vertices_[static_cast<std::size_t>(v) + 1].edges;
        if (std::any_of(begin, end, [&](Vector const& away) { return arm.dot(away) > 0; })) continue;
        int const key = patches_ + static_cast<int>(edges_.size()) + v;
        query.candidates.push_back({{0, key, arm / distance, distance - sphere.radius, 0}, distance, v, -1, Kind::Vertex, point});
    }
}

void MeshSurface::dropHidden(Query& query, Real reach) const
{
    auto& candidates = query.candidates;
    auto const nearer = [](Candidate const& a, Candidate const& b) { return std::abs(a.height) < std::abs(b.height); };
    Candidate const nearest = *std::min_element(candidates.begin(), candidates.end(), nearer);
    auto const hidden = [&](Candidate const& c) {
        if (c.feature.gap >= reach) return true;
        if (c.height >= 0 || c.patch == nearest.patch) return false;
        std::pair<int, int> const both(std::min(c.patch, nearest.patch), std::max(c.patch, nearest.patch));
        return nearest.height >= 0 || !std::binary_search(valleys_.begin(), valleys_.end(), both);
    };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), hidden), candidates.end());
}

bool MeshSurface::liesOn(Vector const& point, int patch, std::vector<int> const& near) const
{
    return std::any_of(near.begin(), near.end(), [&](int f) {
        MeshFace const& face = faces_[static_cast<std::size_t>(f)];
        if (face.patch != patch || std::abs(face.height(point)) > near_) return false;
        return face.beyond(0, point) <= near_ && face.beyond(1, point) <= near_ && face.beyond(2, point) <= near_;
    });
}

void MeshSurface::keepDistinct(Query& query) const
{
    auto& candidates = query.candidates;
    std::sort(candidates.begin(), candidates.end(), [](Candidate const& a, Candidate const& b) {
        return a.kind != b.kind ? a.kind < b.kind : (a.feature.gap != b.feature.gap ? a.feature.gap < b.feature.gap : a.number < b.number);
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
        Candidate const candidate = candidates[i];
        auto const covers = [&](Candidate const& other) {
            return other.feature.normal.dot(candidate.feature.normal) > sameDirection ||
                   (candidate.kind != Kind::Face && other.kind == Kind::Face && liesOn(candidate.nearest, other.patch, query.near));
        };
        if (std::any_of(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(kept), covers)) continue;
        candidates[kept++] = candidate;
    }
    candidates.resize(kept, candidates.front());
    std::sort(candidates.begin(), candidates.end(),
              [](Candidate const& a, Candidate const& b) { return a.feature.patch < b.feature.patch; });
}

void MeshSurface::collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const
{
    thread_local Query query;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        Sphere const& sphere = spheres[i];
        if (solid_ && grid_.box().distance(sphere.centre) > sphere.radius + reach) continue;
        Real const limit = std::max(depth_, sphere.radius + reach);
        grid_.near(sphere.centre, limit, query.near);
        query.candidates.clear();
        for (int const face : query.near)
        {
            addFace(face, sphere, limit, query);
            addEdges(face, sphere, limit, query);
            addVertices(face, sphere, limit, query);
        }
        if (query.candidates.empty()) continue;
        dropHidden(query, reach);
        if (query.candidates.empty()) continue;
        keepDistinct(query);
        for (Candidate& candidate : query.candidates)
        {
            candidate.feature.sphere = static_cast<int>(i);
            features.push_back(candidate.feature);
        }
    }
}

void MeshSurface::findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const
{
    thread_local std::vector<int> near;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        Vector const& centre = spheres[i].centre;
        Real const limit = std::max(farthestDepths * depth_, spheres[i].radius) + reach;
        grid_.near(centre, limit, near);
        auto const isNear = [&](int f) {
            MeshFace const& face = faces_[static_cast<std::size_t>(f)];
            return std::abs(face.height(centre)) <= limit && (face.nearest(centre) - centre).squaredNorm() <= limit * limit;
        };
        if (std::any_of(near.begin(), near.end(), isNear)) numbers.push_back(static_cast<int>(i));
    }
}

} // namespace mpsDem
