#pragma once

#include "dem/ContactSurface.h"

namespace mpsDem {

/// Endless plane, solid on the side against its normal: a stopper.
class PlaneSurface final : public ContactSurface
{
public:
    /// @param normal  Into the free side; any length above zero.
    PlaneSurface(Vector const& point, Vector const& normal) : point_(point), normal_(normal.normalized()) {}

    void collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const override;
    void findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const override;

private:
    Vector point_;
    Vector normal_;
};

/// Disc (2-D) or ball around the origin of its axes.
class DiscSurface final : public ContactSurface
{
public:
    explicit DiscSurface(Real radius) : radius_(radius) {}

    void collect(std::span<Sphere const> spheres, Real reach, std::vector<ContactFeature>& features) const override;
    void findNear(std::span<Sphere const> spheres, Real reach, std::vector<int>& numbers) const override;

private:
    Real radius_;
};

} // namespace mpsDem
