#include "boundaries/PlanePatches.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mpsDem {

namespace {

constexpr Real planeTolerance = 1e-3; ///< Points of a patch lie this near to its plane, in spacings.
constexpr Real leastWidth = 2.5;      ///< Area over perimeter from which on a patch with soft borders has lines, in spacings.
constexpr Real leastSharpWidth = 0.8; ///< The same for one with sharp borders.
constexpr Real leastStripWidth = 0.2; ///< The same for a rectangle: the rim of a plate one spacing thick has 0.5.
constexpr Real shortSide = 2.0;       ///< Sharp borders of shorter pieces than this are a curve, in spacings.

Real const sharpCosine = std::cos(20.0 * std::numbers::pi / 180);
Real const planeCosine = std::cos(0.5 * std::numbers::pi / 180);

using Point2 = Eigen::Vector2d;

/// Side of the outline of a patch, the patch on its left.
struct Side
{
    Point2 a, b;
    bool rim;
};

/// Lines of particles in a polygon.
class LineLayout
{
public:
    LineLayout(std::vector<Side> sides, Real spacing, int beyond) : sides_(std::move(sides)), spacing_(spacing), beyond_(beyond)
    {
        Real low = sides_.front().a.y(), high = low;
        for (Side const& s : sides_)
        {
            low = std::min({low, s.a.y(), s.b.y()});
            high = std::max({high, s.a.y(), s.b.y()});
        }
        std::vector<Real> levels{low};
        for (Real const level : longLevels())
            if (level > levels.back() + 0.5 * spacing && level < high - 0.5 * spacing) levels.push_back(level);
        levels.push_back(high);
        for (std::size_t i = 0; i + 1 < levels.size(); ++i) layBand(levels[i], levels[i + 1]);
    }

    struct Spot
    {
        Point2 point;
        int beyond;
    };
    std::vector<Spot> spots;

private:
    /// Heights of sides along the lines: bands of lines begin there.
    [[nodiscard]] std::vector<Real> longLevels() const
    {
        std::vector<Real> levels;
        for (Side const& s : sides_)
            if (std::abs(s.b.y() - s.a.y()) < 1e-3 * spacing_ && std::abs(s.b.x() - s.a.x()) > spacing_) levels.push_back(s.a.y());
        std::sort(levels.begin(), levels.end());
        return levels;
    }

    /// Particles past a border: one more past a rim.
    [[nodiscard]] int pastBorder(bool rim) const { return beyond_ + (rim ? 1 : 0); }

    /// Whether there is a rim at this height.
    [[nodiscard]] bool rimAt(Real y) const
    {
        return std::any_of(sides_.begin(), sides_.end(),
                           [&](Side const& s) { return s.rim && std::max(std::abs(s.a.y() - y), std::abs(s.b.y() - y)) < 0.5 * spacing_; });
    }

    /// Where a line enters or leaves the polygon.
    struct Cut
    {
        Real x;
        bool rim;
    };

    [[nodiscard]] std::vector<Cut> cutsAt(Real y) const
    {
        std::vector<Cut> cuts;
        for (Side const& s : sides_)
            if ((s.a.y() <= y) != (s.b.y() <= y))
                cuts.push_back({s.a.x() + (y - s.a.y()) / (s.b.y() - s.a.y()) * (s.b.x() - s.a.x()), s.rim});
        std::stable_sort(cuts.begin(), cuts.end(), [](Cut const& c, Cut const& d) { return c.x < d.x; });
        return cuts;
    }

    void layBand(Real low, Real high)
    {
        int const lines = std::max(1, static_cast<int>(std::lround((high - low) / spacing_)));
        Real const step = (high - low) / lines;
        Real const safeStep = std::clamp(step, 0.7 * spacing_, 1.4 * spacing_);
        for (int j = 0; j < lines; ++j) layLine(low + (j + 0.5) * step, low + (j + 0.5) * step, 0);
        for (int j = 0; j < pastBorder(rimAt(low)); ++j) layLine(low + 0.5 * step, low - (j + 0.5) * safeStep, j + 1);
        for (int j = 0; j < pastBorder(rimAt(high)); ++j) layLine(high - 0.5 * step, high + (j + 0.5) * safeStep, j + 1);
    }

