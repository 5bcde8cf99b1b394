#pragma once

#include <memory>
#include <string>

#include "bodies/Load.h"
#include "core/Dictionary.h"
#include "core/Registry.h"

namespace mpsDem {

class RigidBody;

/// A spring or damper between a rigid body and the ground. Names and keys as OpenFOAM's sixDoFRigidBodyMotionRestraints.
///
/// | sixDoFRigidBodyMotionRestraint | key                  | meaning                                          | unit     | default |
/// |--------------------------------|----------------------|--------------------------------------------------|----------|---------|
/// | linearSpring                   | anchor               | fixed end                                        | m        | none    |
/// |                                | refAttachmentPt      | end on the body, given for its initial pose      | m        | none    |
/// |                                | stiffness            | k, 0 or more                                     | N/m      | none    |
/// |                                | damping              | c, 0 or more                                     | N s/m    | none    |
/// |                                | restLength           | l0, 0 or more                                    | m        | none    |
/// | linearDamper                   | coeff                | F = -coeff V                                     | N s/m    | none    |
/// | sphericalAngularDamper         | coeff                | M = -coeff omega                                 | N m s    | none    |
/// | linearAxialAngularSpring       | axis                 | a, global axes                                   | -        | none    |
/// |                                | stiffness            | k, 0 or more                                     | N m/rad  | none    |
/// |                                | damping              | c, 0 or more                                     | N m s/rad | none   |
/// |                                | referenceOrientation | pose in which the spring is at rest, as `orientation` | -   | (1 0 0 0 1 0 0 0 1) |
///
/// @code
/// mooring { sixDoFRigidBodyMotionRestraint linearSpring; anchor (0 0 0); refAttachmentPt (0.5 0 0);
///           stiffness 200; damping 5; restLength 0.4; }
/// @endcode
class Restraint
{
public:
    virtual ~Restraint() = default;

    /// Called once, with the body in its initial pose.
    virtual void attach(RigidBody const&) {}

    /// Load on the body in its present pose and motion, moment about the centre of mass.
    [[nodiscard]] virtual Load load(RigidBody const& body) const = 0;
};

using RestraintRegistry = Registry<Restraint, std::string const&, Dictionary const&>;

/// All restraints known; add own ones here before a case is read.
RestraintRegistry& restraintRegistry();

/// The restraint that the dictionary's `sixDoFRigidBodyMotionRestraint` names.
/// @throw CaseError BadInput for an unknown word (with the known ones) or a number out of its range.
std::unique_ptr<Restraint> makeRestraint(std::string const& name, Dictionary const& dict);

} // namespace mpsDem
