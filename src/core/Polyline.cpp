#include "core/Polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Errors.h"

namespace mpsDem {

namespace {

Real cross2(Vector const& a, Vector const& b) { return a.x() * b.y() - a.y() * b.x(); }

Real signedArea(std::vector<Vector> const& points)
{
    Real twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) twice += cross2(points[i], points[(i + 1) % points.size()]);
    return 0.5 * twice;
}

bool properlyCross(Polyline::Segment const& s, Polyline::Segment const& t)
{
    auto const side = [](Polyline::Segment const& l, Vector const& q) { return cross2(l.b - l.a, q - l.a); };
    return side(s, t.a) * side(s, t.b) < 0 && side(t, s.a) * side(t, s.b) < 0;
}

} // namespace

Polyline::Polyline(std::string name, std::vector<Vector> points, bool closed, FluidSide side)
    : name_(std::move(name)),
      points_(std::move(points)),
      closed_(closed)
{
    for (Vector& q : points_) q.z() = 0;
    require(points_.size() >= (closed ? 3u : 2u), {}, "polyline \"" + name_ + "\" has " + std::to_string(points_.size()) + " points",
            closed ? "a closed one needs three or more" : "it needs two or more");
    buildSegments(side);
}

Polyline Polyline::outline(std::string name, std::vector<Vector> points)
{
    bool const counterClockwise = signedArea(points) > 0;
    return Polyline(std::move(name), std::move(points), true, counterClockwise ? FluidSide::Right : FluidSide::Left);
}

void Polyline::buildSegments(FluidSide side)
{
    Real const turn = side == FluidSide::Left ? 1 : -1;
    std::size_t const count = closed_ ? points_.size() : points_.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
    {
        Vector const a = points_[i];
        Vector const b = points_[(i + 1) % points_.size()];
        Real const length = (b - a).norm();
        require(length > 0, {}, "polyline \"" + name_ + "\": points " + std::to_string(i) + " and " + std::to_string(i + 1) + " coincide",
                "leave one of them out");
        Vector const tangent = (b - a) / length;
        Vector const normal = turn * Vector(-tangent.y(), tangent.x(), 0);
        bool const straightOn = i > 0 && segments_.back().tangent.dot(tangent) > 1 - 1e-9;
        int const patch = i == 0 ? 0 : segments_.back().patch + (straightOn ? 0 : 1);
        segments_.push_back({a, b, tangent, normal, length, patch});
    }
    if (!closed_) return;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j)
            require(!properlyCross(segments_[i], segments_[j]), {}, "closed polyline \"" + name_ + "\" crosses itself",
                    "segments " + std::to_string(i) + " and " + std::to_string(j) + " intersect");
}

Polyline::Closest Polyline::closest(Vector const& r) const
{
    Closest best{Vector::Zero(), 0, -1, false};
    Real bestDistance = std::numeric_limits<Real>::infinity();
    Real bestAlong = 0;
    for (std::size_t i = 0; i < segments_.size(); ++i)
    {
        Segment const& s = segments_[i];
        Real const along = (r - s.a).dot(s.tangent);
        Real const clamped = std::clamp(along, Real(0), s.length);
        Vector const point = s.a + clamped * s.tangent;
        Real const distance = (r - point).norm();
        Real const off = (r - point).dot(s.normal);
        // At a shared corner the segment that r faces more squarely decides on the sign.
        bool const nearer = best.segment < 0 || distance < bestDistance - 1e-12 * (1 + bestDistance);
        bool const squarer = !nearer && distance < bestDistance + 1e-12 * (1 + bestDistance) && std::abs(off) > bestAlong;
        if (!nearer && !squarer) continue;
        bestDistance = distance;
        bestAlong = std::abs(off);
        best = {point, off >= 0 ? distance : -distance, static_cast<int>(i), along <= 0 || along >= s.length};
    }
    return best;
}

bool Polyline::encloses(Vector const& r) const
{
    bool within = false;
    for (Segment const& s : segments_)
    {
        bool const spans = (s.a.y() > r.y()) != (s.b.y() > r.y());
        if (spans && r.x() < s.a.x() + (r.y() - s.a.y()) / (s.b.y() - s.a.y()) * (s.b.x() - s.a.x())) within = !within;
    }
    return within;
}

Real Polyline::area() const { return std::abs(signedArea(points_)); }

Polyline Polyline::moved(Tensor const& rotation, Vector const& centre) const
{
    Polyline copy = *this;
    for (Vector& q : copy.points_) q = centre + rotation * q;
    for (Segment& s : copy.segments_)
    {
        s.a = centre + rotation * s.a;
        s.b = centre + rotation * s.b;
        s.tangent = rotation * s.tangent;
        s.normal = rotation * s.normal;
    }
    return copy;
}

} // namespace mpsDem
