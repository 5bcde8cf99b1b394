#include "postGauges/CurveMath.h"

#include <algorithm>
#include <cmath>

namespace mpsDem::postGauges {

bool increases(Points const& points) { return std::is_sorted(points.x.begin(), points.x.end()); }

Points finitePoints(Points const& points)
{
    Points finite;
    for (std::size_t i = 0; i < points.x.size(); ++i)
    {
        if (!std::isfinite(points.x[i]) || !std::isfinite(points.y[i])) continue;
        finite.x.push_back(points.x[i]);
        finite.y.push_back(points.y[i]);
    }
    return finite;
}

Real interpolate(Points const& points, Real x)
{
    auto const above = static_cast<std::size_t>(std::lower_bound(points.x.begin(), points.x.end(), x) - points.x.begin());
    if (above == 0) return points.y.front();
    if (above >= points.x.size()) return points.y.back();
    Real const width = points.x[above] - points.x[above - 1];
    Real const share = width > tiny ? (x - points.x[above - 1]) / width : 1.0;
    return (1 - share) * points.y[above - 1] + share * points.y[above];
}

std::optional<Difference> compareCurves(Points const& curve, Points const& reference, Real from, Real to)
{
    Points const a = finitePoints(curve);
    Points const b = finitePoints(reference);
    if (a.x.empty()) return std::nullopt;
    Difference result;
    Real squares = 0, lowest = 0, highest = 0;
    for (std::size_t i = 0; i < b.x.size(); ++i)
    {
        bool const takesPart = b.x[i] >= std::max(from, a.x.front()) && b.x[i] <= std::min(to, a.x.back());
        if (!takesPart) continue;
        Real const difference = std::abs(interpolate(a, b.x[i]) - b.y[i]);
        bool const first = result.points == 0;
        lowest = first ? b.y[i] : std::min(lowest, b.y[i]);
        highest = first ? b.y[i] : std::max(highest, b.y[i]);
        if (first || difference > result.maximum)
        {
            result.maximum = difference;
            result.at = b.x[i];
        }
        squares += difference * difference;
        ++result.points;
    }
    if (result.points == 0) return std::nullopt;
    result.rms = std::sqrt(squares / static_cast<Real>(result.points));
    result.referenceRange = highest - lowest;
    return result;
}

namespace {

/// Top of the parabola through the points beside `i`, held between them.
Crest refined(Points const& p, std::size_t i)
{
    Crest const crest{p.x[i], p.y[i]};
    if (i == 0 || i + 1 >= p.x.size()) return crest;
    Real const a = p.x[i - 1] - crest.x, b = p.x[i + 1] - crest.x;
    Real const da = p.y[i - 1] - crest.y, db = p.y[i + 1] - crest.y;
    Real const divisor = a * b * (a - b);
    if (std::abs(divisor) < tiny) return crest;
    Real const curvature = (da * b - db * a) / divisor;
    Real const slope = (db * a * a - da * b * b) / divisor;
    if (curvature >= 0) return crest;
    Real const shift = std::clamp(-slope / (2 * curvature), a, b);
    return {crest.x + shift, crest.y + slope * shift + curvature * shift * shift};
}

} // namespace

std::optional<Crest> firstCrest(Points const& points, Real prominence)
{
    Points const p = finitePoints(points);
    if (p.x.empty()) return std::nullopt;
    Real lowest = p.y.front();
    std::size_t top = 0;
    bool rising = false;
    for (std::size_t i = 0; i < p.x.size(); ++i)
    {
        if (!rising)
        {
            lowest = std::min(lowest, p.y[i]);
            rising = p.y[i] - lowest > prominence;
            top = i;
            continue;
        }
        if (p.y[i] > p.y[top]) top = i;
        if (p.y[top] - p.y[i] > prominence) return refined(p, top);
    }
    return std::nullopt;
}

} // namespace mpsDem::postGauges
