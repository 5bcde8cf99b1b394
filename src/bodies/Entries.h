#pragma once

#include <string>

#include "core/Dictionary.h"
#include "core/Types.h"

namespace mpsDem {

/// Entries of a rigid body's dictionaries with their limits. All throw CaseError (BadInput) with the place and what is allowed.

[[nodiscard]] Real readNumber(Dictionary const& dict, std::string const& key);      ///< Finite.
[[nodiscard]] Real readPositive(Dictionary const& dict, std::string const& key);    ///< Finite and above zero.
[[nodiscard]] Real readNotNegative(Dictionary const& dict, std::string const& key); ///< Finite and zero or more.

[[nodiscard]] Vector readVector(Dictionary const& dict, std::string const& key); ///< Finite.
[[nodiscard]] Vector readVectorOr(Dictionary const& dict, std::string const& key, Vector const& fallback);

/// Unit vector; refuses one without length.
[[nodiscard]] Vector readDirection(Dictionary const& dict, std::string const& key);

/// Rotation matrix (nine numbers, row by row, as sixDoFRigidBodyMotion's `orientation`); identity where the keyword is absent.
/// Refuses a matrix that is no rotation (tolerance 1e-5).
[[nodiscard]] Quaternion readOrientation(Dictionary const& dict, std::string const& key);

} // namespace mpsDem
