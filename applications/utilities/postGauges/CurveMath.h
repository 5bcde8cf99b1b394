#pragma once

#include <optional>
#include <vector>

#include "core/Types.h"

namespace mpsDem::postGauges {

/// Points of a curve, x not decreasing.
struct Points
{
    std::vector<Real> x;
    std::vector<Real> y;
};

/// Difference of a curve from a reference.
struct Difference
{
    Real maximum = 0;        ///< Largest |curve - reference|.
    Real at = 0;             ///< x where it is found.
    Real rms = 0;            ///< Root of the mean square over the reference's points.
    Real referenceRange = 0; ///< Largest minus smallest y of the reference's points that took part.
    std::size_t points = 0;  ///< Points of the reference that took part.
};

/// Top of a wave.
struct Crest
{
    Real x = 0;
    Real y = 0;
};

/// True where no x is less than the one before it.
bool increases(Points const& points);

/// The points with a finite x and y.
Points finitePoints(Points const& points);

/// y by linear interpolation; x must lie within the points.
Real interpolate(Points const& points, Real x);

/// Compares at those points of the reference that lie in [from, to] and on the curve. Nothing where there is none.
std::optional<Difference> compareCurves(Points const& curve, Points const& reference, Real from, Real to);

/// The first crest: first maximum that stands higher than `prominence` over the lowest point before it and from which the curve falls
/// by more than `prominence`. Between the points by a parabola through three of them. Nothing where the curve has no such top.
std::optional<Crest> firstCrest(Points const& points, Real prominence);

} // namespace mpsDem::postGauges
