#include "boundaries/SegmentTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/Errors.h"

namespace mpsDem {

namespace {

constexpr int leafSize = 4;
constexpr int deepest = 64;

Vector middle(SegmentTree::Item const& item) { return 0.5 * (item.segment.a + item.segment.b); }

} // namespace

SegmentTree::SegmentTree(std::span<Polyline const> chains)
{
    for (std::size_t c = 0; c < chains.size(); ++c)
        for (std::size_t s = 0; s < chains[c].segments().size(); ++s)
            items_.push_back({chains[c].segments()[s], static_cast<int>(c), static_cast<int>(s)});
    if (!items_.empty()) build(0, static_cast<int>(items_.size()));
}

int SegmentTree::build(int first, int last)
{
    int const self = static_cast<int>(nodes_.size());
    Vector low = items_[first].segment.a, high = low, lowMiddle = middle(items_[first]), highMiddle = lowMiddle;
    for (int i = first; i < last; ++i)
    {
        Polyline::Segment const& s = items_[i].segment;
        low = low.cwiseMin(s.a).cwiseMin(s.b);
        high = high.cwiseMax(s.a).cwiseMax(s.b);
        lowMiddle = lowMiddle.cwiseMin(middle(items_[i]));
        highMiddle = highMiddle.cwiseMax(middle(items_[i]));
    }
    nodes_.push_back({low, high, first, last, -1});
    if (last - first <= leafSize) return self;

    int axis = 0;
    (highMiddle - lowMiddle).maxCoeff(&axis);
    int const half = (first + last) / 2;
    std::nth_element(items_.begin() + first, items_.begin() + half, items_.begin() + last, [axis](Item const& a, Item const& b) {
        Real const x = middle(a)[axis], y = middle(b)[axis];
        return x != y ? x < y : a.chain != b.chain ? a.chain < b.chain : a.number < b.number;
    });
    build(first, half);
    nodes_[self].right = build(half, last);
    return self;
}

Real SegmentTree::boxDistance(Node const& node, Vector const& r)
{
    return (node.low - r).cwiseMax(r - node.high).cwiseMax(Vector::Zero()).norm();
}

SegmentTree::Nearest SegmentTree::nearest(Vector const& r) const
{
    expect(!empty(), "SegmentTree::nearest: no segments");
    Nearest best;
    Real bestDistance = std::numeric_limits<Real>::infinity(), bestOff = 0;
    auto const tolerance = [&] { return 1e-12 * (1 + bestDistance); };

    auto const look = [&](int i) {
        Polyline::Segment const& s = items_[i].segment;
        Vector const point = s.a + std::clamp((r - s.a).dot(s.tangent), Real(0), s.length) * s.tangent;
        Real const distance = (r - point).norm();
        Real const off = (r - point).dot(s.normal);
        bool const nearer = best.item < 0 || distance < bestDistance - tolerance();
        bool const squarer = !nearer && distance < bestDistance + tolerance() && std::abs(off) > std::abs(bestOff) * (1 + 1e-12);
        if (!nearer && !squarer) return;
        bestDistance = distance;
        bestOff = off;
        best = {point, off >= 0 ? distance : -distance, i};
    };

    std::array<int, deepest> stack{};
    int depth = 1;
    while (depth > 0)
    {
        Node const& node = nodes_[stack[--depth]];
        if (best.item >= 0 && boxDistance(node, r) > bestDistance + tolerance()) continue;
        if (node.right < 0)
        {
            for (int i = node.first; i < node.last; ++i) look(i);
            continue;
        }
        int const left = static_cast<int>(&node - nodes_.data()) + 1;
        bool const leftNearer = boxDistance(nodes_[left], r) <= boxDistance(nodes_[node.right], r);
        stack[depth++] = leftNearer ? node.right : left;
        stack[depth++] = leftNearer ? left : node.right;
    }
    return best;
}

Real SegmentTree::distance(Vector const& r) const { return empty() ? std::numeric_limits<Real>::infinity() : nearest(r).distance; }

} // namespace mpsDem
