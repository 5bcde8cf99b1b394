#pragma once

#include <array>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Tree of boxes over triangles: the nearest one in a time that grows with the logarithm of their number.
///
/// Ours, for speed: VTK 9.1's cell locators (static, plain) took 8 to 60 us for the nearest of 2e4 to 3e5 triangles near the surface and up to
/// 700 us far from it, this tree about 1 us.
class TriangleBoxes
{
public:
    struct Triangle
    {
        Vector a, ab, ac; ///< A corner and the two sides from it [m].
        Vector normal;    ///< Unit vector.
        int number;       ///< As the owner counts them.
    };

    /// Where on a triangle a place lies: inside, on side k (from corner k to k + 1), or at corner k.
    enum class Part
    {
        Face,
        Side,
        Corner
    };

    struct Hit
    {
        Vector point = Vector::Zero(); ///< On the triangle [m].
        Real distance = -1;            ///< [m]; below zero: nothing found.
        int number = -1;               ///< Of the triangle.
        Part part = Part::Face;
        int k = 0;      ///< Side or corner.
        Real steep = 0; ///< Distance from the triangle's plane over distance: where two are equally near, the steeper one is taken.
    };

    TriangleBoxes() = default;
    /// @param tie  Triangles whose distances differ by less are equally near [m].
    TriangleBoxes(std::vector<Triangle> triangles, Real tie);

    [[nodiscard]] Vector const& low() const { return nodes_.front().low; }
    [[nodiscard]] Vector const& high() const { return nodes_.front().high; }

    /// Nearest triangle that is no further than `limit` (infinity allowed) [m]; number -1 where there is none.
    /// @pre at least one triangle.
    [[nodiscard]] Hit nearest(Vector const& r, Real limit) const;

    /// Calls visit(number) for each triangle whose box comes within `reach` of the box from low to high, in the order of the tree.
    template <class Visit>
    void forEachInBox(Vector const& low, Vector const& high, Visit visit) const
    {
        std::array<int, deepest> stack{};
        int depth = 1;
        while (depth > 0)
        {
            int const self = stack[static_cast<std::size_t>(--depth)];
            Node const& node = nodes_[static_cast<std::size_t>(self)];
            if ((node.low.array() > high.array()).any() || (node.high.array() < low.array()).any()) continue;
            if (node.right < 0)
                for (int i = node.first; i < node.last; ++i) visit(triangles_[static_cast<std::size_t>(i)].number);
            else
            {
                stack[static_cast<std::size_t>(depth++)] = node.right;
                stack[static_cast<std::size_t>(depth++)] = self + 1;
            }
        }
    }

private:
    static constexpr int deepest = 64;

    struct Node
    {
        Vector low, high;
        int first, last; ///< Triangles of a leaf.
        int right;       ///< Second child; -1 for a leaf. The first child follows its parent.
    };

    int build(int first, int last);
    [[nodiscard]] static Real squaredDistance(Node const& node, Vector const& r)
    {
        return (node.low - r).cwiseMax(r - node.high).cwiseMax(Vector::Zero()).squaredNorm();
    }

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
    Real tie_ = 0;
};

/// Place of a triangle that is nearest to r (Ericson, Real-Time Collision Detection, 5.1.5).
TriangleBoxes::Hit nearestOn(TriangleBoxes::Triangle const& triangle, Vector const& r);

} // namespace mpsDem
