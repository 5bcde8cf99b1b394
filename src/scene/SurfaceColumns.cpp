#include "scene/SurfaceColumns.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Axes across a direction; for z those of space, so that nothing is rounded there.
Tensor axesAlong(Vector const& direction)
{
    Tensor axes;
    Eigen::Index longest;
    direction.cwiseAbs().maxCoeff(&longest);
    Vector const x = Vector::Unit((longest + 1) % 3);
    Vector const across = (x - x.dot(direction) * direction).normalized();
    axes.row(0) = across;
    axes.row(1) = direction.cross(across);
    axes.row(2) = direction;
    return axes;
}

} // namespace

SurfaceColumns::SurfaceColumns(TriSurface const& surface, Vector const& direction) : direction_(direction), toLocal_(axesAlong(direction))
{
    points_.reserve(surface.points().size());
    for (Vector const& r : surface.points()) points_.push_back(toLocal_ * r);
    for (TriSurface::Triangle const& t : surface.triangles()) triangles_.push_back(t.corner);
    sortTriangles();
}

void SurfaceColumns::sortTriangles()
{
    low_ = high_ = points_[at(triangles_.front()[0])];
    Real sum = 0;
    struct Box
    {
        Vector low, high;
    };
    Field<Box> boxes;
    for (TriSurface::Corners const& c : triangles_)
    {
        Vector const &p = points_[at(c[0])], &q = points_[at(c[1])], &r = points_[at(c[2])];
        boxes.push_back({p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)});
        low_ = low_.cwiseMin(boxes.back().low);
        high_ = high_.cwiseMax(boxes.back().high);
        sum += std::max(boxes.back().high.x() - boxes.back().low.x(), boxes.back().high.y() - boxes.back().low.y());
    }
    Vector const extent = high_ - low_;
    auto const count = static_cast<Real>(triangles_.size());
    cell_ = std::max({sum / count, std::sqrt(extent.x() * extent.y() / count), 1e-4 * extent.maxCoeff(), tiny});
    countX_ = static_cast<int>(extent.x() / cell_) + 1;
    countY_ = static_cast<int>(extent.y() / cell_) + 1;
    auto const forCells = [&](Box const& box, auto visit) {
        auto const number = [&](Real x, int most) { return std::clamp(static_cast<int>(x / cell_), 0, most - 1); };
        for (int j = number(box.low.y() - low_.y(), countY_); j <= number(box.high.y() - low_.y(), countY_); ++j)
            for (int i = number(box.low.x() - low_.x(), countX_); i <= number(box.high.x() - low_.x(), countX_); ++i)
                visit(at(j) * at(countX_) + at(i));
    };
    first_.assign(at(countX_) * at(countY_) + 1, 0);
    for (Box const& box : boxes) forCells(box, [&](std::size_t cell) { ++first_[cell + 1]; });
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    items_.resize(at(first_.back()));
    Field<int> next = first_;
    for (std::size_t t = 0; t < boxes.size(); ++t)
    {
        auto const& [low, high] = boxes[t];
        Item const item{low.x(), high.x(), low.y(), high.y(), high.z(), static_cast<int>(t)};
        forCells(boxes[t], [&](std::size_t cell) { items_[at(next[cell]++)] = item; });
    }
}

/// How often the projected triangle winds around a point: 1 counter-clockwise, -1 clockwise, 0 not. Each edge is looked at from its lower
/// end, so that both of its triangles see the point on the same side.
int SurfaceColumns::winding(TriSurface::Corners const& corners, Vector const& local) const
{
    int sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        Vector const &a = points_[at(corners[k])], &b = points_[at(corners[(k + 1) % 3])];
        bool const rises = a.y() <= local.y();
        if (rises == (b.y() <= local.y())) continue;
        Vector const &lower = rises ? a : b, &upper = rises ? b : a;
        Real const x = lower.x() + (local.y() - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x());
        auto const [left, right] = std::minmax(a.x(), b.x());
        if (local.x() < std::clamp(x, left, right)) sum += rises ? 1 : -1;
    }
    return sum;
}

Real SurfaceColumns::heightAt(TriSurface::Corners const& corners, Vector const& local) const
{
    Vector const &a = points_[at(corners[0])], &b = points_[at(corners[1])], &c = points_[at(corners[2])];
    Vector const ab = b - a, ac = c - a, ar = local - a;
    Real const twice = ab.x() * ac.y() - ab.y() * ac.x();
    Real const s = (ar.x() * ac.y() - ar.y() * ac.x()) / twice, t = (ab.x() * ar.y() - ab.y() * ar.x()) / twice;
    Real const height = a.z() + s * ab.z() + t * ac.z();
    Real const low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
    return height >= low ? std::min(height, high) : low; // also where a triangle on edge gives no number
}

template <class Visit>
void SurfaceColumns::forEachCrossingAbove(Vector const& local, Visit visit) const
{
    if ((local.array() < low_.array()).any() || (local.array() > high_.array()).any()) return;
    int const i = std::min(static_cast<int>((local.x() - low_.x()) / cell_), countX_ - 1);
    int const j = std::min(static_cast<int>((local.y() - low_.y()) / cell_), countY_ - 1);
    std::size_t const cell = at(j) * at(countX_) + at(i);
    for (int k = first_[cell]; k < first_[cell + 1]; ++k)
    {
        Item const& item = items_[at(k)];
        if (local.x() < item.lowX || local.x() > item.highX || local.y() < item.lowY || local.y() > item.highY || local.z() >= item.highZ)
            continue;
        TriSurface::Corners const& corners = triangles_[at(item.triangle)];
        int const turns = winding(corners, local);
        if (turns == 0) continue;
        Real const height = heightAt(corners, local);
        if (height > local.z()) visit(height, turns);
    }
}

bool SurfaceColumns::inside(Vector const& r) const
{
    int sum = 0;
    forEachCrossingAbove(toLocal_ * r, [&](Real, int turns) { sum += turns; });
    return sum > 0;
}

Real SurfaceColumns::exitDistance(Vector const& r) const
{
    Vector const local = toLocal_ * r;
    std::vector<std::pair<Real, int>> crossings;
    int left = 0;
    forEachCrossingAbove(local, [&](Real height, int turns) {
        crossings.emplace_back(height, turns);
        left += turns;
    });
    if (left <= 0) return 0;
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k < crossings.size(); ++k)
    {
        left -= crossings[k].second;
        bool const touches = k + 1 < crossings.size() && crossings[k + 1].first == crossings[k].first;
        if (left <= 0 && !touches) return crossings[k].first - local.z();
    }
    return 0;
}

} // namespace mpsDem
