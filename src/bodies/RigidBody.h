#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "bodies/Constraint.h"
#include "bodies/Load.h"
#include "bodies/MassProperties.h"
#include "bodies/PrescribedMotion.h"
#include "bodies/Restraint.h"
#include "core/State.h"
#include "core/Types.h"

namespace mpsDem {

/// One rigid body: mass properties, pose, velocity, loads, eq 13 and eq 14. It knows neither fluid nor contact.
class RigidBody
{
public:
    RigidBody(std::string name, MassProperties const& mass, Vector const& centre, Quaternion const& orientation);

    [[nodiscard]] std::string const& name() const { return name_; }
    [[nodiscard]] Real mass() const { return mass_.mass; }
    [[nodiscard]] MassProperties const& massProperties() const { return mass_; }
    [[nodiscard]] Tensor inertia() const; ///< About the centre of mass, global axes [kg m2].

    [[nodiscard]] Vector const& centre() const { return centre_; }
    [[nodiscard]] Quaternion const& orientation() const { return orientation_; }
    [[nodiscard]] Tensor const& rotation() const { return rotation_; } ///< Matrix of the orientation.
    [[nodiscard]] Vector const& velocity() const { return velocity_; }
    [[nodiscard]] Vector const& angularVelocity() const { return angularVelocity_; }
    /// Mean acceleration of the last finished fluid step [m/s2], [rad/s2]: what wall particles of the body are accelerated with.
    [[nodiscard]] Vector const& acceleration() const { return acceleration_; }
    [[nodiscard]] Vector const& angularAcceleration() const { return angularAcceleration_; }

    /// Sets the motion, without its part against constraints. A body with a release time takes it up at its release.
    void setVelocity(Vector const& velocity, Vector const& angularVelocity);

    /// Position in space of a point given in body axes from the centre of mass.
    [[nodiscard]] Vector toSpace(Vector const& local) const { return centre_ + rotation_ * local; }
    /// Velocity of the material point that is now at r [m/s].
    [[nodiscard]] Vector velocityAt(Vector const& r) const { return velocity_ + angularVelocity_.cross(r - centre_); }
    /// Acceleration of the material point at r for the body's stored accelerations, centripetal part included [m/s2].
    [[nodiscard]] Vector accelerationAt(Vector const& r) const;

    // Loads, each set by its owner. Contact ones are reset by whoever adds to them, every sub-step.
    Load fluid;             ///< Eqs 15-16, constant during a fluid step.
    Load contactNormal;     ///< Normal part of eq 11 of this sub-step.
    Load contactTangential; ///< Eq 12 of this sub-step.

    /// Takes over the impulse of fluid particles that struck it. A particle gives up its momentum while it passes its own size, so the
    /// impulse acts as a force that fades with `rate`, the mean of speed over size weighted with the sizes of the impulses.
    /// @param impulse [N s], [N m s] about the centre. @param amount  Sum of the single impulses' sizes [N s]. @param rate [1/s].
    void addCollisions(Load const& impulse, Real amount, Real rate);
    /// The mean force of such impulses over the next dt [s]: they are handed over by this.
    Load handOverCollisions(Real dt);
    /// m v and what of these impulses is still to come [N s].
    [[nodiscard]] Vector momentum() const { return mass_.mass * velocity_ + collisions_.force; }

    /// Acceleration by gravity [m/s2]; zero until set.
    void setGravity(Vector const& g) { gravity_ = g; }
    [[nodiscard]] Load gravityLoad() const { return {mass_.mass * gravity_, Vector::Zero()}; }

    /// Added mass of strong coupling: (M + Ma) a = F + Ma a*. Zero matrices mean weak coupling.
    void setAddedMass(Matrix6 const& addedMass, Vector6 const& assumedAcceleration);
    /// Mass matrix M in global axes, 6 x 6.
    [[nodiscard]] Matrix6 massMatrix() const;

    /// Removes directions of motion for good. @throw CaseError BadInput for a centre of rotation other than the centre of mass.
    void addConstraint(std::unique_ptr<Constraint> constraint);
    /// Adds a spring or damper. The body must be in its initial pose.
    void addRestraint(std::unique_ptr<Restraint> restraint);
    /// Makes the body follow a motion; the present pose is that without displacement. Takes pose and velocity of `time`.
    /// @throw CaseError BadInput where the motion leaves the x-y plane of a 2-D body.
    void setPrescribedMotion(std::unique_ptr<PrescribedMotion> motion, Real time = 0);
    /// Locks translation along z and rotation about x and y exactly (they stay bitwise zero).
    /// @throw CaseError BadInput for an orientation that is not a turn about z.
    void restrictTo2D();
    /// Held still before this time [s]; a velocity set before is taken up then, at the first sub-step that begins at it or later.
    void setReleaseTime(Real time);
    /// Holds the body for good where it is (latch), with the mean acceleration zero from this step on. Between beginStep and endStep,
    /// the impulse counts into the mean reaction. @return momentum that it lost, m V [kg m/s].
    Vector lock();
    [[nodiscard]] bool locked() const { return locked_; }
    /// True while nothing can move the body: locked, before its release, or without a free direction and no prescribed motion.
    [[nodiscard]] bool still(Real time) const;

