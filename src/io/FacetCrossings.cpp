#include "io/FacetCrossings.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

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

/// Boxes of all triangles in a tree.
class BoxTree
{
public:
    explicit BoxTree(FacetMesh const& mesh) : mesh_(mesh), order_(mesh.triangles.size())
    {
        std::iota(order_.begin(), order_.end(), 0);
        nodes_.reserve(2 * order_.size());
        build(0, static_cast<int>(order_.size()));
    }

    [[nodiscard]] Corners corners(int t) const
    {
        TriSurface::Corners const& c = mesh_.triangles[at(t)];
        return {mesh_.points[at(c[0])], mesh_.points[at(c[1])], mesh_.points[at(c[2])]};
    }

    /// Calls visit(other) for triangles with a higher number whose boxes meet that of t.
    template <class Visit>
    void forEachNear(int t, Visit visit) const
    {
        auto const [low, high] = box(t);
        std::vector<int> next{0};
        while (!next.empty())
        {
            int const self = next.back();
            Node const& node = nodes_[at(self)];
            next.pop_back();
            if ((node.low.array() > high.array()).any() || (node.high.array() < low.array()).any()) continue;
            if (node.right < 0)
            {
                for (int i = node.first; i < node.last; ++i)
                    if (order_[at(i)] > t) visit(order_[at(i)]);
                continue;
            }
            next.push_back(node.right);
            next.push_back(self + 1);
        }
    }

private:
    struct Node
    {
        Vector low, high;
        int first, last; ///< Triangles of a leaf.
        int right;       ///< Second child; -1 for a leaf. The first one follows its parent.
    };

    [[nodiscard]] std::pair<Vector, Vector> box(int t) const
    {
        Corners const c = corners(t);
        return {c[0].cwiseMin(c[1]).cwiseMin(c[2]), c[0].cwiseMax(c[1]).cwiseMax(c[2])};
    }

    int build(int first, int last)
    {
        int const self = static_cast<int>(nodes_.size());
        auto [low, high] = box(order_[at(first)]);
        for (int i = first + 1; i < last; ++i)
        {
            auto const [l, h] = box(order_[at(i)]);
            low = low.cwiseMin(l);
            high = high.cwiseMax(h);
        }
        nodes_.push_back({low, high, first, last, -1});
        if (last - first <= 4) return self;
        Eigen::Index axis;
        (high - low).maxCoeff(&axis);
        auto const middle = [&](int t) {
            auto const [l, h] = box(t);
            return std::pair(l[axis] + h[axis], t);
        };
        int const half = first + (last - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                         [&](int s, int t) { return middle(s) < middle(t); });
        build(first, half);
        int const right = build(half, last);
        nodes_[at(self)].right = right;
        return self;
    }

    FacetMesh const& mesh_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

bool share(TriSurface::Corners const& a, TriSurface::Corners const& b)
{
    return std::any_of(a.begin(), a.end(), [&](int corner) { return std::find(b.begin(), b.end(), corner) != b.end(); });
}

} // namespace

void requireNoCrossing(FacetMesh const& mesh, FacetSoup const& soup, std::string const& name, Real tolerance)
{
    BoxTree const tree(mesh);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    {
        int found = -1;
        Vector place = Vector::Zero();
        tree.forEachNear(t, [&](int other) {
            if ((found >= 0 && other > found) || share(mesh.triangles[at(t)], mesh.triangles[at(other)])) return;
            auto const middle = cut(tree.corners(t), tree.corners(other), tolerance);
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
