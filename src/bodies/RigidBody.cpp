#include "bodies/RigidBody.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/Errors.h"

namespace mpsDem {

RigidBody::RigidBody(std::string name, MassProperties const& mass, Vector const& centre, Quaternion const& orientation)
    : name_(std::move(name)),
      mass_(mass),
      inverseInertia_(mass.inertia.inverse()),
      centre_(centre),
      orientation_(orientation.normalized()),
      rotation_(orientation_.toRotationMatrix()),
      releaseTime_(-std::numeric_limits<Real>::infinity())
{
    require(std::isfinite(mass_.mass) && mass_.mass > 0, {}, "mass of body \"" + name_ + "\" is " + shortNumber(mass_.mass) + " kg",
            "a positive number");
    bool const positive = mass_.inertia.allFinite() && Eigen::LLT<Tensor>(mass_.inertia).info() == Eigen::Success;
    require(positive, {}, "moment of inertia of body \"" + name_ + "\" is not positive", "three positive principal moments");
}

Tensor RigidBody::inertia() const { return rotation_ * mass_.inertia * rotation_.transpose(); }

Matrix6 RigidBody::massMatrix() const
{
    Matrix6 matrix = Matrix6::Zero();
    matrix.topLeftCorner<3, 3>() = mass_.mass * Tensor::Identity();
    matrix.bottomRightCorner<3, 3>() = inertia();
    return matrix;
}

void RigidBody::setAddedMass(Matrix6 const& addedMass, Vector6 const& assumedAcceleration)
{
    Matrix6 const total = massMatrix() + (addedMass + addedMass.transpose()) / 2;
    if (Eigen::LLT<Matrix6>(total).info() != Eigen::Success)
        throw CaseError(ExitCode::Solver, "mass with added mass of body \"" + name_ + "\" is not positive definite",
                        "a finer particle spacing, or weak coupling for a heavy body");
    addedMass_ = addedMass;
    assumedAcceleration_ = assumedAcceleration;
}

void RigidBody::addCollisions(Load const& impulse, Real amount, Real rate)
{
    Real const before = collisions_.force.norm();
    if (amount + before > 0) collisionRate_ = (before * collisionRate_ + amount * rate) / (before + amount);
    collisions_ += impulse;
}

Load RigidBody::handOverCollisions(Real dt)
{
    Real const share = std::min(Real(1), dt * collisionRate_);
    Load const mean = share / dt * collisions_;
    collisions_ = (1 - share) * collisions_;
    return mean;
}

Vector RigidBody::accelerationAt(Vector const& r) const
{
    Vector const arm = r - centre_;
    return acceleration_ + angularAcceleration_.cross(arm) + angularVelocity_.cross(angularVelocity_.cross(arm));
}

Real RigidBody::kineticEnergy() const
{
    return (mass_.mass * velocity_.squaredNorm() + angularVelocity_.dot(inertia() * angularVelocity_)) / 2;
}

void RigidBody::setVelocity(Vector const& velocity, Vector const& angularVelocity)
{
    (released_ ? velocity_ : releaseVelocity_) = velocity;
    (released_ ? angularVelocity_ : releaseAngularVelocity_) = angularVelocity;
    dropBlockedVelocity();
}

void RigidBody::setReleaseTime(Real time)
{
    releaseTime_ = time;
    if (!released_) return;
    released_ = false;
    std::swap(velocity_, releaseVelocity_);
    std::swap(angularVelocity_, releaseAngularVelocity_);
}

void RigidBody::takeUpReleaseVelocity()
{
    released_ = true;
    velocity_ = releaseVelocity_;
    angularVelocity_ = releaseAngularVelocity_;
    sums_.reaction += {mass_.mass * velocity_, inertia() * angularVelocity_};
}

void RigidBody::addConstraint(std::unique_ptr<Constraint> constraint)
{
    constraint->requireCentre(centre_);
    constraints_.push_back(std::move(constraint));
    updateProjection();
}

void RigidBody::addRestraint(std::unique_ptr<Restraint> restraint)
{
    restraint->attach(*this);
    restraints_.push_back(std::move(restraint));
}

void RigidBody::setPrescribedMotion(std::unique_ptr<PrescribedMotion> motion, Real time)
{
    require(!planar_ || !motion->leavesPlane(), {}, "prescribed motion of the 2-D body \"" + name_ + "\" leaves the x-y plane",
            "translations in x and y, rotations about z");
    motion_ = std::move(motion);
    motionCentre_ = centre_;
    motionOrientation_ = orientation_;
    place(motion_->at(motionTime(time), motionCentre_, motionOrientation_));
    if (held(time)) velocity_ = angularVelocity_ = Vector::Zero();
}

void RigidBody::restrictTo2D()
{
    bool const turnedAboutZ = std::max(std::abs(orientation_.x()), std::abs(orientation_.y())) < 1e-9;
    require(turnedAboutZ, {}, "orientation of the 2-D body \"" + name_ + "\" leaves the x-y plane", "a turn about z");
    orientation_ = Quaternion(orientation_.w(), 0, 0, orientation_.z()).normalized();
    rotation_ = orientation_.toRotationMatrix();
    centre_.z() = 0;
    planar_ = true;
    updateProjection();
}

void RigidBody::updateProjection()
{
    freeTranslations_ = freeRotations_ = Tensor::Identity();
    if (planar_)
    {
        freeTranslations_ = Vector(1, 1, 0).asDiagonal();
        freeRotations_ = Vector(0, 0, 1).asDiagonal();
    }
    for (auto const& constraint : constraints_)
    {
        freeTranslations_ = commonProjection(freeTranslations_, constraint->freeTranslations());
        freeRotations_ = commonProjection(freeRotations_, constraint->freeRotations());
    }
    translations_ = static_cast<int>(std::lround(freeTranslations_.trace()));
    rotations_ = static_cast<int>(std::lround(freeRotations_.trace()));
    dropBlockedVelocity();
}

void RigidBody::dropBlockedVelocity()
{
    velocity_ = freeTranslations_ * velocity_;
    releaseVelocity_ = freeTranslations_ * releaseVelocity_;
    angularVelocity_ = freeRotations_ * angularVelocity_;
    releaseAngularVelocity_ = freeRotations_ * releaseAngularVelocity_;
}

int RigidBody::freeDirections() const { return locked_ || motion_ ? 0 : translations_ + rotations_; }

Matrix6 RigidBody::freeProjection() const
{
    Matrix6 projection = Matrix6::Zero();
    if (locked_ || motion_) return projection;
    projection.topLeftCorner<3, 3>() = freeTranslations_;
    projection.bottomRightCorner<3, 3>() = freeRotations_;
    return projection;
}

bool RigidBody::held(Real time) const
{
    Real const roundOff = 1e-9 * std::max(1.0, std::abs(time)); // of a time summed up from many sub-steps
    return locked_ || (!released_ && time < releaseTime_ - roundOff);
}

bool RigidBody::still(Real time) const { return held(time) || (!motion_ && freeDirections() == 0); }

Vector RigidBody::lock()
{
    Vector const lost = mass_.mass * velocity_;
    sums_.reaction += {-lost, -(inertia() * angularVelocity_)};
    velocity_ = angularVelocity_ = acceleration_ = angularAcceleration_ = Vector::Zero();
    releaseVelocity_ = releaseAngularVelocity_ = Vector::Zero();
    locked_ = true;
    return lost;
}

} // namespace mpsDem
