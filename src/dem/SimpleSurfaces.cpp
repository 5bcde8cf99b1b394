#include "dem/SimpleSurfaces.h"

namespace mpsDem {

void PlaneSurface::collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const
{
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        Real const gap = (spheres[i].centre - point_).dot(normal_) - spheres[i].radius;
        if (gap < reach) features.push_back({static_cast<int>(i), 0, normal_, gap, 0});
    }
}

void PlaneSurface::findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const
{
    for (std::size_t i = 0; i < spheres.size(); ++i)
        if ((spheres[i].centre - point_).dot(normal_) - spheres[i].radius <= reach) numbers.push_back(static_cast<int>(i));
}

void DiscSurface::collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const
{
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        Real const distance = spheres[i].centre.norm();
        Real const gap = distance - radius_ - spheres[i].radius;
        if (gap >= reach || distance == 0) continue;
        features.push_back({static_cast<int>(i), 0, spheres[i].centre / distance, gap, radius_});
    }
}

void DiscSurface::findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const
{
    for (std::size_t i = 0; i < spheres.size(); ++i)
        if (spheres[i].centre.norm() - radius_ - spheres[i].radius <= reach) numbers.push_back(static_cast<int>(i));
}

} // namespace mpsDem
