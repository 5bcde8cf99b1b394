#include "boundaries/JoinedSurfaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace mpsDem {

namespace {

/// Numbers of the points: those within `tolerance` of an earlier one get its number. Sorted by cells, so that the result is one order's.
class PointWeld
{
public:
    PointWeld(std::vector<Vector> const& points, Vector const& origin, Real tolerance)
        : points_(points),
          origin_(origin),
          tolerance_(tolerance)
    {
        keys_.reserve(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) keys_.push_back({cell(points[i]), static_cast<int>(i)});
        std::sort(keys_.begin(), keys_.end());
    }

    [[nodiscard]] std::vector<int> numbers() const
    {
        std::vector<int> number(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i)
        {
            int const first = firstNear(static_cast<int>(i));
            number[i] = first == static_cast<int>(i) ? first : number[static_cast<std::size_t>(first)];
        }
        return number;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    /// Cells are much larger than the tolerance: seldom does a point look into more than its own.
    [[nodiscard]] Cell cell(Vector const& r) const
    {
        Cell c{};
        for (int d = 0; d < 3; ++d)
            c[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(std::floor((r[d] - origin_[d]) / (64 * tolerance_)));
        return c;
    }

    [[nodiscard]] int firstNear(int self) const
    {
        Vector const& r = points_[static_cast<std::size_t>(self)];
        Cell const low = cell(r - Vector::Constant(tolerance_)), high = cell(r + Vector::Constant(tolerance_));
        int first = self;
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t z = low[2]; z <= high[2]; ++z)
                    for (auto key = std::lower_bound(keys_.begin(), keys_.end(), Key{{x, y, z}, 0});
                         key != keys_.end() && key->first == Cell{x, y, z} && key->second < first; ++key)
                        if ((points_[static_cast<std::size_t>(key->second)] - r).norm() <= tolerance_) first = key->second;
        return first;
    }

    using Key = std::pair<Cell, int>;
    std::vector<Vector> const& points_;
    Vector origin_;
    Real tolerance_;
    std::vector<Key> keys_;
};

/// Side k of a face, its corners in rising order.
struct Side
{
    int low, high, face, k;
    bool forwards;
};

int rootOf(std::vector<int>& parent, int i)
{
    auto const at = [&](int k) -> int& { return parent[static_cast<std::size_t>(k)]; };
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
}

} // namespace

JoinedSurfaces::JoinedSurfaces(std::span<TriSurface const> surfaces)
{
    if (surfaces.empty()) return;
    gather(surfaces);
    joinEdges();
    numberComponents();
    splitCorners();
    sumNormals();
}

void JoinedSurfaces::gather(std::span<TriSurface const> surfaces)
{
    std::vector<Vector> points;
    for (TriSurface const& surface : surfaces) points.insert(points.end(), surface.points().begin(), surface.points().end());
    Vector low = points.front(), high = low;
    for (Vector const& r : points)
    {
        low = low.cwiseMin(r);
        high = high.cwiseMax(r);
    }
    extent_ = (high - low).maxCoeff();
    std::vector<int> const number = PointWeld(points, low, tolerance()).numbers();
    int offset = 0;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
    {
        for (std::size_t t = 0; t < surfaces[s].triangles().size(); ++t)
        {
            TriSurface::Triangle const& triangle = surfaces[s].triangles()[t];
            Face face{{}, {-1, -1, -1}, triangle.normal, static_cast<int>(s), static_cast<int>(t), 0};
            for (std::size_t k = 0; k < 3; ++k) face.corner[k] = number[static_cast<std::size_t>(offset + triangle.corner[k])];
            faces_.push_back(face);
        }
        offset += static_cast<int>(surfaces[s].points().size());
    }
    corners_.reserve(points.size());
    for (Vector const& r : points) corners_.push_back({r});
}

void JoinedSurfaces::joinEdges()
{
    std::vector<Side> sides;
    sides.reserve(3 * faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
        for (int k = 0; k < 3; ++k)
        {
            int const a = faces_[f].corner[static_cast<std::size_t>(k)], b = faces_[f].corner[static_cast<std::size_t>((k + 1) % 3)];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), k, a < b});
        }
    std::sort(sides.begin(), sides.end(),
              [](Side const& s, Side const& t) { return std::tie(s.low, s.high, s.face, s.k) < std::tie(t.low, t.high, t.face, t.k); });
    for (std::size_t i = 0; i < sides.size();)
    {
        std::size_t end = i;
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
        // Sides of one surface find each other first, then those of different ones.
        std::vector<bool> taken(end - i, false);
        auto const add = [&](Side const& s, Side const* t) {
            int const number = static_cast<int>(edges_.size());
            Vector normal = faces_[static_cast<std::size_t>(s.face)].normal;
            faces_[static_cast<std::size_t>(s.face)].edge[static_cast<std::size_t>(s.k)] = number;
            if (t)
            {
                normal += faces_[static_cast<std::size_t>(t->face)].normal;
                faces_[static_cast<std::size_t>(t->face)].edge[static_cast<std::size_t>(t->k)] = number;
            }
            edges_.push_back({{s.forwards ? s.low : s.high, s.forwards ? s.high : s.low}, s.face, t ? t->face : -1, normal});
        };
        for (bool const sameSurface : {true, false})
            for (std::size_t m = i; m < end; ++m)
                for (std::size_t n = m + 1; n < end && !taken[m - i]; ++n)
                {
                    if (taken[n - i] || sides[m].forwards == sides[n].forwards) continue;
                    if (sameSurface && face(sides[m].face).surface != face(sides[n].face).surface) continue;
                    taken[m - i] = taken[n - i] = true;
                    add(sides[m], &sides[n]);
                }
        for (std::size_t m = i; m < end; ++m)
            if (!taken[m - i]) add(sides[m], nullptr);
        i = end;
    }
}

