#pragma once

#include <span>
#include <vector>

#include "core/Polyline.h"
#include "core/Types.h"

namespace mpsDem {

/// Consecutive segments of one polyline that bend by no more than 20 degrees from one to the next.
struct SmoothRun
{
    int chain = 0;
    std::vector<Polyline::Segment> segments;
    bool loop = false; ///< The last segment joins the first one smoothly.
};

/// A place on the parallel of a run.
struct RowPoint
{
    Vector position;
    Vector normal;
};

/// Corner where two surfaces meet and the fluid has less than 180 degrees.
struct FluidCorner
{
    Vector point;
    Vector bisector; ///< Place of row k: point - (k + 1/2) l0 bisector. Its length is 1 / sin(half the angle of the fluid).
    int chain;       ///< Chain that the particles of the corner belong to.
};

/// Cuts polylines at bends of more than 20 degrees.
std::vector<SmoothRun> smoothRuns(std::span<Polyline const> chains);

/// Points in the middle of M = max(1, round(L / spacing)) equal parts of the parallel of a run at `depth` behind it.
std::vector<RowPoint> parallelPoints(SmoothRun const& run, Real depth, Real spacing);

/// `count` points that continue the parallel straight beyond the begin and then beyond the end of a run; none for a loop.
std::vector<RowPoint> continuedPoints(SmoothRun const& run, Real depth, Real spacing, int count);

/// Corners within chains and between ends of chains that come within `tolerance` of each other.
std::vector<FluidCorner> fluidCorners(std::span<SmoothRun const> runs, Real tolerance);

} // namespace mpsDem
