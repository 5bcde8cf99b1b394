#include "core/TriSurface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// Neighbours whose normals differ by less than this (sine) lie in one plane.
constexpr Real flat = 1e-7;

/// One side of a triangle, its points in rising order.
struct Side
{
    int low, high;
    int triangle;
    bool forwards; ///< The triangle runs from low to high.
};

std::vector<Side> sidesOf(std::vector<TriSurface::Triangle> const& triangles)
{
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            int const a = triangles[t].corner[k], b = triangles[t].corner[(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
        }
    std::sort(sides.begin(), sides.end(), [](Side const& s, Side const& t) {
        return s.low != t.low ? s.low < t.low : s.high != t.high ? s.high < t.high : s.triangle < t.triangle;
    });
    return sides;
}

int rootOf(std::vector<int>& parent, int i)
{
    while (parent[static_cast<std::size_t>(i)] != i)
        i = parent[static_cast<std::size_t>(i)] = parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
    return i;
}

std::string place(Vector const& r) { return "(" + shortNumber(r.x()) + " " + shortNumber(r.y()) + " " + shortNumber(r.z()) + ")"; }

} // namespace

TriSurface::TriSurface(std::string name, std::vector<Vector> points, std::vector<Corners> const& triangles)
    : name_(std::move(name)),
      points_(std::move(points))
{
    std::string const self = "surface \"" + name_ + "\"";
    require(!triangles.empty(), {}, self + " has no triangle", "one or more");
    int const count = static_cast<int>(points_.size());
    for (Vector const& r : points_) require(r.allFinite(), {}, self + " has a point that is not finite", "numbers");
    triangles_.reserve(triangles.size());
    for (Corners const& corner : triangles)
    {
        std::string const which = self + ": triangle " + std::to_string(triangles_.size());
        for (int const k : corner)
            require(k >= 0 && k < count, {}, which + " has no point " + std::to_string(k), "0 to " + std::to_string(count - 1));
        Vector const& a = points_[static_cast<std::size_t>(corner[0])];
        Vector const twice = (points_[static_cast<std::size_t>(corner[1])] - a).cross(points_[static_cast<std::size_t>(corner[2])] - a);
        Real const norm = twice.norm();
        require(norm > 0, {}, which + " at " + place(a) + " has no area", "leave it out");
        triangles_.push_back({corner, twice / norm, norm / 2, 0});
    }
    findEdges();
    findPatches();
}

void TriSurface::findEdges()
{
    std::vector<Side> const sides = sidesOf(triangles_);
    closed_ = true;
    for (std::size_t i = 0; i < sides.size();)
    {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
        Side const& s = sides[i];
        std::string const where = "surface \"" + name_ + "\": the edge at " +
                                  place(0.5 * (points_[static_cast<std::size_t>(s.low)] + points_[static_cast<std::size_t>(s.high)]));
        require(end - i <= 2, {}, where + " belongs to " + std::to_string(end - i) + " triangles", "two, or one at a rim");
        Edge edge{s.forwards ? s.low : s.high, s.forwards ? s.high : s.low, s.triangle, -1, 0};
        if (end - i == 2)
        {
            require(sides[i + 1].forwards != s.forwards, {}, where + " lies between triangles of opposite orientation",
                    "all normals on the fluid's side");
            edge.right = sides[i + 1].triangle;
            Vector const along = (points_[static_cast<std::size_t>(edge.b)] - points_[static_cast<std::size_t>(edge.a)]).normalized();
            edge.turn = triangles_[static_cast<std::size_t>(edge.left)]
                            .normal.cross(triangles_[static_cast<std::size_t>(edge.right)].normal)
                            .dot(along);
        }
        closed_ = closed_ && !edge.rim();
        edges_.push_back(edge);
        i = end;
    }
}

void TriSurface::findPatches()
{
    std::vector<int> parent(triangles_.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (Edge const& edge : edges_)
    {
        if (edge.rim() || std::abs(edge.turn) > flat) continue;
        if (triangles_[static_cast<std::size_t>(edge.left)].normal.dot(triangles_[static_cast<std::size_t>(edge.right)].normal) < 0)
            continue;
        int const a = rootOf(parent, edge.left), b = rootOf(parent, edge.right);
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<int> number(triangles_.size(), -1);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        int& own = number[static_cast<std::size_t>(rootOf(parent, static_cast<int>(t)))];
        if (own < 0) own = patches_++;
        triangles_[t].patch = own;
    }
}

Real TriSurface::area() const
{
    Real sum = 0;
    for (Triangle const& t : triangles_) sum += t.area;
    return sum;
}

Real TriSurface::volume() const
{
    Vector const origin = 0.5 * (low() + high()); // no loss of digits far from the origin
    Real sum = 0;
    for (Triangle const& t : triangles_) sum += (centre(t) - origin).dot(t.normal) * t.area / 3;
    return sum;
}

Vector TriSurface::low() const
{
    Vector corner = points_.front();
    for (Vector const& r : points_) corner = corner.cwiseMin(r);
    return corner;
}

Vector TriSurface::high() const
{
    Vector corner = points_.front();
    for (Vector const& r : points_) corner = corner.cwiseMax(r);
    return corner;
}

TriSurface TriSurface::moved(Tensor const& rotation, Vector const& centre) const
{
    TriSurface copy = *this;
    for (Vector& r : copy.points_) r = centre + rotation * r;
    for (Triangle& t : copy.triangles_) t.normal = rotation * t.normal;
    return copy;
}

TriSurface TriSurface::flipped() const
{
    TriSurface copy = *this;
    for (Triangle& t : copy.triangles_)
    {
        std::swap(t.corner[1], t.corner[2]);
        t.normal = -t.normal;
    }
    for (Edge& edge : copy.edges_)
    {
        std::swap(edge.a, edge.b);
        edge.turn = -edge.turn;
    }
    return copy;
}

TriSurface TriSurface::renamed(std::string name) const
{
    TriSurface copy = *this;
    copy.name_ = std::move(name);
    return copy;
}

} // namespace mpsDem
