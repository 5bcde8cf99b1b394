#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/Dictionary.h"
#include "core/Registry.h"
#include "core/Types.h"

namespace mpsDem {

/// Takes directions of motion from a rigid body. Names and keys as OpenFOAM's sixDoFRigidBodyMotionConstraints.
///
/// | sixDoFRigidBodyMotionConstraint | key                | meaning                                       | unit | default |
/// |---------------------------------|--------------------|-----------------------------------------------|------|---------|
/// | line                            | direction          | translation only along it                     | -    | none    |
/// | plane                           | normal             | translation only across it                    | -    | none    |
/// | point                           |                    | no translation                                | -    |         |
/// | axis                            | axis               | rotation only about it                        | -    | none    |
/// | orientation                     |                    | no rotation                                   | -    |         |
/// | any of them                     | centreOfRotation   | must be the centre of mass: others are refused | m    | centre of mass |
///
/// @code
/// slope { sixDoFRigidBodyMotionConstraint line; direction (1 -1 0); }
/// @endcode
class Constraint
{
public:
    virtual ~Constraint() = default;

    /// Projection (symmetric, idempotent) on the translations that stay free, global axes.
    [[nodiscard]] virtual Tensor freeTranslations() const { return Tensor::Identity(); }
    /// Projection on the angular velocities that stay free, global axes.
    [[nodiscard]] virtual Tensor freeRotations() const { return Tensor::Identity(); }

    /// Says about which point the constraint was meant; without it, the centre of mass.
    void setCentreOfRotation(Vector const& centre, Location const& where);
    /// @throw CaseError BadInput where the centre of rotation is another point than the centre of mass.
    void requireCentre(Vector const& centreOfMass) const;

private:
    std::optional<Vector> centreOfRotation_;
    Location where_;
};

using ConstraintRegistry = Registry<Constraint, std::string const&, Dictionary const&>;

/// All constraints known; add own ones here before a case is read.
ConstraintRegistry& constraintRegistry();

/// The constraint that the dictionary's `sixDoFRigidBodyMotionConstraint` names.
/// @param name Name of the entry, for messages.
/// @throw CaseError BadInput for an unknown word (with the known ones) or a direction of zero length.
std::unique_ptr<Constraint> makeConstraint(std::string const& name, Dictionary const& dict);

/// Projection on the common part of two spaces of free directions, each given by its projection.
///
/// The blocked directions, columns of (1 - a) and (1 - b), are made orthonormal one after the other; what is left is free.
/// A direction that is blocked along an axis of coordinates stays exactly (bitwise) blocked.
[[nodiscard]] Tensor commonProjection(Tensor const& a, Tensor const& b);

} // namespace mpsDem
