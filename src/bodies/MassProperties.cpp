#include "bodies/MassProperties.h"

#include <cmath>
#include <numbers>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// Area and area integrals of a polygon: first and second moments about the origin of the points, sign of the sense of rotation.
struct AreaMoments
{
    Real area = 0;
    Real x = 0, y = 0;
    Real xx = 0, yy = 0, xy = 0;
};

AreaMoments areaMoments(std::vector<Vector> const& points, Vector const& origin)
{
    AreaMoments sum;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        Vector const a = points[k] - origin;
        Vector const b = points[(k + 1) % points.size()] - origin;
        Real const c = a.x() * b.y() - b.x() * a.y();
        sum.area += c / 2;
        sum.x += c * (a.x() + b.x()) / 6;
        sum.y += c * (a.y() + b.y()) / 6;
        sum.xx += c * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 12;
        sum.yy += c * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 12;
        sum.xy += c * (a.x() * b.y() + 2 * a.x() * a.y() + 2 * b.x() * b.y() + b.x() * a.y()) / 24;
    }
    return sum;
}

void requirePositive(Real value, char const* what)
{
    require(std::isfinite(value) && value > 0, {}, std::string(what) + " of a body is " + shortNumber(value), "a positive number");
}

} // namespace

MassProperties MassProperties::fromPolygon(Polyline const& outline, Real thickness, Real density)
{
    require(outline.closed(), {}, "outline \"" + outline.name() + "\" of a body is open", "a closed chain of points");
    requirePositive(thickness, "thickness");
    requirePositive(density, "density");

    // Moments about a corner first, then about the centroid: no loss of digits far from the origin.
    Vector const corner = outline.points().front();
    AreaMoments const first = areaMoments(outline.points(), corner);
    Real const size = outline.segments().front().length;
    require(std::abs(first.area) > 1e-12 * size * size, {}, "outline \"" + outline.name() + "\" of a body has no area",
            "a polygon with an inside");

    MassProperties result;
    result.centreOfMass = corner + Vector(first.x / first.area, first.y / first.area, 0);
    AreaMoments const central = areaMoments(outline.points(), result.centreOfMass);
    Real const area = std::abs(central.area);
    Real const sense = central.area > 0 ? 1 : -1;

    result.volume = area * thickness;
    result.mass = density * result.volume;
    Real const perArea = sense * density * thickness;
    Real const xx = perArea * central.xx, yy = perArea * central.yy, xy = perArea * central.xy;
    Real const zz = result.mass * thickness * thickness / 12;
    result.inertia << yy + zz, -xy, 0, -xy, xx + zz, 0, 0, 0, xx + yy;
    return result;
}

MassProperties MassProperties::fromCylinder2D(Vector const& centre, Real radius, Real thickness, Real density)
{
    requirePositive(radius, "radius");
    requirePositive(thickness, "thickness");
    requirePositive(density, "density");
    MassProperties result;
    result.volume = std::numbers::pi * radius * radius * thickness;
    result.mass = density * result.volume;
    result.centreOfMass = centre;
    Real const across = result.mass * (3 * radius * radius + thickness * thickness) / 12;
    result.inertia = Vector(across, across, result.mass * radius * radius / 2).asDiagonal();
    return result;
}

MassProperties MassProperties::withMass(Real newMass) const
{
    requirePositive(newMass, "mass");
    MassProperties scaled = *this;
    scaled.inertia *= newMass / mass;
    scaled.mass = newMass;
    return scaled;
}

} // namespace mpsDem
