#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "functionObjects/SurfaceElevation.h"

namespace mpsDem::test {

/// The crest of a wave in 2-D: vertex of the parabola of least squares over the elevations, one a spacing, within a reach of the highest one.
struct Crest
{
    Real place = 0;  ///< Of the crest [m].
    Real height = 0; ///< Of the crest above the water at rest [m].
};

/// Celerity of a solitary wave, third order [m/s]: c^2 = g h (1 + e - e^2/20 - 3 e^3/70), e = height/depth (Grimshaw 1971).
inline Real solitaryCelerity(Real depth, Real height)
{
    Real const e = height / depth;
    return std::sqrt(9.81 * depth * (1 + e - e * e / 20 - 3 * e * e * e / 70));
}

/// Places over times; celerity: slope of the straight line of least squares through them [m/s], no number for less than two.
class CrestPath
{
public:
    void add(Real time, Real place)
    {
        n_ += 1;
        t_ += time;
        x_ += place;
        tt_ += time * time;
        tx_ += time * place;
    }
    [[nodiscard]] Real celerity() const { return (n_ * tx_ - t_ * x_) / (n_ * tt_ - t_ * t_); }

private:
    Real n_ = 0, t_ = 0, x_ = 0, tt_ = 0, tx_ = 0;
};

/// Looks for it between two places [m]. @param depth  Of the water at rest, above y = 0 [m]. Where there is no wave, it is no number.
inline Crest findCrest(ParticleSet const& particles, Real depth, Real from, Real to, Real reach)
{
    SurfaceElevation surface(particles, SurfaceElevationControls{}, Vector(0, 1, 0));
    surface.update();
    Real const spacing = particles.lattice().spacing;
    std::vector<Vector> points;
    Vector highest = Vector::Zero();
    for (Real x = from + spacing; x < to - spacing; x += spacing)
    {
        points.emplace_back(x, surface.elevation(Vector(x, 0, 0)).value_or(depth) - depth, 0);
        if (points.back().y() > highest.y()) highest = points.back();
    }
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (Vector const& point : points)
    {
        Real const x = point.x() - highest.x();
        if (std::abs(x) > reach) continue;
        Eigen::Vector3d const row(1, x, x * x);
        normal += row * row.transpose();
        right += row * point.y();
    }
    Eigen::Vector3d const c = normal.ldlt().solve(right);
    return {highest.x() - c[1] / (2 * c[2]), c[0] - c[1] * c[1] / (4 * c[2])};
}

} // namespace mpsDem::test
