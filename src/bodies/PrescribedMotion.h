#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Registry.h"
#include "core/Types.h"

namespace mpsDem {

/// Pose and motion of a rigid body at one time.
struct RigidMotion
{
    Vector centre = Vector::Zero();                  ///< Centre of mass [m].
    Quaternion orientation = Quaternion::Identity(); ///< Body axes to space.
    Vector velocity = Vector::Zero();                ///< Of the centre of mass [m/s].
    Vector angularVelocity = Vector::Zero();         ///< Global axes [rad/s].
};

/// Motion that a body follows whatever acts on it. Names and keys as OpenFOAM's solidBodyMotionFunctions.
///
/// The time t counts from the body's release time (from 0 s without one), so that a released body begins at the begin of its motion.
///
/// | solidBodyMotionFunction | key                 | meaning                                                    | unit  | default        |
/// |-------------------------|---------------------|------------------------------------------------------------|-------|----------------|
/// | linearMotion            | velocity            | V                                                          | m/s   | none           |
/// | oscillatingLinearMotion | amplitude           | x = A sin(omega t)                                         | m     | none           |
/// |                         | omega               | omega                                                      | rad/s | none           |
/// | rotatingMotion          | origin              | a point of the axis                                        | m     | none           |
/// |                         | axis                | direction of the axis                                      | -     | none           |
/// |                         | omega               | angular velocity                                           | rad/s | none           |
/// | tabulated6DoFMotion     | times               | rising, two or more                                         | s     | none           |
/// |                         | translations        | list of (x y z), one a time                                 | m     | zero           |
/// |                         | rotations           | list of (rx ry rz), one a time; x first, then turned y, z   | degree | zero          |
/// |                         | CofG                | point about which the angles turn                          | m     | centre of mass |
/// |                         | interpolationScheme | linear or spline (velocity continuous, exact for parabolas) | -     | spline         |
///
/// @code
/// prescribedMotion { solidBodyMotionFunction linearMotion; velocity (0.5 -0.5 0); }
/// @endcode
class PrescribedMotion
{
public:
    virtual ~PrescribedMotion() = default;

    /// Pose and motion at time t of a body whose centre and orientation are the given ones where the motion has no displacement.
    [[nodiscard]] virtual RigidMotion at(Real t, Vector const& centre, Quaternion const& orientation) const = 0;

    /// True where the motion can tell that it leaves the x-y plane at some time, though not at its begin: asked once, for bodies in 2-D.
    [[nodiscard]] virtual bool leavesPlane() const { return false; }
};

using PrescribedMotionRegistry = Registry<PrescribedMotion, Dictionary const&>;

/// All motions known; add own ones here before a case is read.
PrescribedMotionRegistry& prescribedMotionRegistry();

/// The motion that the dictionary's `solidBodyMotionFunction` names; its keys stand beside that word.
/// @throw CaseError BadInput for an unknown word (with the known ones) or a bad entry.
std::unique_ptr<PrescribedMotion> makePrescribedMotion(Dictionary const& dict);

} // namespace mpsDem
