#include "dem/Facets.h"

#include <algorithm>

namespace mpsDem {

namespace {

using Segments = std::vector<Polyline::Segment>;

bool collinear(Segments const& segments, std::size_t first, std::size_t last)
{
    Vector const chord = segments[last].b - segments[first].a;
    Real const length = chord.norm();
    if (length <= 0) return false;
    for (std::size_t i = first; i < last; ++i)
        if ((segments[i].b - segments[first].a).cross(chord).norm() > 1e-9 * length * length) return false;
    return true;
}

Facet merged(Segments const& segments, std::size_t first, std::size_t last)
{
    Polyline::Segment const& s = segments[first];
    Facet facet{s.a, segments[last].b, s.tangent, s.normal, s.length, s.patch};
    if (last == first) return facet;
    Vector const chord = facet.b - facet.a;
    facet.length = chord.norm();
    facet.tangent = chord / facet.length;
    facet.normal = (s.normal - s.normal.dot(facet.tangent) * facet.tangent).normalized();
    return facet;
}

Facet::Joint joint(Facet const& before, Facet const& after)
{
    Real const rise = after.tangent.dot(before.normal);
    if (rise > 1e-9) return Facet::Joint::Concave;
    if (rise < -1e-9) return Facet::Joint::Convex;
    return Facet::Joint::Flat;
}

/// @param outwards  Direction in which the chain ends at `end`.
Facet::Joint joinedEnd(Vector const& end, Vector const& outwards, std::vector<Facet> const& others, Real tolerance)
{
    for (Facet const& other : others)
    {
        Real const facing = other.normal.dot(outwards);
        if (facing > 1e-9 || distanceTo(other, end) > tolerance) continue;
        return facing < -1e-9 ? Facet::Joint::Concave : Facet::Joint::Flat;
    }
    return Facet::Joint::Free;
}

} // namespace

Real distanceTo(Facet const& side, Vector const& r)
{
    Real const along = std::clamp((r - side.a).dot(side.tangent), Real(0), side.length);
    return (r - side.a - along * side.tangent).norm();
}

void joinEnds(std::vector<Facet>& facets, std::vector<Facet> const& others, Real tolerance)
{
    Facet& first = facets.front();
    Facet& last = facets.back();
    if (first.jointA == Facet::Joint::Free) first.jointA = joinedEnd(first.a, -first.tangent, others, tolerance);
    if (last.jointB == Facet::Joint::Free) last.jointB = joinedEnd(last.b, last.tangent, others, tolerance);
}

std::vector<Facet> facetsOf(Polyline const& line)
{
    Segments const& segments = line.segments();
    std::vector<Facet> facets;
    for (std::size_t first = 0; first < segments.size();)
    {
        std::size_t last = first;
        while (last + 1 < segments.size() && segments[last + 1].patch == segments[first].patch) ++last;
        if (!collinear(segments, first, last)) last = first;
        facets.push_back(merged(segments, first, last));
        first = last + 1;
    }
    std::size_t const joints = line.closed() ? facets.size() : facets.size() - 1;
    for (std::size_t i = 0; i < joints; ++i)
    {
        Facet& before = facets[i];
        Facet& after = facets[(i + 1) % facets.size()];
        before.jointB = after.jointA = joint(before, after);
    }
    return facets;
}

} // namespace mpsDem