    /// The particles of the line at height `from`, put at height y.
    void layLine(Real from, Real y, int beyond)
    {
        std::vector<Cut> const cuts = cutsAt(from);
        for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
        {
            Cut const &begin = cuts[i], &end = cuts[i + 1];
            if (end.x - begin.x < 0.5 * spacing_) continue;
            int const parts = std::max(1, static_cast<int>(std::lround((end.x - begin.x) / spacing_)));
            Real const step = (end.x - begin.x) / parts;
            Real const safeStep = std::clamp(step, 0.7 * spacing_, 1.4 * spacing_);
            for (int m = 0; m < parts; ++m) spots.push_back({{begin.x + (m + 0.5) * step, y}, beyond});
            for (int m = 0; m < pastBorder(begin.rim); ++m) spots.push_back({{begin.x - (m + 0.5) * safeStep, y}, std::max(beyond, m + 1)});
            for (int m = 0; m < pastBorder(end.rim); ++m) spots.push_back({{end.x + (m + 0.5) * safeStep, y}, std::max(beyond, m + 1)});
        }
    }

    std::vector<Side> sides_;
    Real spacing_;
    int beyond_;
};

/// Direction along which the sides of an outline are longest together.
Vector longestDirection(std::vector<Vector> const& sides, Vector const& normal)
{
    Vector const e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
    struct Item
    {
        Real angle, length;
    };
    std::vector<Item> items;
    for (Vector const& s : sides)
    {
        Real angle = std::atan2(s.dot(e2), s.dot(e1));
        if (angle < 0) angle += std::numbers::pi;
        if (angle > std::numbers::pi - 1e-6) angle -= std::numbers::pi;
        items.push_back({angle, s.norm()});
    }
    std::stable_sort(items.begin(), items.end(), [](Item const& s, Item const& t) { return s.angle < t.angle; });
    Real best = 0, bestAngle = 0;
    for (std::size_t i = 0; i < items.size();)
    {
        Real length = 0, weighted = 0;
        std::size_t end = i;
        for (; end < items.size() && items[end].angle < items[i].angle + 1e-3; ++end)
        {
            length += items[end].length;
            weighted += items[end].length * (items[end].angle - items[i].angle);
        }
        if (length > best * (1 + 1e-9))
        {
            best = length;
            bestAngle = items[i].angle + weighted / length;
        }
        i = end;
    }
    return std::cos(bestAngle) * e1 + std::sin(bestAngle) * e2;
}

/// Finds the patches, largest triangles first.
class PatchFinder
{
public:
    PatchFinder(JoinedSurfaces const& surfaces, Real spacing) : surfaces_(surfaces), spacing_(spacing), patch_(surfaces.faces().size(), -1)
    {
        std::vector<Real> area;
        for (auto const& f : surfaces.faces())
        {
            Vector const a = surfaces.point(f, 0);
            area.push_back((surfaces.point(f, 1) - a).cross(surfaces.point(f, 2) - a).norm() / 2);
        }
        std::vector<int> order(area.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return area[static_cast<std::size_t>(a)] > area[static_cast<std::size_t>(b)]; });
        for (int const seed : order)
            if (patch_[static_cast<std::size_t>(seed)] < 0) grow(seed, area);
    }

    /// Faces of each patch with its area.
    struct Piece
    {
        std::vector<int> faces;
        Real area = 0;
    };
    std::vector<Piece> pieces;

    [[nodiscard]] int patchOf(int face) const { return patch_[static_cast<std::size_t>(face)]; }

private:
    void grow(int seed, std::vector<Real> const& area)
    {
        int const number = static_cast<int>(pieces.size());
        pieces.emplace_back();
        Piece& piece = pieces.back();
        auto const& first = surfaces_.face(seed);
        Vector const origin = surfaces_.point(first, 0);
        patch_[static_cast<std::size_t>(seed)] = number;
        piece.faces.push_back(seed);
        for (std::size_t i = 0; i < piece.faces.size(); ++i)
        {
            int const self = piece.faces[i];
            piece.area += area[static_cast<std::size_t>(self)];
            for (int const e : surfaces_.face(self).edge)
            {
                auto const& edge = surfaces_.edge(e);
                int const other = edge.left == self ? edge.right : edge.left;
                if (other < 0 || patchOf(other) >= 0) continue;
                auto const& face = surfaces_.face(other);
                if (face.surface != first.surface || face.normal.dot(first.normal) < planeCosine) continue;
                bool near = true;
                for (int k = 0; k < 3; ++k)
                    near = near && std::abs((surfaces_.point(face, k) - origin).dot(first.normal)) < planeTolerance * spacing_;
                if (!near) continue;
                patch_[static_cast<std::size_t>(other)] = number;
                piece.faces.push_back(other);
            }
        }
    }

