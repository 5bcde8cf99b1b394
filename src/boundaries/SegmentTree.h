#pragma once

#include <span>
#include <vector>

#include "core/Polyline.h"
#include "core/Types.h"

namespace mpsDem {

/// Nearest place on a set of polylines, in a time that grows with the logarithm of the number of segments.
///
/// Several walls of one case behave like one: a place belongs to the nearest segment of them all. Where two segments are equally near
/// (a common corner), the one that the place faces more squarely decides on the sign, as in Polyline::closest.
class SegmentTree
{
public:
    /// A segment and where it comes from.
    struct Item
    {
        Polyline::Segment segment;
        int chain;  ///< Number of the polyline.
        int number; ///< Number of the segment in it.
    };

    /// The nearest place on the polylines.
    struct Nearest
    {
        Vector point = Vector::Zero(); ///< On the polylines [m].
        Real distance = 0;             ///< Signed [m]: positive on the fluid side.
        int item = -1;                 ///< Index for `item()`.
    };

    SegmentTree() = default;
    /// Sorts the segments of all chains into the tree; it keeps copies.
    explicit SegmentTree(std::span<Polyline const> chains);

    [[nodiscard]] bool empty() const { return items_.empty(); }
    [[nodiscard]] Item const& item(int i) const { return items_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] std::vector<Item> const& items() const { return items_; }

    /// @pre Not empty.
    [[nodiscard]] Nearest nearest(Vector const& r) const;

    /// Signed distance [m]; +infinity for an empty set (nothing is near, everything is outside of solids).
    [[nodiscard]] Real distance(Vector const& r) const;

private:
    struct Node
    {
        Vector low, high;
        int first, last; ///< Items of a leaf.
        int right;       ///< Index of the second child; -1 for a leaf. The first child follows its parent.
    };

    int build(int first, int last);
    [[nodiscard]] static Real boxDistance(Node const& node, Vector const& r);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

} // namespace mpsDem
