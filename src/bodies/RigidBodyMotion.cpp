#include "bodies/RigidBody.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "bodies/Orientation.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

Vector6 stacked(Vector const& first, Vector const& second)
{
    Vector6 both;
    both << first, second;
    return both;
}

} // namespace

void RigidBody::beginStep() { sums_ = {}; }

void RigidBody::advance(Real time, Real h)
{
    Load const restraint = restraintLoad();
    Load const all = gravityLoad() + fluid + contactNormal + contactTangential + restraint;
    Vector6 const applied = stacked(all.force, all.moment);

    bool const stays = held(time);
    if (!stays && !released_ && !motion_) takeUpReleaseVelocity();
    Vector6 const reaction = stays ? stayHeld(applied) : motion_ ? followMotion(applied, time, h) : moveFreely(applied, h);

    sums_.contactNormal += h * contactNormal;
    sums_.contactTangential += h * contactTangential;
    sums_.restraint += h * restraint;
    sums_.reaction += h * Load{reaction.head<3>(), reaction.tail<3>()};
}

void RigidBody::endStep(Real dt)
{
    expect(dt > 0, "a fluid step has a length");
    meanContactNormal_ = 1 / dt * sums_.contactNormal;
    meanContactTangential_ = 1 / dt * sums_.contactTangential;
    meanRestraint_ = 1 / dt * sums_.restraint;
    meanReaction_ = 1 / dt * sums_.reaction;
    acceleration_ = locked_ ? Vector(Vector::Zero()) : Vector(sums_.velocity / dt);
    angularAcceleration_ = locked_ ? Vector(Vector::Zero()) : Vector(sums_.angularVelocity / dt);
    if (std::abs(orientation_.squaredNorm() - 1) < 1e-15) return; // a body at rest keeps its pose bitwise
    orientation_.normalize();
    rotation_ = orientation_.toRotationMatrix();
}

Load RigidBody::restraintLoad() const
{
    Load sum;
    for (auto const& restraint : restraints_) sum += restraint->load(*this);
    return sum;
}

/// Without acceleration the fluid's load is F + Ma a*, and the reaction its opposite.
Vector6 RigidBody::stayHeld(Vector6 const& applied) { return -(applied + addedMass_ * assumedAcceleration_); }

/// Eqs 13-14 with added mass, in the free directions P: (P (M + Ma) P + 1 - P) a = P (F + Ma a*).
///
/// With all rotations free, the gyroscopic term is left to drift(), and Ma acts on its acceleration as on the rest of a. Else, as
/// with one free axis, along which that term has no component, it is taken at the begin and adds to the reaction.
Vector6 RigidBody::moveFreely(Vector6 const& applied, Real h)
{
    Vector const gyroscopic = angularVelocity_.cross(inertia() * angularVelocity_);
    Vector6 force = applied + addedMass_ * assumedAcceleration_;
    if (rotations_ == 3)
        force += addedMass_.rightCols<3>() * (rotation_ * (inverseInertia_ * (rotation_.transpose() * gyroscopic)));
    else
        force.tail<3>() -= gyroscopic;

    Matrix6 const projection = freeProjection();
    Matrix6 const blocked = Matrix6::Identity() - projection;
    Matrix6 const mass = massMatrix() + addedMass_;
    Matrix6 const system = projection * mass * projection + blocked;
    Vector6 const a = projection * system.partialPivLu().solve(projection * force);

    Vector const before = angularVelocity_;
    velocity_ += h * a.head<3>();
    angularVelocity_ += h * a.tail<3>();
    drift(h);
    sums_.velocity += h * a.head<3>();
    sums_.angularVelocity += angularVelocity_ - before;
    return blocked * (mass * a - force);
}

/// Moves the pose by the velocities; where all rotations are free, as a body on which no moment acts: momentum kept to round-off.
void RigidBody::drift(Real h)
{
    centre_ += h * velocity_;
    if (rotations_ < 3)
    {
        turn(h * angularVelocity_);
        return;
    }
    Vector const rate = rotation_.transpose() * angularVelocity_; // body axes
    Vector const momentum = rotation_ * (mass_.inertia * rate);
    turn(h * (rotation_ * freeAngularVelocity(mass_.inertia, mass_.inertia * rate, h)));
    angularVelocity_ = rotation_ * (inverseInertia_ * (rotation_.transpose() * momentum));
}

/// q' = exp(angle / 2) q with the angle in global axes; the same as q exp(angle / 2) with the angle in body axes.
void RigidBody::turn(Vector const& angle)
{
    orientation_ = rotationBy(angle) * orientation_;
    rotation_ = orientation_.toRotationMatrix();
}

Real RigidBody::motionTime(Real time) const
{
    if (!std::isfinite(releaseTime_)) return time;
    return std::max(0.0, time - releaseTime_);
}

/// The reaction is what is missing to the change of momentum, eqs 13-14 read backwards.
Vector6 RigidBody::followMotion(Vector6 const& applied, Real time, Real h)
{
    released_ = true;
    place(motion_->at(motionTime(time), motionCentre_, motionOrientation_));
    Vector const velocity = velocity_;
    Vector const angularVelocity = angularVelocity_;
    Vector const angularMomentum = inertia() * angularVelocity_;
    place(motion_->at(motionTime(time + h), motionCentre_, motionOrientation_));

    Vector const velocityChange = velocity_ - velocity;
    Vector const angularChange = angularVelocity_ - angularVelocity;
    sums_.velocity += velocityChange;
    sums_.angularVelocity += angularChange;
    Vector6 const momentumChange = stacked(mass_.mass * velocityChange, inertia() * angularVelocity_ - angularMomentum);
    Vector6 const acceleration = stacked(velocityChange, angularChange) / h;
    return momentumChange / h + addedMass_ * (acceleration - assumedAcceleration_) - applied;
}

void RigidBody::place(RigidMotion const& motion)
{
    centre_ = motion.centre;
    orientation_ = motion.orientation.normalized();
    rotation_ = orientation_.toRotationMatrix();
    velocity_ = motion.velocity;
    angularVelocity_ = motion.angularVelocity;
    if (!planar_) return;
    Vector const& w = angularVelocity_;
    bool const inPlane =
        centre_.z() == 0 && velocity_.z() == 0 && w.x() == 0 && w.y() == 0 && orientation_.x() == 0 && orientation_.y() == 0;
    require(inPlane, {}, "prescribed motion of the 2-D body \"" + name_ + "\" leaves the x-y plane",
            "translations in x and y, rotations about z");
}

} // namespace mpsDem
