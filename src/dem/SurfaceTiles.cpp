#include "dem/SurfaceTiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "dem/ContactSurface.h"

namespace mpsDem {

namespace {

using Polygon = std::vector<Vector>;
using Cell = std::array<int, 3>;

struct Moments
{
    Real area = 0;
    Vector first = Vector::Zero();
};

/// The part of a convex polygon with sign (r[axis] - limit) <= 0.
Polygon cut(Polygon const& polygon, int axis, Real limit, Real sign)
{
    Polygon part;
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
        Vector const &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        Real const fromA = sign * (a[axis] - limit), fromB = sign * (b[axis] - limit);
        if (fromA <= 0) part.push_back(a);
        if ((fromA < 0 && fromB > 0) || (fromA > 0 && fromB < 0)) part.push_back(a + fromA / (fromA - fromB) * (b - a));
    }
    return part;
}

/// Rectangular cells over a piece of surface, in axes of its own.
class Cells
{
public:
    Cells(Tensor const& axes, Box const& box, Real spacing) : axes_(axes), low_(box.low)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            Real const length = box.high[axis] - box.low[axis];
            count_[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::lround(length / spacing)));
            size_[axis] = std::max(length / count_[static_cast<std::size_t>(axis)], 1e-12 * spacing);
        }
    }

    void add(Polygon const& triangle) { split(triangle, 0, {0, 0, 0}); }

    [[nodiscard]] std::vector<SurfaceTile> tiles() const
    {
        std::vector<SurfaceTile> tiles;
        for (auto const& [cell, moments] : moments_)
            if (moments.area > 0) tiles.push_back({moments.area, axes_.transpose() * (moments.first / moments.area)});
        return tiles;
    }

private:
    void split(Polygon const& polygon, int axis, Cell cell)
    {
        if (polygon.size() < 3) return;
        if (axis == 3)
        {
            measure(polygon, moments_[cell]);
            return;
        }
        Box box;
        for (Vector const& r : polygon) box.add(r);
        auto const index = static_cast<std::size_t>(axis);
        auto const number = [&](Real x) {
            return static_cast<int>(std::clamp(std::floor((x - low_[axis]) / size_[axis]), Real(0), Real(count_[index] - 1)));
        };
        int const first = number(box.low[axis]), last = number(box.high[axis]);
        for (int i = first; i <= last; ++i)
        {
            cell[index] = i;
            Polygon part = i > first ? cut(polygon, axis, low_[axis] + i * size_[axis], -1) : polygon;
            if (i < last) part = cut(part, axis, low_[axis] + (i + 1) * size_[axis], 1);
            split(part, axis + 1, cell);
        }
    }

    static void measure(Polygon const& polygon, Moments& moments)
    {
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        {
            Real const area = 0.5 * (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]).norm();
            moments.area += area;
            moments.first += area / 3 * (polygon[0] + polygon[k] + polygon[k + 1]);
        }
    }

    Tensor axes_; ///< Rows are unit vectors.
    Vector low_;
    Vector size_ = Vector::Zero();
    Cell count_{};
    std::map<Cell, Moments> moments_;
};

/// Rows: along the longest rim of a plane piece, across it, and its normal.
Tensor axesAlongRim(TriSurface const& surface, int patch)
{
    Vector along = Vector::Zero();
    for (auto const& edge : surface.edges())
    {
        bool const left = surface.triangles()[static_cast<std::size_t>(edge.left)].patch == patch;
        bool const right = !edge.rim() && surface.triangles()[static_cast<std::size_t>(edge.right)].patch == patch;
        Vector const side = surface.points()[static_cast<std::size_t>(edge.b)] - surface.points()[static_cast<std::size_t>(edge.a)];
        if (left != right && side.norm() > (1 + 1e-9) * along.norm()) along = side;
    }
    Vector normal = Vector::Zero();
    for (auto const& t : surface.triangles())
        if (t.patch == patch) normal += t.area * t.normal;
    Tensor axes;
    axes.row(2) = normal.normalized();
    axes.row(0) = along.squaredNorm() > 0 ? along.normalized() : Vector(normal.unitOrthogonal());
    axes.row(1) = axes.row(2).cross(axes.row(0)).normalized();
    return axes;
}

/// Joins each tile below `least` to the nearest one above it; where none is, all stay.
std::vector<SurfaceTile> joinSmall(std::vector<SurfaceTile> const& tiles, Real least)
{
    std::vector<SurfaceTile> large;
    for (SurfaceTile const& tile : tiles)
        if (tile.area >= least) large.push_back(tile);
    if (large.empty()) return tiles;
    std::vector<SurfaceTile> joined = large;
    for (SurfaceTile const& tile : tiles)
    {
        if (tile.area >= least) continue;
        auto const nearer = [&](SurfaceTile const& a, SurfaceTile const& b) {
            return (a.centre - tile.centre).squaredNorm() < (b.centre - tile.centre).squaredNorm();
        };
        SurfaceTile& home = joined[static_cast<std::size_t>(std::min_element(large.begin(), large.end(), nearer) - large.begin())];
        home.centre = (home.area * home.centre + tile.area * tile.centre) / (home.area + tile.area);
        home.area += tile.area;
    }
    return joined;
}

} // namespace

std::vector<SurfaceTile> cutIntoTiles(TriSurface const& surface, std::vector<int> const& triangles, bool plane, Real spacing)
{
    auto const at = [&](int t) -> TriSurface::Triangle const& { return surface.triangles()[static_cast<std::size_t>(t)]; };
    Tensor const axes = plane ? axesAlongRim(surface, at(triangles.front()).patch) : Tensor(Tensor::Identity());
    auto const polygon = [&](int t) {
        return Polygon{axes * surface.point(at(t), 0), axes * surface.point(at(t), 1), axes * surface.point(at(t), 2)};
    };
    Box box;
    for (int const t : triangles)
        for (Vector const& r : polygon(t)) box.add(r);
    Cells cells(axes, box, spacing);
    for (int const t : triangles) cells.add(polygon(t));
    return joinSmall(cells.tiles(), spacing * spacing / 3);
}

} // namespace mpsDem
