#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <Eigen/Eigenvalues>

#include "dem/ContactModel.h"

namespace mpsDem {

namespace {

constexpr Real mostSubSteps = 2000;
constexpr Real mostTravel = 0.2; ///< Part of the spacing that a point may move in a sub-step.

/// Largest eigenfrequency of the body on its contact springs, free directions only [1/s].
Real eigenfrequency(RigidBody const& body, Matrix6 const& stiffness)
{
    Matrix6 const free = body.freeProjection();
    Matrix6 const k = free * stiffness * free;
    Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6> const solver(k, body.massMatrix(), Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(Real(0), solver.eigenvalues().maxCoeff()));
}

} // namespace

Real ContactModel::speed(RigidBody const& body, std::size_t index) const
{
    return body.velocity().norm() + body.angularVelocity().norm() * broadPhase_.reach(index);
}

int ContactModel::subSteps(std::span<RigidBody* const> bodies, Real dt)
{
    search(bodies, dt);
    stiffness_.assign(bodies.size(), Matrix6::Zero());
    movable_.clear();
    for (RigidBody const* body : bodies) movable_.push_back(!immovable(*body));
    Real fastest = 0;
    for (std::size_t const active : active_)
    {
        ContactPair const& pair = pairs_[active];
        std::size_t const a = pair.parts().body;
        int const b = pair.parts().other;
        if (!movable_[a] && (b < 0 || !movable_[static_cast<std::size_t>(b)])) continue;
        Real v = speed(*bodies[a], a);
        if (b >= 0) v += speed(*bodies[static_cast<std::size_t>(b)], static_cast<std::size_t>(b));
        Real const fall = 9.81 * dt * dt;
        if (pair.addStiffness(bodies, mayTouch + v * dt + fall, stiffness_)) fastest = std::max(fastest, v);
    }
    Real omega = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (movable_[i] && stiffness_[i].squaredNorm() > 0) omega = std::max(omega, eigenfrequency(*bodies[i], stiffness_[i]));
    Real const byContact = dt * omega * collisionResolutionSteps_ / std::numbers::pi;
    Real const count = std::ceil(std::max({Real(1), byContact, dt * fastest / (mostTravel * spacing_)}));
    if (count <= mostSubSteps) return static_cast<int>(count);
    std::ostringstream text;
    text << "contact needs " << count << " sub-steps in a fluid step of " << dt << " s";
    throw CaseError(ExitCode::Solver, text.str(), "at most 2000: raise maxOverlap, lower impactSpeed (contactProperties) or cut deltaT");
}

void ContactModel::addTo(std::span<RigidBody* const> bodies, Real h)
{
    if (!searched_ || !broadPhase_.covers(bodies)) search(bodies, std::max(h, searchTime_));
    for (Latch& latch : latches_) latch.check(*bodies[latch.body()], *points_[latch.body()]);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        bodies[i]->contactNormal = Load();
        bodies[i]->contactTangential = Load();
        sums_[i] = BodyContactSums();
        sums_[i].immovable = immovable(*bodies[i]);
    }
    Real const kick = lastStep_ > 0 ? std::min(Real(2), 0.5 * (lastStep_ + h) / h) : Real(1);
    for (std::size_t const active : active_)
    {
        pairs_[active].detect(bodies, dissipation_);
        pairs_[active].addSums(sums_);
    }
    for (std::size_t const active : active_)
    {
        ContactPair& pair = pairs_[active];
        if (pair.contacts().empty()) continue;
        pair.shareMass(bodies, sums_);
        pair.addForces(bodies, h, kick, dissipation_);
    }
    lastStep_ = h;
    checkOverlap(bodies);
}

void ContactModel::report(std::ostream& os, std::span<RigidBody* const> bodies) const
{
    for (std::size_t i = 0; i < pairs_.size(); ++i)
    {
        ContactPair::Parts const& parts = pairs_[i].parts();
        ContactProperties const& p = properties_[i];
        Real const mass = bodies[parts.body]->mass();
        Contact face;
        face.area = parts.points->largestSide();
        face.radius = disc_[parts.body] ? parts.points->points().front().curvature : 0.5 * spacing_;
        face.count = disc_[parts.body] ? 1 : face.area / (spacing_ * spacing_);
        Real const stiffness = parts.law->normalStiffness(face, parts.referenceOverlap);
        Real const step = std::numbers::pi * std::sqrt(mass / stiffness) / collisionResolutionSteps_;
        os << "contact " << pairs_[i].name() << ": " << p.law << ", mu " << p.mu << ", e " << p.e << ", " << parts.points->points().size()
           << " points, stiffness of the longest side " << stiffness << " N/m, damping ratio " << materials_[i].zeta
           << ", overlap by the weight " << 9.81 * mass / stiffness << " m, sub-step " << step << " s\n";
    }
    auto const given = [](ContactProperties const& p) { return !p.modulus.file.empty(); };
    auto const used = [&](ContactProperties const& p) { return given(p) && !p.idleModulus(); };
    auto const idle = std::find_if(properties_.begin(), properties_.end(), given);
    if (idle != properties_.end() && std::none_of(properties_.begin(), properties_.end(), used))
        os << "contact: youngsModulus (" << idle->modulus.str() << ") has no effect with stiffness " << idle->stiffness << " and law "
           << idle->law << '\n';
    std::size_t const all = points_.size() * (points_.size() - std::min<std::size_t>(points_.size(), 1));
    if (std::count_if(keys_.begin(), keys_.end(), [&](Key const& key) { return betweenBodies(key); }) < static_cast<std::ptrdiff_t>(all))
        os << "contact of body with body: the other pairs are made as soon as two bodies come near one another\n";
    for (Latch const& latch : latches_) os << "contact " << bodies[latch.body()]->name() << ":" << latch.name() << ": latch\n";
}

} // namespace mpsDem
