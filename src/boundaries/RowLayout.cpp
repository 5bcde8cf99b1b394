#include "boundaries/RowLayout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mpsDem {

namespace {

bool smooth(Polyline::Segment const& s, Polyline::Segment const& t)
{
    static Real const limit = std::cos(20.0 * std::numbers::pi / 180);
    return s.tangent.dot(t.tangent) > limit;
}

/// Vector from a corner to the parallel, per unit depth, towards the fluid: on both parallels at once.
Vector mitre(Polyline::Segment const& s, Polyline::Segment const& t) { return (s.normal + t.normal) / (1 + s.normal.dot(t.normal)); }

/// Corners of the parallel: one more than segments.
std::vector<Vector> parallelCorners(SmoothRun const& run, Real depth)
{
    std::vector<Vector> corners;
    std::size_t const count = run.segments.size();
    for (std::size_t i = 0; i <= count; ++i)
    {
        bool const first = i == 0, last = i == count;
        Polyline::Segment const& before = run.segments[first ? (run.loop ? count - 1 : 0) : i - 1];
        Polyline::Segment const& behind = run.segments[last ? (run.loop ? 0 : count - 1) : i];
        Vector const corner = last ? before.b : behind.a;
        corners.push_back(corner - depth * mitre(before, behind));
    }
    return corners;
}

} // namespace

std::vector<SmoothRun> smoothRuns(std::span<Polyline const> chains)
{
    std::vector<SmoothRun> runs;
    for (std::size_t c = 0; c < chains.size(); ++c)
    {
        std::vector<Polyline::Segment> segments = chains[c].segments();
        bool loop = false;
        if (chains[c].closed())
        {
            // A closed chain begins at a corner, so that no run is cut in its middle; without any corner it is a loop.
            std::size_t begin = 0;
            while (begin < segments.size() && smooth(segments[(begin + segments.size() - 1) % segments.size()], segments[begin])) ++begin;
            loop = begin == segments.size();
            if (!loop) std::rotate(segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(begin), segments.end());
        }
        for (std::size_t i = 0; i < segments.size(); ++i)
        {
            bool const goesOn = i > 0 && smooth(segments[i - 1], segments[i]);
            if (!goesOn) runs.push_back({static_cast<int>(c), {}, loop});
            runs.back().segments.push_back(segments[i]);
        }
    }
    return runs;
}

std::vector<RowPoint> parallelPoints(SmoothRun const& run, Real depth, Real spacing)
{
    std::vector<Vector> const corners = parallelCorners(run, depth);
    std::size_t const count = run.segments.size();
    std::vector<Real> length(count);
    Real total = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        length[i] = std::max(Real(0), (corners[i + 1] - corners[i]).dot(run.segments[i].tangent));
        total += length[i];
    }
    std::vector<RowPoint> points;
    if (!(total > 0)) return points;
    int const parts = std::max(1, static_cast<int>(std::lround(total / spacing)));
    Real const step = total / parts;
    std::size_t i = 0;
    Real passed = 0;
    for (int m = 0; m < parts; ++m)
    {
        Real const along = (m + 0.5) * step;
        while (i + 1 < count && passed + length[i] < along) passed += length[i++];
        points.push_back({corners[i] + (along - passed) * run.segments[i].tangent, run.segments[i].normal});
    }
    return points;
}

std::vector<RowPoint> continuedPoints(SmoothRun const& run, Real depth, Real spacing, int count)
{
    std::vector<RowPoint> points;
    if (run.loop) return points;
    Polyline::Segment const& first = run.segments.front();
    Polyline::Segment const& last = run.segments.back();
    Real length = 0;
    for (Polyline::Segment const& s : run.segments) length += s.length;
    Real const step = length / std::max(1, static_cast<int>(std::lround(length / spacing)));
    Real const safeStep = std::clamp(step, 0.7 * spacing, 1.4 * spacing);
    for (int i = 0; i < count; ++i) points.push_back({first.a - depth * first.normal - (i + 0.5) * safeStep * first.tangent, first.normal});
    for (int i = 0; i < count; ++i) points.push_back({last.b - depth * last.normal + (i + 0.5) * safeStep * last.tangent, last.normal});
    return points;
}

std::vector<FluidCorner> fluidCorners(std::span<SmoothRun const> runs, Real tolerance)
{
    struct End
    {
        Vector point, away; ///< Direction from the corner along the surface.
        Polyline::Segment const* segment;
        int chain;
    };
    std::vector<End> ends;
    for (SmoothRun const& run : runs)
    {
        if (run.loop) continue;
        ends.push_back({run.segments.front().a, run.segments.front().tangent, &run.segments.front(), run.chain});
        ends.push_back({run.segments.back().b, -run.segments.back().tangent, &run.segments.back(), run.chain});
    }
    std::vector<std::size_t> order(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ends[a].point.x() < ends[b].point.x(); });

    std::vector<FluidCorner> corners;
    for (std::size_t m = 0; m < order.size(); ++m)
        for (std::size_t n = m + 1; n < order.size() && ends[order[n]].point.x() - ends[order[m]].point.x() <= tolerance; ++n)
        {
            End const& e = ends[std::min(order[m], order[n])];
            End const& f = ends[std::max(order[m], order[n])];
            if ((e.point - f.point).norm() > tolerance) continue;
            bool const fluidInside = f.away.dot(e.segment->normal) > 1e-9 && e.away.dot(f.segment->normal) > 1e-9;
            if (fluidInside) corners.push_back({e.point, mitre(*e.segment, *f.segment), e.chain});
        }
    return corners;
}

} // namespace mpsDem