    /// Begins a fluid step: clears the sums over its sub-steps.
    void beginStep();
    /// One sub-step of length h from `time`: semi-implicit Euler with eqs 13-14, gyroscopic term by one Newton iteration,
    /// constraints as projections, q' = q exp(h omega / 2).
    void advance(Real time, Real h);
    /// Ends a fluid step of length dt: mean loads and accelerations; renormalises the quaternion.
    void endStep(Real dt);

    // Means over the last fluid step, for output.
    [[nodiscard]] Load const& meanContactNormal() const { return meanContactNormal_; }
    [[nodiscard]] Load const& meanContactTangential() const { return meanContactTangential_; }
    [[nodiscard]] Load const& meanRestraint() const { return meanRestraint_; }
    /// What constraints, release time, latch or prescribed motion had to add so that the body moved as it did.
    [[nodiscard]] Load const& meanReaction() const { return meanReaction_; }

    /// m V^2/2 + omega . I omega/2 [J].
    [[nodiscard]] Real kineticEnergy() const;

    /// Number of free directions of translation and rotation (6 at most; 3 in 2-D; 0 when locked or under prescribed motion).
    [[nodiscard]] int freeDirections() const;
    /// Projection (6 x 6) on the free directions, global axes; zero when locked or under prescribed motion.
    [[nodiscard]] Matrix6 freeProjection() const;

    /// Blocks "body/<name>/...". Mass, inertia ("massProperties") and "referenceCentre" are those of the dictionary: saved to be compared,
    /// never loaded.
    void save(State& state) const;
    void load(State const& state);

    /// What a fluid step changes: pose; motion; added mass; loads and their means; release and latch. For a step that is taken again.
    using Snapshot = std::tuple<Vector, Quaternion, Tensor, Vector, Vector, Vector, Vector, Matrix6, Vector6, Load, Load, Load, Load, Load,
                                Load, Load, Load, Real, bool, Vector, Vector, bool>;
    [[nodiscard]] Snapshot snapshot() const;
    void restore(Snapshot const& snapshot);

    /// Whether its motion shall be told in the log (keyword `report`).
    [[nodiscard]] bool report() const { return report_; }
    void setReport(bool report) { report_ = report; }

private:
    /// References to all that a snapshot holds.
    template <class Body>
    static auto changing(Body& body);

    [[nodiscard]] bool held(Real time) const;
    [[nodiscard]] Load restraintLoad() const;
    [[nodiscard]] Real motionTime(Real time) const;

    /// The three ways to take one sub-step. @return force and moment that kept the body on its way.
    Vector6 stayHeld(Vector6 const& applied);
    Vector6 followMotion(Vector6 const& applied, Real time, Real h);
    Vector6 moveFreely(Vector6 const& applied, Real h);

    void takeUpReleaseVelocity();
    void drift(Real h);
    void turn(Vector const& angle);
    void place(RigidMotion const& motion);
    void updateProjection();
    void dropBlockedVelocity();

    /// Sums over the sub-steps of a fluid step, each times h.
    struct StepSums
    {
        Load contactNormal, contactTangential, restraint, reaction;
        Vector velocity = Vector::Zero();        ///< Change of velocity.
        Vector angularVelocity = Vector::Zero(); ///< Change of angular velocity.
    };

    std::string name_;
    MassProperties mass_;
    Tensor inverseInertia_; ///< Body axes.
    Vector centre_, velocity_ = Vector::Zero(), angularVelocity_ = Vector::Zero();
    Vector acceleration_ = Vector::Zero(), angularAcceleration_ = Vector::Zero();
    Quaternion orientation_;
    Tensor rotation_;
    Vector gravity_ = Vector::Zero();
    Load collisions_;        ///< Impulse of struck particles that is still to be handed over.
    Real collisionRate_ = 0; ///< [1/s].

    Matrix6 addedMass_ = Matrix6::Zero();
    Vector6 assumedAcceleration_ = Vector6::Zero();

    std::vector<std::unique_ptr<Constraint>> constraints_;
    std::vector<std::unique_ptr<Restraint>> restraints_;
    Tensor freeTranslations_ = Tensor::Identity(); ///< Projections of all constraints together.
    Tensor freeRotations_ = Tensor::Identity();
    int translations_ = 3; ///< Their ranks.
    int rotations_ = 3;
    bool planar_ = false;

    std::unique_ptr<PrescribedMotion> motion_;
    Vector motionCentre_ = Vector::Zero(); ///< Pose without displacement.
    Quaternion motionOrientation_ = Quaternion::Identity();

    Real releaseTime_;
    bool released_ = true;
    Vector releaseVelocity_ = Vector::Zero(), releaseAngularVelocity_ = Vector::Zero();
    bool locked_ = false;
    bool report_ = false;

    StepSums sums_;
    Load meanContactNormal_, meanContactTangential_, meanRestraint_, meanReaction_;
};

} // namespace mpsDem
