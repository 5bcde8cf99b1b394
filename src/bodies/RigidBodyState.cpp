#include "bodies/RigidBody.h"

#include <array>
#include <cmath>

#include "core/Errors.h"

namespace mpsDem {

namespace {

void saveLoad(State& state, std::string const& name, Load const& load)
{
    std::array<Vector, 2> const both = {load.force, load.moment};
    state.set(name, std::span<Vector const>(both));
}

/// The vectors of a block, which must be `count` many.
std::vector<Vector> vectorsOf(State const& state, std::string const& name, std::size_t count)
{
    std::vector<Vector> values = state.vectors(name);
    if (values.size() != count) throw CaseError(ExitCode::InputOutput, "block \"" + name + "\" of the saved state has another length");
    return values;
}

Load loadedLoad(State const& state, std::string const& name)
{
    std::vector<Vector> const both = vectorsOf(state, name, 2);
    return {both[0], both[1]};
}

} // namespace

void RigidBody::save(State& state) const
{
    std::string const root = "body/" + name_ + "/";
    State::Reals properties = {mass_.mass};
    properties.insert(properties.end(), mass_.inertia.data(), mass_.inertia.data() + 9);
    state.set(root + "massProperties", std::span<Real const>(properties));
    state.set(root + "referenceCentre", mass_.centreOfMass);
    state.set(root + "centre", centre_);
    std::array<Real, 4> const q = {orientation_.w(), orientation_.x(), orientation_.y(), orientation_.z()};
    state.set(root + "orientation", std::span<Real const>(q));
    std::array<Vector, 4> const motion = {velocity_, angularVelocity_, acceleration_, angularAcceleration_};
    state.set(root + "motion", std::span<Vector const>(motion));
    std::array<Vector, 2> const atRelease = {releaseVelocity_, releaseAngularVelocity_};
    state.set(root + "releaseVelocity", std::span<Vector const>(atRelease));
    std::array<std::int64_t, 2> const flags = {released_, locked_};
    state.set(root + "releasedLocked", std::span<std::int64_t const>(flags));

    state.set(root + "addedMass", std::span<Real const>(addedMass_.data(), 36));
    state.set(root + "assumedAcceleration", std::span<Real const>(assumedAcceleration_.data(), 6));
    saveLoad(state, root + "fluidLoad", fluid);
    saveLoad(state, root + "collisions", collisions_);
    state.set(root + "collisionRate", collisionRate_);
    saveLoad(state, root + "contactNormalLoad", contactNormal);
    saveLoad(state, root + "contactTangentialLoad", contactTangential);
    saveLoad(state, root + "meanContactNormal", meanContactNormal_);
    saveLoad(state, root + "meanContactTangential", meanContactTangential_);
    saveLoad(state, root + "meanRestraint", meanRestraint_);
    saveLoad(state, root + "meanReaction", meanReaction_);
}

void RigidBody::load(State const& state)
{
    std::string const root = "body/" + name_ + "/";
    auto const reals = [&](std::string const& name, std::size_t count) -> State::Reals const& {
        State::Reals const& values = state.reals(root + name);
        if (values.size() != count)
            throw CaseError(ExitCode::InputOutput, "block \"" + root + name + "\" of the saved state has another length");
        return values;
    };
    centre_ = state.vector(root + "centre");
    State::Reals const& q = reals("orientation", 4);
    orientation_ = Quaternion(q[0], q[1], q[2], q[3]);
    rotation_ = orientation_.toRotationMatrix();
    std::vector<Vector> const motion = vectorsOf(state, root + "motion", 4);
    velocity_ = motion[0];
    angularVelocity_ = motion[1];
    acceleration_ = motion[2];
    angularAcceleration_ = motion[3];
    std::vector<Vector> const atRelease = vectorsOf(state, root + "releaseVelocity", 2);
    releaseVelocity_ = atRelease[0];
    releaseAngularVelocity_ = atRelease[1];
    State::Integers const& flags = state.integers(root + "releasedLocked");
    if (flags.size() != 2)
        throw CaseError(ExitCode::InputOutput, "block \"" + root + "releasedLocked\" of the saved state has another length");
    released_ = flags[0] != 0;
    locked_ = flags[1] != 0;

    addedMass_ = Eigen::Map<Matrix6 const>(reals("addedMass", 36).data());
    assumedAcceleration_ = Eigen::Map<Vector6 const>(reals("assumedAcceleration", 6).data());
    fluid = loadedLoad(state, root + "fluidLoad");
    collisions_ = loadedLoad(state, root + "collisions");
    collisionRate_ = state.real(root + "collisionRate");
    contactNormal = loadedLoad(state, root + "contactNormalLoad");
    contactTangential = loadedLoad(state, root + "contactTangentialLoad");
    meanContactNormal_ = loadedLoad(state, root + "meanContactNormal");
    meanContactTangential_ = loadedLoad(state, root + "meanContactTangential");
    meanRestraint_ = loadedLoad(state, root + "meanRestraint");
    meanReaction_ = loadedLoad(state, root + "meanReaction");
    sums_ = {};
}

template <class Body>
auto RigidBody::changing(Body& b)
{
    return std::tie(b.centre_, b.orientation_, b.rotation_, b.velocity_, b.angularVelocity_, b.acceleration_, b.angularAcceleration_,
                    b.addedMass_, b.assumedAcceleration_, b.fluid, b.collisions_, b.contactNormal, b.contactTangential,
                    b.meanContactNormal_, b.meanContactTangential_, b.meanRestraint_, b.meanReaction_, b.collisionRate_, b.released_,
                    b.releaseVelocity_, b.releaseAngularVelocity_, b.locked_);
}

RigidBody::Snapshot RigidBody::snapshot() const { return changing(*this); }

void RigidBody::restore(Snapshot const& snapshot) { changing(*this) = snapshot; }

} // namespace mpsDem
