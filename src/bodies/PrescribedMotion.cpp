#include "bodies/PrescribedMotion.h"

#include <cmath>

#include "bodies/Entries.h"
#include "bodies/Orientation.h"
#include "bodies/TabulatedMotion.h"

namespace mpsDem {

namespace {

class LinearMotion : public PrescribedMotion
{
public:
    explicit LinearMotion(Dictionary const& dict) : velocity_(readVector(dict, "velocity")) {}

    RigidMotion at(Real t, Vector const& centre, Quaternion const& orientation) const override
    {
        return {centre + t * velocity_, orientation, velocity_, Vector::Zero()};
    }

private:
    Vector velocity_;
};

class OscillatingLinearMotion : public PrescribedMotion
{
public:
    explicit OscillatingLinearMotion(Dictionary const& dict) : amplitude_(readVector(dict, "amplitude")), omega_(readNumber(dict, "omega"))
    {}

    RigidMotion at(Real t, Vector const& centre, Quaternion const& orientation) const override
    {
        return {centre + std::sin(omega_ * t) * amplitude_, orientation, omega_ * std::cos(omega_ * t) * amplitude_, Vector::Zero()};
    }

private:
    Vector amplitude_;
    Real omega_;
};

class RotatingMotion : public PrescribedMotion
{
public:
    explicit RotatingMotion(Dictionary const& dict)
        : origin_(readVector(dict, "origin")),
          angularVelocity_(readDirection(dict, "axis") * readNumber(dict, "omega"))
    {}

    RigidMotion at(Real t, Vector const& centre, Quaternion const& orientation) const override
    {
        Quaternion const turn = rotationBy(t * angularVelocity_);
        Vector const arm = turn * (centre - origin_);
        return {origin_ + arm, turn * orientation, angularVelocity_.cross(arm), angularVelocity_};
    }

private:
    Vector origin_;
    Vector angularVelocity_;
};

template <class T>
void addModel(PrescribedMotionRegistry& all, std::string const& name)
{
    all.add(name, [](Dictionary const& dict) -> std::unique_ptr<PrescribedMotion> { return std::make_unique<T>(dict); });
}

PrescribedMotionRegistry builtInMotions()
{
    PrescribedMotionRegistry all("solid body motion function", "solid body motion functions");
    addModel<LinearMotion>(all, "linearMotion");
    addModel<OscillatingLinearMotion>(all, "oscillatingLinearMotion");
    addModel<RotatingMotion>(all, "rotatingMotion");
    addModel<TabulatedMotion>(all, "tabulated6DoFMotion");
    return all;
}

} // namespace

PrescribedMotionRegistry& prescribedMotionRegistry()
{
    static PrescribedMotionRegistry registry = builtInMotions();
    return registry;
}

std::unique_ptr<PrescribedMotion> makePrescribedMotion(Dictionary const& dict)
{
    std::string const keyword = "solidBodyMotionFunction";
    return prescribedMotionRegistry().make(dict.get<std::string>(keyword), dict.where(keyword), dict);
}

} // namespace mpsDem
