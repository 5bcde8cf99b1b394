#include "dem/ContactPoints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/Errors.h"
#include "dem/Facets.h"

namespace mpsDem {

namespace {

/// Largest radius <= `radius` of a circle inside the outline that touches side i at r.
Real inscribedRadius(std::vector<Facet> const& sides, std::size_t i, Vector const& r, Real radius)
{
    auto const fits = [&](Real candidate) {
        Vector const centre = r - candidate * sides[i].normal;
        for (std::size_t k = 0; k < sides.size(); ++k)
            if (k != i && distanceTo(sides[k], centre) < candidate * (1 - 1e-9)) return false;
        return true;
    };
    if (fits(radius)) return radius;
    Real low = 0;
    Real high = radius;
    for (int step = 0; step < 50; ++step)
    {
        Real const middle = 0.5 * (low + high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

} // namespace

ContactPointSet::ContactPointSet(ContactShape const& shape, Real spacing, Real thickness)
{
    if (shape.radius)
        addDisc(*shape.radius, spacing, thickness);
    else if (shape.skin)
        addSurface(*shape.skin, spacing);
    else
        addPolygon(shape.outline, spacing, thickness);
}

void ContactPointSet::addDisc(Real radius, Real spacing, Real thickness)
{
    points_.push_back({Vector::Zero(), radius, radius, spacing * thickness, 1});
    largestSide_ = spacing * thickness;
}

void ContactPointSet::addPolygon(Polyline const& outline, Real spacing, Real thickness)
{
    require(outline.closed(), {}, "outline \"" + outline.name() + "\" of a body is not closed", "a closed polyline");
    std::vector<Facet> const sides = facetsOf(outline);
    std::size_t const count = sides.size();
    Real const sharp = std::cos(30 * std::numbers::pi / 180);

    // Length that the corner behind side i takes from each of its two sides; 0 without a contact point there.
    std::vector<Real> corner(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
        Facet const& next = sides[(i + 1) % count];
        if (sides[i].jointB != Facet::Joint::Convex || sides[i].tangent.dot(next.tangent) > sharp) continue;
        corner[i] = 0.5 * std::min({spacing, sides[i].length, next.length});
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        Facet const& side = sides[i];
        Real const before = corner[(i + count - 1) % count];
        Real const rest = side.length - before - corner[i];
        largestSide_ = std::max(largestSide_, side.length * thickness);
        int const spheres = rest < 1e-9 * side.length ? 0 : std::max(1, static_cast<int>(std::lround(rest / spacing)));
        for (int k = 0; k < spheres; ++k)
        {
            Vector const r = side.a + (before + rest * (k + 0.5) / spheres) * side.tangent;
            Real const radius = inscribedRadius(sides, i, r, 0.5 * spacing);
            Real const area = rest / spheres * thickness;
            points_.push_back({r - radius * side.normal, radius, 0.5 * spacing, area, area / (spacing * spacing)});
        }
        if (corner[i] <= 0) continue;
        Real const area = corner[i] * thickness;
        points_.push_back({side.b, 0, 0.5 * spacing, area, area / (spacing * spacing)});
    }
}

} // namespace mpsDem
