#include "boundaries/SurfaceTree.h"

#include <limits>

#include "core/Errors.h"

namespace mpsDem {

SurfaceTree::SurfaceTree(std::vector<Surface> const& surfaces) : low_(Vector::Constant(std::numeric_limits<Real>::infinity())), high_(-low_)
{
    std::vector<Polyline> const lines = linesOf(surfaces);
    std::vector<TriSurface> const triangles = trianglesOf(surfaces);
    expect(lines.empty() || triangles.empty(), "SurfaceTree: lines among triangles");
    if (triangles.empty())
        segments_.emplace(lines);
    else
        triangles_.emplace(triangles);
    Vector const none = Vector::Constant(std::numeric_limits<Real>::quiet_NaN());
    for (Polyline const& line : lines)
    {
        openEnds_.push_back(line.closed() ? none : line.points().front());
        openEnds_.push_back(line.closed() ? none : line.points().back());
    }
    for (Surface const& surface : surfaces)
        for (Vector const& r : surface.points())
        {
            low_ = low_.cwiseMin(r);
            high_ = high_.cwiseMax(r);
        }
}

SurfaceTree::Nearest SurfaceTree::nearest(Vector const& r) const
{
    if (triangles_)
    {
        TriangleTree::Nearest const near = triangles_->nearest(r);
        return {near.point, near.distance, near.normal, near.surface, near.atRim};
    }
    SegmentTree::Nearest const near = segments_->nearest(r);
    SegmentTree::Item const& item = segments_->item(near.item);
    std::size_t const ends = 2 * static_cast<std::size_t>(item.chain);
    bool const atEnd = near.point == openEnds_[ends] || near.point == openEnds_[ends + 1];
    return {near.point, near.distance, item.segment.normal, item.chain, atEnd};
}

} // namespace mpsDem
