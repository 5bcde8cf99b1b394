#include "bodies/RigidBodyReader.h"

#include <cmath>

#include "bodies/Entries.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

Real readMass(Dictionary const& dict, MassProperties const& shape)
{
    bool const byMass = dict.found("mass");
    bool const byDensity = dict.found("density");
    if (!byMass && !byDensity) dict.refuseMisspelt({"mass", "density"});
    require(byMass != byDensity, dict.where(byMass ? "density" : ""), byMass ? "a body has mass and density" : "a body has no mass",
            "either mass or density");
    if (byMass) return readPositive(dict, "mass");
    require(shape.volume > 0, dict.where("density"), "density of a body without a shape", "mass, or a shape");
    return readPositive(dict, "density") * shape.volume;
}

/// Mass, centre and inertia: what the user gives goes before what the shape says.
MassProperties readMassProperties(Dictionary const& dict, MassProperties const& shape, Quaternion const& orientation)
{
    Real const mass = readMass(dict, shape);
    bool const hasShape = shape.volume > 0;
    MassProperties result = hasShape ? shape.withMass(mass) : shape;
    result.mass = mass;

    require(hasShape || dict.found("centreOfMass"), dict.where(), "centreOfMass is missing", "a point, or a shape to find it from");
    result.centreOfMass = readVectorOr(dict, "centreOfMass", shape.centreOfMass);
    if (dict.found("momentOfInertia"))
    {
        Vector const moments = readVector(dict, "momentOfInertia");
        require(moments.minCoeff() > 0, dict.where("momentOfInertia"), "momentOfInertia is not positive", "(Ixx Iyy Izz), all above 0");
        result.inertia = moments.asDiagonal();
        return result;
    }
    require(hasShape, dict.where(), "momentOfInertia is missing", "(Ixx Iyy Izz), or a shape to find it from");
    bool const moved = (result.centreOfMass - shape.centreOfMass).norm() > 1e-6 * std::cbrt(shape.volume);
    require(!moved, dict.where("centreOfMass"), "centreOfMass is not that of the homogeneous shape",
            "momentOfInertia beside it: the shape's inertia holds for its own centre only");
    Tensor const axes = orientation.toRotationMatrix();
    result.inertia = axes.transpose() * result.inertia * axes;
    return result;
}

void readVelocity(Dictionary const& dict, RigidBody& body)
{
    bool const byMomentum = dict.found("angularMomentum");
    require(!(byMomentum && dict.found("angularVelocity")), dict.where("angularMomentum"), "a body has angularVelocity and angularMomentum",
            "one of them");
    Vector const velocity = readVectorOr(dict, "velocity", Vector::Zero());
    Vector angularVelocity = readVectorOr(dict, "angularVelocity", Vector::Zero());
    if (byMomentum)
    {
        Vector const momentum = readVector(dict, "angularMomentum");
        angularVelocity = body.rotation() * body.massProperties().inertia.inverse() * momentum;
    }
    Matrix6 const free = body.freeProjection();
    auto const fits = [](Tensor const& projection, Vector const& v) { return (projection * v - v).norm() <= 1e-6 * v.norm(); };
    std::string const allowed = "a velocity along the free directions (2-D: translation in x and y, rotation about z; or dimensions 3)";
    require(fits(free.topLeftCorner<3, 3>(), velocity), dict.where("velocity"), "velocity is against the constraints", allowed);
    require(fits(free.bottomRightCorner<3, 3>(), angularVelocity), dict.where(byMomentum ? "angularMomentum" : "angularVelocity"),
            "angular velocity is against the constraints", allowed);
    body.setVelocity(velocity, angularVelocity);
}

void readPrescribedMotion(Dictionary const& dict, RigidBody& body, Real time)
{
    for (char const* key : {"constraints", "velocity", "angularVelocity", "angularMomentum"})
        require(!dict.found(key), dict.where(key), std::string(key) + " of a body that has prescribedMotion", "only one of the two");
    body.setPrescribedMotion(makePrescribedMotion(dict.subDict("prescribedMotion")), time);
}

} // namespace

std::unique_ptr<RigidBody> readRigidBody(std::string const& name, Dictionary const& dict, MassProperties const& fromShape, bool planar,
                                         Real time)
{
    Quaternion const orientation = readOrientation(dict, "orientation");
    MassProperties const mass = readMassProperties(dict, fromShape, orientation);
    auto body = std::make_unique<RigidBody>(name, mass, mass.centreOfMass, orientation);
    body->setReport(dict.getOr<bool>("report", false));
    if (planar)
    {
        bool const inPlane = std::abs(orientation.x()) < 1e-9 && std::abs(orientation.y()) < 1e-9;
        require(inPlane, dict.where("orientation"), "orientation leaves the x-y plane of a 2-D case", "a turn about z");
        body->restrictTo2D();
    }

    Dictionary const restraints = dict.subDictOrEmpty("restraints");
    for (std::string const& key : restraints.dictKeys()) body->addRestraint(makeRestraint(key, restraints.subDict(key)));
    if (dict.found("releaseTime")) body->setReleaseTime(readNumber(dict, "releaseTime"));
    if (dict.found("prescribedMotion"))
    {
        readPrescribedMotion(dict, *body, time);
        return body;
    }
    Dictionary const constraints = dict.subDictOrEmpty("constraints");
    for (std::string const& key : constraints.dictKeys()) body->addConstraint(makeConstraint(key, constraints.subDict(key)));
    readVelocity(dict, *body);
    return body;
}

} // namespace mpsDem
