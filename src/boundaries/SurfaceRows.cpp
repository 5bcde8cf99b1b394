#include "boundaries/SurfaceRows.h"

#include <cmath>

#include "boundaries/TriangleTree.h"
namespace mpsDem {
BoundaryRows boundaryRows(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real l0)
{
    BoundaryRows rows;
    TriangleTree tree(surfaces);
    Vector low = surfaces[0].low(), high = surfaces[0].high();
    for (auto const& s : surfaces) { low = low.cwiseMin(s.low()); high = high.cwiseMax(s.high()); }
    int const g = ghostRows[0] + 1;
    Eigen::Vector3i a = (low / l0).array().round().cast<int>() - g, b = (high / l0).array().round().cast<int>() + g;
    for (int k = a.z(); k < b.z(); ++k)
        for (int j = a.y(); j < b.y(); ++j)
            for (int i = a.x(); i < b.x(); ++i)
            {
                Vector const r = l0 * Vector(i + 0.5, j + 0.5, k + 0.5);
                auto const near = tree.nearest(r);
                if (near.distance > 0 || near.distance < -1.8 * g * l0) continue;
                rows.position.push_back(r);
                rows.normal.push_back((near.point - r).normalized());
                rows.type.push_back(near.distance > -0.9 * l0 ? ParticleType::Wall : ParticleType::Ghost);
                rows.chain.push_back(near.surface);
            }
    return rows;
}
} // namespace mpsDem
