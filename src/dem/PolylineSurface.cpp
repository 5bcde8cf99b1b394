#include "dem/PolylineSurface.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

PolylineSurface::PolylineSurface(Polyline const& line, Real depth, std::vector<Polyline> const& others)
    : facets_(facetsOf(line)),
      grid_(facets_, 2 * depth),
      depth_(depth)
{
    for (Polyline const& other : others)
        if (other.name() != line.name()) joinEnds(facets_, facetsOf(other), 1e-3 * depth);
}

void PolylineSurface::addSide(int index, Sphere const& sphere, Real limit, std::vector<Candidate>& candidates) const
{
    Facet const& side = facets_[static_cast<std::size_t>(index)];
    Vector const arm = sphere.centre - side.a;
    Real const height = arm.dot(side.normal);
    if (height < -depth_ || height > limit) return;
    Real const along = arm.dot(side.tangent);
    auto const extension = [&](Facet::Joint joint) {
        if (joint == Facet::Joint::Concave && height < 0) return depth_;
        return joint == Facet::Joint::Flat ? 1e-9 * side.length : Real(0);
    };
    if (along < -extension(side.jointA) || along > side.length + extension(side.jointB)) return;
    candidates.push_back({{0, side.patch, side.normal, height - sphere.radius, 0}, height, index, false, Vector::Zero()});
}

void PolylineSurface::addCorners(int index, Sphere const& sphere, Real limit, std::vector<Candidate>& candidates) const
{
    auto const add = [&](Vector const& corner, int key) {
        Vector const arm = sphere.centre - corner;
        Real const distance = arm.norm();
        if (distance > limit || distance <= 0) return;
        candidates.push_back({{0, key, arm / distance, distance - sphere.radius, 0}, distance, index, true, corner});
    };
    Facet const& side = facets_[static_cast<std::size_t>(index)];
    int const keys = facets_.back().patch + 1;
    Vector const fromA = sphere.centre - side.a;
    Vector const fromB = sphere.centre - side.b;
    if (side.jointA == Facet::Joint::Free && fromA.dot(side.tangent) < 0 && fromA.dot(side.normal) > 0) add(side.a, keys + index);
    if (fromB.dot(side.tangent) <= 0) return;
    bool const freeEnd = side.jointB == Facet::Joint::Free && fromB.dot(side.normal) > 0;
    Facet const& next = facets_[(static_cast<std::size_t>(index) + 1) % facets_.size()];
    bool const ridge = side.jointB == Facet::Joint::Convex && fromB.dot(next.tangent) < 0;
    if (freeEnd || ridge) add(side.b, keys + index + 1);
}

bool PolylineSurface::valleyBetween(int first, int second) const
{
    int const count = static_cast<int>(facets_.size());
    Facet const& side = facets_[static_cast<std::size_t>(first)];
    bool const after = second == (first + 1) % count && side.jointB == Facet::Joint::Concave;
    bool const before = first == (second + 1) % count && side.jointA == Facet::Joint::Concave;
    return after || before;
}

void PolylineSurface::dropHidden(std::vector<Candidate>& candidates, Real reach) const
{
    auto const nearer = [](Candidate const& a, Candidate const& b) { return std::abs(a.height) < std::abs(b.height); };
    Candidate const nearest = *std::min_element(candidates.begin(), candidates.end(), nearer);
    auto const hidden = [&](Candidate const& c) {
        if (c.feature.gap >= reach) return true;
        if (c.height >= 0 || c.facet == nearest.facet) return false;
        return nearest.height >= 0 || !valleyBetween(nearest.facet, c.facet);
    };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), hidden), candidates.end());
}

void PolylineSurface::keepDistinct(std::vector<Candidate>& candidates) const
{
    std::sort(candidates.begin(), candidates.end(), [](Candidate const& a, Candidate const& b) {
        return a.corner != b.corner ? b.corner : (a.feature.gap != b.feature.gap ? a.feature.gap < b.feature.gap : a.facet < b.facet);
    });
    auto const onSide = [&](Vector const& point, Candidate const& other) {
        Facet const& side = facets_[static_cast<std::size_t>(other.facet)];
        Real const along = (point - side.a).dot(side.tangent);
        return !other.corner && (point - side.a - std::clamp(along, Real(0), side.length) * side.tangent).norm() < 1e-9 * depth_;
    };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
        Candidate const candidate = candidates[i];
        auto const covers = [&](Candidate const& other) {
            return other.feature.normal.dot(candidate.feature.normal) > sameDirection ||
                   (candidate.corner && onSide(candidate.nearest, other));
        };
        if (std::any_of(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(kept), covers)) continue;
        candidates[kept++] = candidate;
    }
    candidates.resize(kept, candidates.front());
    std::sort(candidates.begin(), candidates.end(),
              [](Candidate const& a, Candidate const& b) { return a.feature.patch < b.feature.patch; });
}

void PolylineSurface::collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const
{
    thread_local std::vector<int> sides;
    thread_local std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        Sphere const& sphere = spheres[i];
        Real const limit = std::max(depth_, sphere.radius + reach);
        grid_.near(sphere.centre, limit, sides);
        candidates.clear();
        for (int const side : sides)
        {
            addSide(side, sphere, limit, candidates);
            addCorners(side, sphere, limit, candidates);
        }
        if (candidates.empty()) continue;
        dropHidden(candidates, reach);
        if (candidates.empty()) continue;
        keepDistinct(candidates);
        for (Candidate& candidate : candidates)
        {
            candidate.feature.sphere = static_cast<int>(i);
            features.push_back(candidate.feature);
        }
    }
}

void PolylineSurface::findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const
{
    thread_local std::vector<int> sides;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        Vector const& centre = spheres[i].centre;
        Real const limit = std::max(farthestDepths * depth_, spheres[i].radius) + reach;
        grid_.near(centre, limit, sides);
        auto const isNear = [&](int side) { return distanceTo(facets_[static_cast<std::size_t>(side)], centre) <= limit; };
        if (std::any_of(sides.begin(), sides.end(), isNear)) numbers.push_back(static_cast<int>(i));
    }
}

} // namespace mpsDem
