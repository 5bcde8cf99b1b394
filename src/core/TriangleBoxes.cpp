#include "core/TriangleBoxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpsDem {

namespace {

constexpr int leafSize = 4;

Vector middle(TriangleBoxes::Triangle const& t) { return t.a + (t.ab + t.ac) / 3; }

} // namespace

TriangleBoxes::TriangleBoxes(std::vector<Triangle> triangles, Real tie) : triangles_(std::move(triangles)), tie_(tie)
{
    nodes_.reserve(2 * triangles_.size() / leafSize + 8);
    build(0, static_cast<int>(triangles_.size()));
}

int TriangleBoxes::build(int first, int last)
{
    int const self = static_cast<int>(nodes_.size());
    auto const at = [&](int i) -> Triangle const& { return triangles_[static_cast<std::size_t>(i)]; };
    Vector low = at(first).a, high = low, lowMiddle = middle(at(first)), highMiddle = lowMiddle;
    for (int i = first; i < last; ++i)
    {
        Triangle const& t = at(i);
        low = low.cwiseMin(t.a).cwiseMin(t.a + t.ab).cwiseMin(t.a + t.ac);
        high = high.cwiseMax(t.a).cwiseMax(t.a + t.ab).cwiseMax(t.a + t.ac);
        lowMiddle = lowMiddle.cwiseMin(middle(t));
        highMiddle = highMiddle.cwiseMax(middle(t));
    }
    nodes_.push_back({low, high, first, last, -1});
    if (last - first <= leafSize) return self;
    Vector const size = highMiddle - lowMiddle;
    int const axis = size.x() >= size.y() && size.x() >= size.z() ? 0 : size.y() >= size.z() ? 1 : 2;
    int const half = (first + last) / 2;
    std::nth_element(triangles_.begin() + first, triangles_.begin() + half, triangles_.begin() + last,
                     [axis](Triangle const& s, Triangle const& t) {
                         Real const x = middle(s)[axis], y = middle(t)[axis];
                         return x != y ? x < y : s.number < t.number;
                     });
    build(first, half);
    int const right = build(half, last);
    nodes_[static_cast<std::size_t>(self)].right = right;
    return self;
}

TriangleBoxes::Hit nearestOn(TriangleBoxes::Triangle const& t, Vector const& r)
{
    using Part = TriangleBoxes::Part;
    Vector const ap = r - t.a;
    auto const done = [&](Vector const& offset, Part part, int k) {
        Vector const gap = ap - offset;
        Real const distance = gap.norm();
        return TriangleBoxes::Hit{t.a + offset, distance, t.number, part, k, distance > 0 ? std::abs(gap.dot(t.normal)) / distance : 1};
    };
    Real const d1 = t.ab.dot(ap), d2 = t.ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return done(Vector::Zero(), Part::Corner, 0);
    Vector const bp = ap - t.ab;
    Real const d3 = t.ab.dot(bp), d4 = t.ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return done(t.ab, Part::Corner, 1);
    Real const vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return done(d1 / (d1 - d3) * t.ab, Part::Side, 0);
    Vector const cp = ap - t.ac;
    Real const d5 = t.ab.dot(cp), d6 = t.ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return done(t.ac, Part::Corner, 2);
    Real const vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return done(d2 / (d2 - d6) * t.ac, Part::Side, 2);
    Real const va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return done(t.ab + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.ac - t.ab), Part::Side, 1);
    return done(ap - ap.dot(t.normal) * t.normal, Part::Face, 0);
}

TriangleBoxes::Hit TriangleBoxes::nearest(Vector const& r, Real limit) const
{
    Hit best;
    Real reach = limit + tie_;
    Real reach2 = reach * reach;
    auto const look = [&](Triangle const& t) {
        if (std::abs((r - t.a).dot(t.normal)) > reach) return;
        Hit const hit = nearestOn(t, r);
        if (hit.distance > reach) return;
        bool const nearer = best.number < 0 || hit.distance < best.distance - tie_;
        bool const better = hit.steep > best.steep + 1e-9 || (hit.steep > best.steep - 1e-9 && hit.number < best.number);
        if (!nearer && !better) return;
        if (nearer || hit.distance < best.distance)
        {
            reach = hit.distance + tie_;
            reach2 = reach * reach;
        }
        best = hit;
    };
    struct Entry
    {
        int node;
        Real squared;
    };
    std::array<Entry, deepest> stack;
    stack[0] = {0, squaredDistance(nodes_[0], r)};
    std::size_t depth = 1;
    while (depth > 0)
    {
        Entry const entry = stack[--depth];
        if (entry.squared > reach2) continue;
        Node const& node = nodes_[static_cast<std::size_t>(entry.node)];
        if (node.right < 0)
        {
            for (int i = node.first; i < node.last; ++i) look(triangles_[static_cast<std::size_t>(i)]);
            continue;
        }
        Entry nearer{entry.node + 1, squaredDistance(nodes_[static_cast<std::size_t>(entry.node + 1)], r)};
        Entry further{node.right, squaredDistance(nodes_[static_cast<std::size_t>(node.right)], r)};
        if (further.squared < nearer.squared) std::swap(nearer, further);
        if (further.squared <= reach2) stack[depth++] = further;
        if (nearer.squared <= reach2) stack[depth++] = nearer;
    }
    return best;
}

} // namespace mpsDem
