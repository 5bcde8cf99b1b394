#pragma once

#include <vector>

#include "core/Polyline.h"

namespace mpsDem {

/// One straight side of a polyline: a run of collinear segments taken as one.
struct Facet
{
    /// How it goes on at an end.
    enum class Joint
    {
        Free,    ///< The chain ends.
        Flat,    ///< Straight on.
        Concave, ///< A valley: the next side rises into the free space.
        Convex   ///< A ridge.
    };

    Vector a;       ///< First point [m].
    Vector b;       ///< Second point [m].
    Vector tangent; ///< Unit vector from a to b.
    Vector normal;  ///< Unit normal into the free space.
    Real length;    ///< [m].
    int patch;      ///< As in Polyline::Segment.
    Joint jointA = Joint::Free;
    Joint jointB = Joint::Free;
};

/// Sides of a polyline, in order. Segments of one patch are merged where all their points lie on one line within 1e-9 of its length,
/// so that a ramp of many pieces costs and acts as one of one piece.
std::vector<Facet> facetsOf(Polyline const& line);

/// Ends of a chain that lie on another one's side (within `tolerance` [m]) go on there: flat, or as a valley where that side faces back.
/// So a ramp and a floor given as two surfaces act as one.
void joinEnds(std::vector<Facet>& facets, std::vector<Facet> const& others, Real tolerance);

/// Distance from r to the nearest point of the side [m].
Real distanceTo(Facet const& side, Vector const& r);

} // namespace mpsDem
