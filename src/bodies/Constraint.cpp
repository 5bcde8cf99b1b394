#include "bodies/Constraint.h"

#include "bodies/Entries.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

class LineConstraint : public Constraint
{
public:
    explicit LineConstraint(Vector const& direction) : direction_(direction) {}
    Tensor freeTranslations() const override { return direction_ * direction_.transpose(); }

private:
    Vector direction_;
};

class PlaneConstraint : public Constraint
{
public:
    explicit PlaneConstraint(Vector const& normal) : normal_(normal) {}
    Tensor freeTranslations() const override { return Tensor::Identity() - normal_ * normal_.transpose(); }

private:
    Vector normal_;
};

class PointConstraint : public Constraint
{
public:
    Tensor freeTranslations() const override { return Tensor::Zero(); }
};

class AxisConstraint : public Constraint
{
public:
    explicit AxisConstraint(Vector const& axis) : axis_(axis) {}
    Tensor freeRotations() const override { return axis_ * axis_.transpose(); }

private:
    Vector axis_;
};

class OrientationConstraint : public Constraint
{
public:
    Tensor freeRotations() const override { return Tensor::Zero(); }
};

using Made = std::unique_ptr<Constraint>;

ConstraintRegistry builtInConstraints()
{
    ConstraintRegistry all("constraint", "constraints");
    all.add("line", [](std::string const&, Dictionary const& dict) -> Made {
        return std::make_unique<LineConstraint>(readDirection(dict, "direction"));
    });
    all.add("plane", [](std::string const&, Dictionary const& dict) -> Made {
        return std::make_unique<PlaneConstraint>(readDirection(dict, "normal"));
    });
    all.add("point", [](std::string const&, Dictionary const&) -> Made { return std::make_unique<PointConstraint>(); });
    all.add("axis", [](std::string const&, Dictionary const& dict) -> Made {
        return std::make_unique<AxisConstraint>(readDirection(dict, "axis"));
    });
    all.add("orientation", [](std::string const&, Dictionary const&) -> Made { return std::make_unique<OrientationConstraint>(); });
    return all;
}

} // namespace

void Constraint::setCentreOfRotation(Vector const& centre, Location const& where)
{
    centreOfRotation_ = centre;
    where_ = where;
}

void Constraint::requireCentre(Vector const& centreOfMass) const
{
    if (!centreOfRotation_) return;
    Real const scale = 1 + centreOfMass.norm();
    require((*centreOfRotation_ - centreOfMass).norm() <= 1e-6 * scale, where_, "centreOfRotation is not the body's centre of mass",
            "the centre of mass, or leave the entry out: bodies turn about their centre of mass");
}

ConstraintRegistry& constraintRegistry()
{
    static ConstraintRegistry registry = builtInConstraints();
    return registry;
}

std::unique_ptr<Constraint> makeConstraint(std::string const& name, Dictionary const& dict)
{
    std::string const keyword = "sixDoFRigidBodyMotionConstraint";
    auto constraint = constraintRegistry().make(dict.get<std::string>(keyword), dict.where(keyword), name, dict);
    if (dict.found("centreOfRotation"))
        constraint->setCentreOfRotation(dict.get<Vector>("centreOfRotation"), dict.where("centreOfRotation"));
    return constraint;
}

Tensor commonProjection(Tensor const& a, Tensor const& b)
{
    Real constexpr small = 1e-8; // a blocked direction this short is round-off of one that is already blocked
    Tensor const blockedBy[2] = {Tensor::Identity() - a, Tensor::Identity() - b};
    Tensor common = Tensor::Identity();
    for (Tensor const& blocked : blockedBy)
        for (int column = 0; column < 3; ++column)
        {
            Vector rest = common * blocked.col(column);
            rest = common * rest;
            if (rest.norm() < small) continue;
            rest.normalize();
            common -= rest * rest.transpose();
        }
    return common;
}

} // namespace mpsDem
