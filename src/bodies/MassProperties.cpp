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

/// Volume integrals of 1, r and r r^T over what a closed surface holds, r from `origin`.
struct VolumeMoments
{
    Real volume = 0;
    Vector first = Vector::Zero();
    Tensor second = Tensor::Zero();
};

VolumeMoments volumeMoments(TriSurface const& surface, Vector const& origin)
{
    VolumeMoments sum;
    for (TriSurface::Triangle const& t : surface.triangles())
    {
        Vector const a = surface.point(t, 0) - origin, b = surface.point(t, 1) - origin, c = surface.point(t, 2) - origin;
        Vector const s = a + b + c;
        Real const d = a.dot(b.cross(c));
        sum.volume += d / 6;
        sum.first += d / 24 * s;
        sum.second += d / 120 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
    return sum;
}

std::string place(Vector const& r) { return "(" + shortNumber(r.x()) + " " + shortNumber(r.y()) + " " + shortNumber(r.z()) + ")"; }

void requireSolid(TriSurface const& surface)
{
    std::string const self = "surface \"" + surface.name() + "\" of a body ";
    for (TriSurface::Edge const& edge : surface.edges())
        if (edge.rim())
            throw CaseError(ExitCode::BadInput,
                            self + "is open: it has a rim at " + place(surface.points()[static_cast<std::size_t>(edge.a)]) + " m",
                            "a closed surface");
    Real const volume = surface.volume();
    require(std::abs(volume) > 1e-12 * std::pow(surface.area(), 1.5), {}, self + "has no volume", "a surface with an inside");
    require(volume > 0, {}, self + "has its normals on the inside", "normals outwards");
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

MassProperties MassProperties::fromTriSurface(TriSurface const& surface, Real density)
{
    requirePositive(density, "density");
    requireSolid(surface);
    Vector const middle = (surface.low() + surface.high()) / 2;
    VolumeMoments const outer = volumeMoments(surface, middle);
    Vector const toCentre = outer.first / outer.volume;
    VolumeMoments const central = volumeMoments(surface, middle + toCentre);

    MassProperties result;
    result.volume = central.volume;
    result.mass = density * result.volume;
    result.centreOfMass = middle + toCentre;
    result.inertia = density * (central.second.trace() * Tensor::Identity() - central.second);
    return result;
}

MassProperties MassProperties::fromSphere(Vector const& centre, Real radius, Real density)
{
    requirePositive(radius, "radius");
    requirePositive(density, "density");
    MassProperties result;
    result.volume = 4 * std::numbers::pi / 3 * radius * radius * radius;
    result.mass = density * result.volume;
    result.centreOfMass = centre;
    result.inertia = 0.4 * result.mass * radius * radius * Tensor::Identity();
    return result;
}

MassProperties MassProperties::fromCylinder(Vector const& end1, Vector const& end2, Real radius, Real density)
{
    requirePositive(radius, "radius");
    requirePositive(density, "density");
    Real const length = (end2 - end1).norm();
    requirePositive(length, "length");
    Vector const axis = (end2 - end1) / length;
    MassProperties result;
    result.volume = std::numbers::pi * radius * radius * length;
    result.mass = density * result.volume;
    result.centreOfMass = (end1 + end2) / 2;
    Real const across = result.mass * (3 * radius * radius + length * length) / 12;
    Real const along = result.mass * radius * radius / 2;
    result.inertia = across * Tensor::Identity() + (along - across) * (axis * axis.transpose());
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
