#include "bodies/Restraint.h"

#include <cmath>
#include <numbers>

#include "bodies/Entries.h"
#include "bodies/RigidBody.h"

namespace mpsDem {

namespace {

/// F = -(k (|r| - l0) + c v.e) e, with r from the anchor to the attachment, e = r / |r|, v the attachment's velocity.
class LinearSpring : public Restraint
{
public:
    explicit LinearSpring(Dictionary const& dict)
        : anchor_(readVector(dict, "anchor")),
          attachment_(readVector(dict, "refAttachmentPt")),
          stiffness_(readNotNegative(dict, "stiffness")),
          damping_(readNotNegative(dict, "damping")),
          restLength_(readNotNegative(dict, "restLength"))
    {}

    void attach(RigidBody const& body) override { local_ = body.rotation().transpose() * (attachment_ - body.centre()); }

    Load load(RigidBody const& body) const override
    {
        Vector const point = body.toSpace(local_);
        Vector const r = point - anchor_;
        Real const length = r.norm();
        Load result;
        if (length <= tiny) return result; // direction unknown: no force
        Vector const e = r / length;
        Real const tension = stiffness_ * (length - restLength_) + damping_ * body.velocityAt(point).dot(e);
        result.add(-tension * e, point - body.centre());
        return result;
    }

private:
    Vector anchor_;
    Vector attachment_;
    Vector local_ = Vector::Zero();
    Real stiffness_;
    Real damping_;
    Real restLength_;
};

class LinearDamper : public Restraint
{
public:
    explicit LinearDamper(Dictionary const& dict) : coefficient_(readNotNegative(dict, "coeff")) {}
    Load load(RigidBody const& body) const override { return {-coefficient_ * body.velocity(), Vector::Zero()}; }

private:
    Real coefficient_;
};

class SphericalAngularDamper : public Restraint
{
public:
    explicit SphericalAngularDamper(Dictionary const& dict) : coefficient_(readNotNegative(dict, "coeff")) {}
    Load load(RigidBody const& body) const override { return {Vector::Zero(), -coefficient_ * body.angularVelocity()}; }

private:
    Real coefficient_;
};

/// M = -(k theta + c omega.a) a, with theta in (-pi, pi] the twist about a from the pose at rest.
class LinearAxialAngularSpring : public Restraint
{
public:
    explicit LinearAxialAngularSpring(Dictionary const& dict)
        : axis_(readDirection(dict, "axis")),
          stiffness_(readNotNegative(dict, "stiffness")),
          damping_(readNotNegative(dict, "damping")),
          rest_(readOrientation(dict, "referenceOrientation"))
    {}

    Load load(RigidBody const& body) const override
    {
        Quaternion const turned = body.orientation() * rest_.conjugate();
        Real twist = 2 * std::atan2(turned.vec().dot(axis_), turned.w());
        if (twist > std::numbers::pi) twist -= 2 * std::numbers::pi;
        if (twist <= -std::numbers::pi) twist += 2 * std::numbers::pi;
        return {Vector::Zero(), -(stiffness_ * twist + damping_ * body.angularVelocity().dot(axis_)) * axis_};
    }

private:
    Vector axis_;
    Real stiffness_;
    Real damping_;
    Quaternion rest_;
};

template <class T>
void addModel(RestraintRegistry& all, std::string const& name)
{
    all.add(name, [](std::string const&, Dictionary const& dict) -> std::unique_ptr<Restraint> { return std::make_unique<T>(dict); });
}

RestraintRegistry builtInRestraints()
{
    RestraintRegistry all("restraint", "restraints");
    addModel<LinearSpring>(all, "linearSpring");
    addModel<LinearDamper>(all, "linearDamper");
    addModel<SphericalAngularDamper>(all, "sphericalAngularDamper");
    addModel<LinearAxialAngularSpring>(all, "linearAxialAngularSpring");
    return all;
}

} // namespace

RestraintRegistry& restraintRegistry()
{
    static RestraintRegistry registry = builtInRestraints();
    return registry;
}

std::unique_ptr<Restraint> makeRestraint(std::string const& name, Dictionary const& dict)
{
    std::string const keyword = "sixDoFRigidBodyMotionRestraint";
    return restraintRegistry().make(dict.get<std::string>(keyword), dict.where(keyword), name, dict);
}

} // namespace mpsDem
