#pragma once

#include <memory>
#include <string>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"

namespace mpsDem {

/// Builds one rigid body from its entry in constant/rigidBodyProperties; keys as sixDoFRigidBodyMotion's.
///
/// The shape stands in the case where the body is at the start; `orientation` does not turn it, it only names the body axes
/// (those of `momentOfInertia` and `angularMomentum`). A point x of the shape is R^T (x - centreOfMass) in body axes.
///
/// | key              | meaning                                                            | unit     | default               |
/// |------------------|--------------------------------------------------------------------|----------|-----------------------|
/// | mass             | either this ...                                                    | kg       | none                  |
/// | density          | ... or this; needs a shape                                         | kg/m3    | none                  |
/// | centreOfMass     | at the start                                                       | m        | that of the shape     |
/// | momentOfInertia  | (Ixx Iyy Izz) about the centre of mass, body axes                  | kg m2    | that of the shape     |
/// | orientation      | body axes as columns of a rotation matrix, nine numbers row by row | -        | (1 0 0 0 1 0 0 0 1)   |
/// | velocity         | of the centre of mass at the start, or at the release              | m/s      | (0 0 0)               |
/// | angularVelocity  | the same for the rotation, global axes; or ...                     | rad/s    | (0 0 0)               |
/// | angularMomentum  | ... I omega in body axes                                           | kg m2/s  | (0 0 0)               |
/// | constraints      | dictionaries, see Constraint                                       |          | none                  |
/// | restraints       | dictionaries, see Restraint                                        |          | none                  |
/// | prescribedMotion | see PrescribedMotion; excludes constraints and velocities          |          | none                  |
/// | releaseTime      | held still before                                                  | s        | free from the start   |
/// | report           | tells its motion in the log                                        | -        | no                    |
///
/// @code
/// slide { mass 140; constraints { noTurn { sixDoFRigidBodyMotionConstraint orientation; } } releaseTime 0.1; }
/// @endcode
/// @param name       Name of the body.
/// @param dict       Its dictionary; keys of its shape and contacts are left to others.
/// @param fromShape  Properties of its shape in the axes of the case, for any density; volume 0 where there is no shape.
/// @param planar     2-D: restricts the body to the x-y plane.
/// @param time       Start time of the run [s], for the first pose of a prescribed motion.
/// @throw CaseError BadInput with the place of the entry and what is allowed.
std::unique_ptr<RigidBody> readRigidBody(std::string const& name, Dictionary const& dict, MassProperties const& fromShape, bool planar,
                                         Real time = 0);

} // namespace mpsDem