    JoinedSurfaces const& surfaces_;
    Real spacing_;
    std::vector<int> patch_;
};

/// Outline of a piece: edges with one face in it, the piece on their left.
struct Outline
{
    struct Side3
    {
        Vector a, b;
        bool rim;
    };
    std::vector<Side3> sides;
    Real length = 0;
    Real shortSharp = 0; ///< Length of sharp edges between faces that are short.
    bool soft = false;   ///< Somewhere the surface goes on without a sharp edge.
};

Outline outlineOf(JoinedSurfaces const& surfaces, PatchFinder const& finder, int number, Real spacing)
{
    Outline outline;
    for (int const f : finder.pieces[static_cast<std::size_t>(number)].faces)
        for (std::size_t k = 0; k < 3; ++k)
        {
            auto const& face = surfaces.face(f);
            auto const& edge = surfaces.edge(face.edge[k]);
            int const other = edge.left == f ? edge.right : edge.left;
            if (other >= 0 && finder.patchOf(other) == number) continue;
            Vector const a = surfaces.corner(face.corner[k]).point, b = surfaces.corner(face.corner[(k + 1) % 3]).point;
            Real const length = (b - a).norm();
            outline.sides.push_back({a, b, other < 0});
            outline.length += length;
            if (other >= 0 && !isSharp(surfaces, edge)) outline.soft = true;
            if (other >= 0 && isSharp(surfaces, edge) && length < shortSide * spacing) outline.shortSharp += length;
        }
    return outline;
}

/// An outline in the plane, the first axis along its longest sides.
struct Frame
{
    Vector origin, e1, e2;
    std::vector<Side> sides;

    /// Of the rectangle around it [m2].
    [[nodiscard]] Real area() const
    {
        Point2 low = sides.front().a, high = low;
        for (Side const& s : sides)
        {
            low = low.cwiseMin(s.a);
            high = high.cwiseMax(s.a);
        }
        return (high - low).prod();
    }
};

Frame frameOf(Outline const& outline, Vector const& origin, Vector const& normal)
{
    std::vector<Vector> directions;
    for (auto const& s : outline.sides) directions.push_back(s.b - s.a);
    Vector const e1 = longestDirection(directions, normal);
    Frame frame{origin, e1, normal.cross(e1), {}};
    auto const inPlane = [&](Vector const& r) { return Point2((r - origin).dot(frame.e1), (r - origin).dot(frame.e2)); };
    for (auto const& s : outline.sides) frame.sides.push_back({inPlane(s.a), inPlane(s.b), s.rim});
    return frame;
}

} // namespace

bool isSharp(JoinedSurfaces const& surfaces, JoinedSurfaces::Edge const& edge)
{
    return !edge.rim() && surfaces.face(edge.left).normal.dot(surfaces.face(edge.right).normal) < sharpCosine;
}

PlanePatches planePatches(JoinedSurfaces const& surfaces, Real spacing, std::vector<int> const& beyond)
{
    PlanePatches result{{}, std::vector<char>(surfaces.faces().size(), 0)};
    PatchFinder const finder(surfaces, spacing);
    for (std::size_t p = 0; p < finder.pieces.size(); ++p)
    {
        auto const& piece = finder.pieces[p];
        if (piece.area < 0.2 * spacing * spacing) continue;
        Outline const outline = outlineOf(surfaces, finder, static_cast<int>(p), spacing);
        if (outline.sides.size() > 8 && outline.shortSharp > 0.3 * outline.length) continue;
        auto const& first = surfaces.face(piece.faces.front());
        Frame const frame = frameOf(outline, surfaces.point(first, 0), first.normal);
        Real const least = outline.soft ? leastWidth : piece.area > 0.95 * frame.area() ? leastStripWidth : leastSharpWidth;
        if (piece.area < least * outline.length * spacing) continue;
        LineLayout const layout(frame.sides, spacing, beyond[static_cast<std::size_t>(first.surface)]);
        PlanePatch patch{piece.faces.front(), first.normal, {}};
        for (auto const& spot : layout.spots)
            patch.feet.push_back({frame.origin + spot.point.x() * frame.e1 + spot.point.y() * frame.e2, spot.beyond});
        if (std::none_of(patch.feet.begin(), patch.feet.end(), [](auto const& foot) { return foot.beyond == 0; })) continue;
        for (int const f : piece.faces) result.covers[static_cast<std::size_t>(f)] = 1;
        result.patches.push_back(std::move(patch));
    }
    return result;
}

} // namespace mpsDem
