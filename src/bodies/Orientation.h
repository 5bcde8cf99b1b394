#pragma once

#include "core/Types.h"

namespace mpsDem {

/// Rotation by the vector `angle`: about its direction by its length [rad].
[[nodiscard]] Quaternion rotationBy(Vector const& angle);

/// Mean angular velocity over a time h of a body on which no moment acts.
///
/// Solves \f$ I \omega = \exp(-h\,\omega/2)\, \Pi \f$ (mid-point rule on the rotation group) by one Newton iteration from
/// \f$ I^{-1}(\Pi - \frac h2 \omega_0 \times \Pi) \f$; error of the solution O(h^4). Rotating by h omega keeps the momentum exactly
/// and the energy without drift.
/// @param inertia   I, body axes [kg m2].
/// @param momentum  Angular momentum Pi at the begin, body axes [kg m2/s].
/// @param h         [s].
/// @return omega, body axes at the begin (and the end: it is the axis of the turn) [rad/s].
[[nodiscard]] Vector freeAngularVelocity(Tensor const& inertia, Vector const& momentum, Real h);

} // namespace mpsDem
