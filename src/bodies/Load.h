#pragma once

#include "core/Types.h"

namespace mpsDem {

/// Force and moment about the centre of mass.
struct Load
{
    Vector force = Vector::Zero();  ///< [N].
    Vector moment = Vector::Zero(); ///< [N m].

    Load& operator+=(Load const& other)
    {
        force += other.force;
        moment += other.moment;
        return *this;
    }
    friend Load operator+(Load a, Load const& b) { return a += b; }
    friend Load operator*(Real s, Load const& a) { return {s * a.force, s * a.moment}; }

    /// Adds a force that acts at `arm` from the centre of mass.
    void add(Vector const& f, Vector const& arm)
    {
        force += f;
        moment += arm.cross(f);
    }
};

using Matrix6 = Eigen::Matrix<Real, 6, 6>;
using Vector6 = Eigen::Matrix<Real, 6, 1>; ///< Translation first, rotation behind; global axes.

} // namespace mpsDem
