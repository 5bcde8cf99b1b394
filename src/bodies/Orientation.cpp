#include "bodies/Orientation.h"

#include <cmath>

#include <Eigen/LU>

namespace mpsDem {

namespace {

Tensor crossMatrix(Vector const& a)
{
    Tensor m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

} // namespace

Quaternion rotationBy(Vector const& angle)
{
    Real const turn = angle.norm();
    // sin(x/2)/x by its series near zero: exact to round-off there.
    Real const factor = turn < 1e-4 ? 0.5 - turn * turn / 48 : std::sin(turn / 2) / turn;
    return {std::cos(turn / 2), factor * angle.x(), factor * angle.y(), factor * angle.z()};
}

Vector freeAngularVelocity(Tensor const& inertia, Vector const& momentum, Real h)
{
    Tensor const inverse = inertia.inverse();
    Vector const start = inverse * momentum;
    Vector const guess = inverse * (momentum - h / 2 * start.cross(momentum));
    Vector const middle = rotationBy(-h / 2 * guess) * momentum;
    Vector const residual = inertia * guess - middle;
    Tensor const jacobian = inertia - h / 2 * crossMatrix(middle);
    return guess - jacobian.inverse() * residual;
}

} // namespace mpsDem
