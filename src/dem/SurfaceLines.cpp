#include "dem/SurfaceLines.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

namespace {

/// Sharp edges at each point, and which of the points end a line.
struct SharpGraph
{
    explicit SharpGraph(TriSurface const& skin) : surface(skin), at(skin.points().size()), corner(skin.points().size(), 0)
    {
        for (std::size_t e = 0; e < surface.edges().size(); ++e)
        {
            if (!isSharp(surface, surface.edges()[e])) continue;
            at[static_cast<std::size_t>(surface.edges()[e].a)].push_back(e);
            at[static_cast<std::size_t>(surface.edges()[e].b)].push_back(e);
        }
        for (std::size_t v = 0; v < at.size(); ++v)
            corner[v] = !at[v].empty() && (at[v].size() != 2 || away(at[v][0], v).dot(away(at[v][1], v)) > -sharpEdge);
    }

    [[nodiscard]] Vector const& point(int v) const { return surface.points()[static_cast<std::size_t>(v)]; }
    [[nodiscard]] int otherEnd(std::size_t e, std::size_t v) const
    {
        auto const& edge = surface.edges()[e];
        return static_cast<std::size_t>(edge.a) == v ? edge.b : edge.a;
    }
    /// Unit vector along an edge, away from its end v.
    [[nodiscard]] Vector away(std::size_t e, std::size_t v) const
    {
        return (point(otherEnd(e, v)) - point(static_cast<int>(v))).normalized();
    }

    TriSurface const& surface;
    std::vector<std::vector<std::size_t>> at;
    std::vector<char> corner;
};

/// Edges of one line in order, from its first point on.
struct Line
{
    std::vector<std::size_t> edges;
    std::vector<int> points;
};

Line walk(SharpGraph const& graph, std::size_t first, std::size_t edge, std::vector<char>& used)
{
    Line line{{}, {static_cast<int>(first)}};
    std::size_t v = first;
    while (true)
    {
        used[edge] = 1;
        line.edges.push_back(edge);
        v = static_cast<std::size_t>(graph.otherEnd(edge, v));
        line.points.push_back(static_cast<int>(v));
        if (graph.corner[v]) return line;
        std::size_t const next = graph.at[v][0] == edge ? graph.at[v][1] : graph.at[v][0];
        if (used[next]) return line;
        edge = next;
    }
}

void addPoints(SharpGraph const& graph, Line const& line, Real spacing, std::vector<LinePoint>& points)
{
    Real total = 0;
    auto const length = [&](std::size_t k) { return (graph.point(line.points[k + 1]) - graph.point(line.points[k])).norm(); };
    for (std::size_t k = 0; k < line.edges.size(); ++k) total += length(k);
    int const count = std::max(1, static_cast<int>(std::lround(total / spacing)));
    std::size_t k = 0;
    Real passed = 0;
    for (int i = 0; i < count; ++i)
    {
        Real const along = total * (i + 0.5) / count;
        while (k + 1 < line.edges.size() && passed + length(k) < along) passed += length(k++);
        Vector const &a = graph.point(line.points[k]), &b = graph.point(line.points[k + 1]);
        points.push_back({a + std::min(Real(1), (along - passed) / length(k)) * (b - a), total / count, line.edges[k]});
    }
}

/// Normals around each point that differ by more than 60 degrees make a tip although no edge there is sharp.
std::vector<char> tips(TriSurface const& surface)
{
    std::vector<Vector> sum(surface.points().size(), Vector::Zero());
    for (auto const& t : surface.triangles())
        for (int const v : t.corner) sum[static_cast<std::size_t>(v)] += t.normal;
    std::vector<char> tip(surface.points().size(), 0), ridges(surface.points().size(), 1);
    for (auto const& t : surface.triangles())
        for (int const v : t.corner)
        {
            Vector const& mean = sum[static_cast<std::size_t>(v)];
            if (mean.norm() > 0 && t.normal.dot(mean.normalized()) < sharpEdge) tip[static_cast<std::size_t>(v)] = 1;
        }
    for (auto const& edge : surface.edges())
        if (edge.turn < 0) ridges[static_cast<std::size_t>(edge.a)] = ridges[static_cast<std::size_t>(edge.b)] = 0;
    for (std::size_t v = 0; v < tip.size(); ++v) tip[v] = tip[v] && ridges[v];
    return tip;
}

} // namespace

bool isSharp(TriSurface const& surface, TriSurface::Edge const& edge)
{
    if (edge.rim()) return false;
    Vector const& left = surface.triangles()[static_cast<std::size_t>(edge.left)].normal;
    Vector const& right = surface.triangles()[static_cast<std::size_t>(edge.right)].normal;
    return edge.turn > 0 && left.dot(right) < sharpEdge - 1e-9;
}

std::vector<LinePoint> pointsOnSharpLines(TriSurface const& surface, Real spacing)
{
    SharpGraph const graph(surface);
    std::vector<char> used(surface.edges().size(), 0);
    std::vector<LinePoint> points;
    for (bool const fromCorners : {true, false}) // what is left after the first round are loops
        for (std::size_t v = 0; v < graph.at.size(); ++v)
        {
            if (fromCorners && !graph.corner[v]) continue;
            for (std::size_t const edge : graph.at[v])
                if (!used[edge]) addPoints(graph, walk(graph, v, edge, used), spacing, points);
        }
    return points;
}

std::vector<int> sharpCorners(TriSurface const& surface)
{
    SharpGraph const graph(surface);
    std::vector<char> const tip = tips(surface);
    std::vector<int> corners;
    for (std::size_t v = 0; v < graph.at.size(); ++v)
        if (graph.corner[v] || (graph.at[v].empty() && tip[v])) corners.push_back(static_cast<int>(v));
    return corners;
}

} // namespace mpsDem
