#include "postGauges/FreeSurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/Errors.h"

namespace mpsDem::postGauges {

namespace {

constexpr Real linkDistance = 1.5; ///< Spacings: the first ring of a disturbed lattice, not the second.
constexpr Real depth = 3;          ///< Spacings below the top that the volume method looks at: wall and ghost rows are that thick.
constexpr Real kernelRadius = 2.5; ///< Spacings.

/// Wendland's C2 kernel of radius R, integral 1: 7/(pi R^2) (1-q)^4 (1+4q) in 2-D, 21/(2 pi R^3) in 3-D, q = r/R.
Real wendland(Real distance, Real radius, int dimensions)
{
    Real const q = distance / radius;
    if (q >= 1) return 0;
    Real const factor = dimensions == 2 ? 7 / (std::numbers::pi * radius * radius) : 21 / (2 * std::numbers::pi * radius * radius * radius);
    Real const square = (1 - q) * (1 - q);
    return factor * square * square * (1 + 4 * q);
}

/// Length of [a - h, a + h] within [b - w, b + w].
Real overlap(Real a, Real h, Real b, Real w) { return std::max(0.0, std::min(a + h, b + w) - std::max(a - h, b - w)); }

} // namespace

FreeSurface::FreeSurface(std::vector<Vector> const& fluid, std::vector<Vector> const& solid, SurfaceSettings settings)
    : settings_(std::move(settings))
{
    require(settings_.spacing > 0, {}, "the particle spacing must be positive");
    bool const flat = settings_.dimensions == 2;
    Vector const aside = std::abs(settings_.up.z()) < 0.9 ? Vector::UnitZ() : Vector::UnitY();
    across_ = settings_.up.cross(aside).normalized();
    along_ = flat ? Vector(Vector::Zero()) : Vector(settings_.up.cross(across_));

    std::vector<int> const sizes = groupSizes(fluid, linkDistance * settings_.spacing);
    int const largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
    int const needed = std::min(settings_.splash, largest);
    points_.reserve(fluid.size() + solid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
    {
        if (sizes[i] >= needed)
            points_.push_back(pointAt(fluid[i], true));
        else
            ++drops_;
    }
    for (Vector const& position : solid) points_.push_back(pointAt(position, false));
    std::stable_sort(points_.begin(), points_.end(), [](Point const& a, Point const& b) { return a.across < b.across; });
}

FreeSurface::Point FreeSurface::pointAt(Vector const& position, bool fluid) const
{
    return {position.dot(across_), position.dot(along_), position.dot(settings_.up), fluid};
}

std::vector<FreeSurface::Point> FreeSurface::column(Point const& centre, Real halfWidth) const
{
    auto const less = [](Point const& a, Real value) { return a.across < value; };
    std::vector<Point> found;
    auto point = std::lower_bound(points_.begin(), points_.end(), centre.across - halfWidth, less);
    for (; point != points_.end() && point->across <= centre.across + halfWidth; ++point)
    {
        if (std::abs(point->along - centre.along) <= halfWidth) found.push_back(*point);
    }
    return found;
}

Real FreeSurface::share(Point const& point, Point const& centre) const
{
    Real const half = 0.5 * settings_.spacing, halfWidth = 0.5 * settings_.width * settings_.spacing;
    Real const first = overlap(point.across, half, centre.across, halfWidth) / settings_.spacing;
    if (settings_.dimensions == 2) return first;
    return first * overlap(point.along, half, centre.along, halfWidth) / settings_.spacing;
}

std::optional<Real> FreeSurface::topOf(std::vector<Point> const& points, Point const& centre) const
{
    std::optional<Real> top;
    for (Point const& point : points)
    {
        bool const counts = point.fluid && share(point, centre) > 0;
        if (counts && (!top || point.height > *top)) top = point.height;
    }
    return top;
}

std::optional<Real> FreeSurface::elevation(Vector const& location) const
{
    Point const centre = pointAt(location, false);
    auto const top = topOf(column(centre, (0.5 * settings_.width + 0.5) * settings_.spacing), centre);
    if (!top) return std::nullopt;
    return settings_.method == SurfaceMethod::Volume ? byVolume(centre, *top) : byFill(centre, *top);
}

Real FreeSurface::byVolume(Point const& centre, Real top) const
{
    Real const dx = settings_.spacing;
    Real const base = top + (0.5 - depth) * dx;
    Real filled = 0; // in columns' widths times metres
    for (Point const& point : column(centre, (0.5 * settings_.width + 0.5) * dx))
    {
        if (!point.fluid && point.height > top) continue;
        Real const above = std::clamp(point.height + 0.5 * dx - base, 0.0, dx);
        filled += share(point, centre) * above;
    }
    return base + filled / std::pow(settings_.width, settings_.dimensions - 1);
}

Real FreeSurface::byFill(Point const& centre, Real top) const
{
    Real const dx = settings_.spacing, radius = kernelRadius * dx;
    std::vector<Point> const near = column(centre, radius);
    Real const volume = std::pow(dx, settings_.dimensions);
    auto const fill = [&](Real height) {
        Real sum = 0;
        for (Point const& point : near)
        {
            if (!point.fluid && point.height > top) continue;
            Real const distance = std::hypot(point.across - centre.across, point.along - centre.along, point.height - height);
            sum += volume * wendland(distance, radius, settings_.dimensions);
        }
        return sum;
    };
    Real const step = 0.25 * dx;
    Real low = top + dx;
    while (fill(low) < 0.5 && low > top - 4 * dx) low -= step;
    if (low <= top - 4 * dx) return top + 0.5 * dx; // a layer too thin to fill half of the kernel
    Real high = low + step;
    for (int i = 0; i < 30; ++i)
    {
        Real const middle = 0.5 * (low + high);
        (fill(middle) < 0.5 ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace mpsDem::postGauges
