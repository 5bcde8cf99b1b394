#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/Errors.h"
#include "core/Polyline.h"
#include "core/TriSurface.h"

namespace mpsDem {

namespace {

Real cross2(Vector const& a, Vector const& b, Vector const& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Ear clipping of a simple polygon that runs counter-clockwise.
std::vector<TriSurface::Corners> earClipped(std::vector<Vector> const& corners)
{
    std::vector<int> left(corners.size());
    for (std::size_t k = 0; k < left.size(); ++k) left[k] = static_cast<int>(k);
    auto const at = [&](int k) -> Vector const& { return corners[static_cast<std::size_t>(k)]; };
    auto const isEar = [&](int a, int b, int c) {
        if (!(cross2(at(a), at(b), at(c)) > 0)) return false;
        return std::none_of(left.begin(), left.end(), [&](int q) {
            if (q == a || q == b || q == c) return false;
            return cross2(at(a), at(b), at(q)) >= 0 && cross2(at(b), at(c), at(q)) >= 0 && cross2(at(c), at(a), at(q)) >= 0;
        });
    };
    std::vector<TriSurface::Corners> triangles;
    while (left.size() > 3)
    {
        std::size_t const n = left.size();
        std::size_t ear = 0;
        while (ear < n && !isEar(left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n])) ++ear;
        require(ear < n, {}, "a polygon cannot be cut into triangles", "corners in order, no two sides crossing or lying on each other");
        triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

/// Two triangles over the side from corner a to b; rings of `ring` points lie at the low and the high end.
void addStrip(std::vector<TriSurface::Corners>& triangles, int a, int b, int ring)
{
    triangles.push_back({a, b, b + ring});
    triangles.push_back({a, b + ring, a + ring});
}

std::vector<Vector> raised(std::vector<Vector> const& chain, Real low, Real high)
{
    std::vector<Vector> points;
    for (Real const z : {low, high})
        for (Vector const& r : chain) points.emplace_back(r.x(), r.y(), z);
    return points;
}

} // namespace

namespace {

/// Prism over the polygon, or all of it but the side from the last to the first corner.
TriSurface prismOver(std::string name, std::vector<Vector> ring, Real low, Real high, bool lastSide)
{
    require(low < high, {}, "surface \"" + name + "\" from z = " + shortNumber(low) + " to " + shortNumber(high) + " m", "low < high");
    Polyline const outline = Polyline::outline(name, ring); // refuses what is no polygon
    Real twice = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) twice += cross2(ring[0], ring[k], ring[(k + 1) % ring.size()]);
    if (twice < 0) std::reverse(ring.begin(), ring.end()); // the side from the last to the first corner stays that
    int const count = static_cast<int>(ring.size());
    std::vector<TriSurface::Corners> triangles;
    for (TriSurface::Corners const& t : earClipped(ring))
    {
        triangles.push_back({t[0], t[2], t[1]});
        triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    }
    for (int k = 0; k < count - (lastSide ? 0 : 1); ++k) addStrip(triangles, k, (k + 1) % count, count);
    return TriSurface(std::move(name), raised(ring, low, high), triangles);
}

} // namespace

TriSurface TriSurface::prism(std::string name, std::vector<Vector> const& corners, Real low, Real high)
{
    return prismOver(std::move(name), corners, low, high, true);
}

TriSurface TriSurface::channel(std::string name, std::vector<Vector> const& chain, Real low, Real high)
{
    return prismOver(std::move(name), chain, low, high, false).flipped();
}

TriSurface TriSurface::extruded(std::string name, std::vector<Vector> const& chain, bool closed, Real low, Real high, bool left)
{
    require(low < high, {}, "surface \"" + name + "\" from z = " + shortNumber(low) + " to " + shortNumber(high) + " m", "low < high");
    Polyline const line(name, chain, closed, left ? Polyline::FluidSide::Left : Polyline::FluidSide::Right);
    int const count = static_cast<int>(chain.size());
    std::vector<Corners> triangles;
    for (int k = 0; k + (closed ? 0 : 1) < count; ++k) addStrip(triangles, k, (k + 1) % count, count);
    TriSurface const right(std::move(name), raised(chain, low, high), triangles);
    return left ? right.flipped() : right;
}

TriSurface TriSurface::box(std::string name, Vector const& low, Vector const& high, std::array<bool, 6> const& open)
{
    require((low.array() < high.array()).all(), {}, "box \"" + name + "\" whose max is not above its min", "min < max in x, y and z");
    std::vector<Vector> points; // number k has x high where bit 0 is set, y bit 1, z bit 2
    for (int k = 0; k < 8; ++k)
        points.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(), (k & 4) != 0 ? high.z() : low.z());
    static constexpr std::array<std::array<int, 4>, 6> sides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    std::vector<Corners> triangles;
    for (std::size_t k = 0; k < 6; ++k)
    {
        if (open[k]) continue;
        triangles.push_back({sides[k][0], sides[k][1], sides[k][2]});
        triangles.push_back({sides[k][0], sides[k][2], sides[k][3]});
    }
    return TriSurface(std::move(name), std::move(points), triangles);
}

TriSurface TriSurface::cylinder(std::string name, Vector const& end1, Vector const& end2, Real radius, int sides)
{
    Vector const axis = end2 - end1;
    require(axis.norm() > 0 && radius > 0 && sides >= 3, {}, "cylinder \"" + name + "\" has no length, radius or sides",
            "two different ends, a radius above 0 and three or more sides");
    Vector const e3 = axis.normalized();
    Vector const e1 = e3.unitOrthogonal(), e2 = e3.cross(e1);
    std::vector<Vector> points;
    for (Vector const& end : {end1, end2})
        for (int k = 0; k < sides; ++k)
        {
            Real const angle = 2 * std::numbers::pi * k / sides;
            points.push_back(end + radius * (std::cos(angle) * e1 + std::sin(angle) * e2));
        }
    points.push_back(end1);
    points.push_back(end2);
    std::vector<Corners> triangles;
    for (int k = 0; k < sides; ++k)
    {
        int const next = (k + 1) % sides;
        addStrip(triangles, k, next, sides);
        triangles.push_back({2 * sides, next, k});
        triangles.push_back({2 * sides + 1, sides + k, sides + next});
    }
    return TriSurface(std::move(name), std::move(points), triangles);
}

TriSurface TriSurface::sphere(std::string name, Vector const& centre, Real radius, Real edge)
{
    require(radius > 0 && edge > 0, {}, "sphere \"" + name + "\" has no radius", "a radius above 0");
    Real const g = std::numbers::phi;
    std::vector<Vector> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                               {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<Corners> triangles{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (Vector& r : points) r.normalize();
    for (Real length = 1.06 * radius; length > edge && triangles.size() < 300000; length /= 2)
    {
        std::map<std::pair<int, int>, int> middle;
        auto const between = [&](int a, int b) {
            auto const [place, isNew] = middle.emplace(std::minmax(a, b), static_cast<int>(points.size()));
            if (isNew) points.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]).normalized());
            return place->second;
        };
        std::vector<Corners> finer;
        for (Corners const& t : triangles)
        {
            int const ab = between(t[0], t[1]), bc = between(t[1], t[2]), ca = between(t[2], t[0]);
            finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    for (Vector& r : points) r = centre + radius * r;
    return TriSurface(std::move(name), std::move(points), triangles);
}

} // namespace mpsDem
