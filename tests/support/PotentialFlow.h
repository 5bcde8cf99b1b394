#pragma once

#include <functional>

#include <Eigen/Core>

#include "core/Types.h"

namespace mpsDem::test {

/// Linear: d eta/dt = dphi/dz and d psi/dt = -g eta on z = 0. Nonlinear: kinematic condition and Bernoulli's equation on z = eta.
enum class SurfaceCondition
{
    linear,
    nonlinear
};

/// Waves of an inviscid fluid without vorticity in 2-D, over a bed that moves, between two vertical walls; z = 0 is the water at rest.
///
/// Unknowns are the elevation eta(x, t) [m] and the surface potential psi(x, t) = phi(x, eta, t) [m2/s]. With G, which takes psi and the
/// rise of the bed to the flux through the surface (Dirichlet-Neumann operator):
///     d eta/dt = G,   d psi/dt = -g eta - psi_x^2 / 2 + (G + eta_x psi_x)^2 / (2 (1 + eta_x^2))
/// (Zakharov 1968; Craig and Sulem 1993), linear: d psi/dt = -g eta, with G of the water below z = 0. G follows from Laplace's equation
/// for phi by bilinear finite elements in columns of one width, layers of a column of one height, on a mesh that moves with bed and
/// surface. Derivatives along the surface are central; classical Runge-Kutta in time. Second order in the mesh; fluxes conserve volume.
class PotentialFlow
{
public:
    using Array = Eigen::ArrayXd;
    /// Elevation of the bed [m], negative, at these x [m] and this time [s].
    using Bed = std::function<Array(Array const& x, Real t)>;

    static constexpr Real gravity = 9.81; ///< [m/s2].

    /// At rest. @param length  From wall to wall, the first at x = 0 [m].
    PotentialFlow(Real length, int columns, int layers, Bed bed, SurfaceCondition condition);

    /// Starts from eta [m] and psi [m2/s] at each x.
    void setSurface(Array const& elevation, Array const& potential);

    /// One time step [s].
    void advance(Real dt);

    [[nodiscard]] Array const& x() const { return x_; }
    [[nodiscard]] Real time() const { return time_; }
    [[nodiscard]] Array elevation() const { return state_.col(0); }
    /// At one place, on the straight line between nodes [m].
    [[nodiscard]] Real elevation(Real x) const;

    /// From the bed to the surface [m].
    [[nodiscard]] Array depth() const { return state_.col(0) - bed_(x_, time_); }

    /// Integral over x by the trapezoidal rule [m times the unit of the values].
    [[nodiscard]] Real integral(Array const& values) const { return (weights_ * values).sum(); }

    /// Kinetic and potential energy by density and width, over a bed at rest: 1/2 of the integral of psi G + g eta^2 [m4/s2].
    [[nodiscard]] Real energy() const;

private:
    using State = Eigen::ArrayX2d; ///< eta and psi.

    [[nodiscard]] State rate(State const& state, Real t) const;

    /// G for this upper end of the mesh [m/s].
    [[nodiscard]] Array surfaceFlux(Array const& surface, Array const& potential, Real t) const;

    Real width_; ///< Of a column [m].
    Eigen::Index layers_;
    Bed bed_;
    SurfaceCondition condition_;
    Array x_, weights_; ///< The latter are those of the trapezoidal rule [m].
    State state_;
    Real time_ = 0;
};

} // namespace mpsDem::test