void JoinedSurfaces::numberComponents()
{
    std::vector<int> parent(faces_.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (Edge const& edge : edges_)
    {
        if (edge.rim()) continue;
        int const a = rootOf(parent, edge.left), b = rootOf(parent, edge.right);
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<int> number(faces_.size(), -1);
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
        int& own = number[static_cast<std::size_t>(rootOf(parent, static_cast<int>(f)))];
        if (own < 0) own = components_++;
        faces_[f].component = own;
    }
}

void JoinedSurfaces::splitCorners()
{
    using Key = std::array<int, 4>; // point, component, face, k
    std::vector<Key> keys;
    keys.reserve(3 * faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
        for (int k = 0; k < 3; ++k)
            keys.push_back({faces_[f].corner[static_cast<std::size_t>(k)], faces_[f].component, static_cast<int>(f), k});
    std::sort(keys.begin(), keys.end());
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
        bool const isNew = i == 0 || keys[i][0] != keys[i - 1][0] || keys[i][1] != keys[i - 1][1];
        if (isNew) corners.push_back({corner(keys[i][0]).point});
        faces_[static_cast<std::size_t>(keys[i][2])].corner[static_cast<std::size_t>(keys[i][3])] = static_cast<int>(corners.size()) - 1;
    }
    corners_ = std::move(corners);
    for (std::size_t f = 0; f < faces_.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
        {
            Edge& e = edges_[static_cast<std::size_t>(faces_[f].edge[k])];
            if (e.left == static_cast<int>(f)) e.corner = {faces_[f].corner[k], faces_[f].corner[(k + 1) % 3]};
        }
}

void JoinedSurfaces::sumNormals()
{
    for (Face const& f : faces_)
        for (int k = 0; k < 3; ++k)
        {
            Vector const u = point(f, (k + 1) % 3) - point(f, k), v = point(f, (k + 2) % 3) - point(f, k);
            corners_[static_cast<std::size_t>(f.corner[static_cast<std::size_t>(k)])].normal +=
                std::atan2(u.cross(v).norm(), u.dot(v)) * f.normal;
        }
    for (Edge const& e : edges_)
        if (e.rim())
            for (int const c : e.corner) corners_[static_cast<std::size_t>(c)].rim = true;
}

} // namespace mpsDem
