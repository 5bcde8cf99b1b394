#include "dem/ContactPair.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mpsDem {

namespace {

/// Turns the tangential displacement into the plane of a new normal; keeps its length.
void turnSlip(Contact& contact, Contact const& old)
{
    Vector const inPlane = old.slip - old.slip.dot(contact.normal) * contact.normal;
    Real const length = inPlane.norm();
    contact.slip = length > 0 ? Vector(inPlane * (old.slip.norm() / length)) : Vector(Vector::Zero());
    contact.tangentialStiffness = old.tangentialStiffness;
    contact.tangentialEnergy = old.tangentialEnergy;
    contact.fresh = false;
}

/// Inverse of the mass that resists a force along n at r of one body: n . (1/m) n + (r x n) . I^-1 (r x n), free directions only [1/kg].
Real inverseMassAt(RigidBody const& body, Vector const& r, Vector const& n)
{
    Vector6 direction;
    direction << n, (r - body.centre()).cross(n);
    direction = body.freeProjection() * direction;
    Vector const turn = direction.tail<3>();
    Real const square = turn.squaredNorm();
    Real const byRotation = square > 0 ? square * square / turn.dot(body.inertia() * turn) : Real(0);
    return direction.head<3>().squaredNorm() / body.mass() + byRotation;
}

} // namespace

bool immovable(RigidBody const& body) { return body.locked() || body.freeDirections() == 0; }

ContactPair::ContactPair(Parts parts) : parts_(std::move(parts)) { watchAll(); }

void ContactPair::watchAll()
{
    watched_.resize(parts_.points->points().size());
    std::iota(watched_.begin(), watched_.end(), 0);
    spheres_.reserve(watched_.size());
}

void ContactPair::watch(std::span<RigidBody* const> bodies, Real reach)
{
    watchAll();
    placeSpheres(bodies);
    watched_.clear(); // all points were placed: the number of a sphere is that of its point
    parts_.surface->findNear(spheres_, reach, watched_);
}

Real ContactPair::maxOverlap() const
{
    Real most = 0;
    for (Contact const& contact : contacts_) most = std::max(most, contact.overlap);
    return most;
}

Real ContactPair::elasticEnergy() const
{
    Real sum = 0;
    for (Contact const& contact : contacts_) sum += contact.normalEnergy + contact.tangentialEnergy;
    return sum;
}

void ContactPair::placeSpheres(std::span<RigidBody* const> bodies) const
{
    RigidBody const& body = *bodies[parts_.body];
    spheres_.clear();
    for (int const number : watched_)
    {
        ContactPoint const& point = parts_.points->points()[static_cast<std::size_t>(number)];
        spheres_.push_back({body.toSpace(point.centre), point.radius});
    }
    if (parts_.other < 0) return;
    RigidBody const& other = *bodies[static_cast<std::size_t>(parts_.other)];
    Tensor const toSurface = other.rotation().transpose();
    for (Sphere& sphere : spheres_) sphere.centre = toSurface * (sphere.centre - other.centre());
}

Vector ContactPair::toSpace(std::span<RigidBody* const> bodies, Vector const& direction) const
{
    return parts_.other < 0 ? direction : Vector(bodies[static_cast<std::size_t>(parts_.other)]->rotation() * direction);
}

Contact ContactPair::makeContact(std::span<RigidBody* const> bodies, ContactFeature const& feature) const
{
    int const number = watched_[static_cast<std::size_t>(feature.sphere)];
    ContactPoint const& point = parts_.points->points()[static_cast<std::size_t>(number)];
    RigidBody const& body = *bodies[parts_.body];
    Contact contact;
    contact.point = number;
    contact.patch = feature.patch;
    contact.normal = toSpace(bodies, feature.normal);
    contact.overlap = -feature.gap;
    contact.position = body.toSpace(point.centre) - (point.radius - 0.5 * contact.overlap) * contact.normal;
    contact.velocity = body.velocityAt(contact.position);
    if (parts_.other >= 0) contact.velocity -= bodies[static_cast<std::size_t>(parts_.other)]->velocityAt(contact.position);
    contact.area = point.area;
    contact.count = point.count;
    contact.radius = feature.radius > 0 ? 1 / (1 / point.curvature + 1 / feature.radius) : point.curvature;
    contact.mass = body.mass();
    return contact;
}

void ContactPair::detect(std::span<RigidBody* const> bodies, ContactDissipation& dissipation)
{
    placeSpheres(bodies);
    features_.clear();
    parts_.surface->collect(spheres_, 0, features_);
    std::swap(contacts_, previous_);
    contacts_.clear();
    inherited_.assign(previous_.size(), 0);
    std::size_t old = 0;
    for (std::size_t first = 0; first < features_.size();)
    {
        int const sphere = features_[first].sphere;
        int const point = watched_[static_cast<std::size_t>(sphere)];
        std::size_t const newBegin = contacts_.size();
        for (; first < features_.size() && features_[first].sphere == sphere; ++first)
            contacts_.push_back(makeContact(bodies, features_[first]));
        while (old < previous_.size() && previous_[old].point < point) ++old;
        std::size_t oldEnd = old;
        while (oldEnd < previous_.size() && previous_[oldEnd].point == point) ++oldEnd;
        inherit(old, oldEnd, newBegin);
        old = oldEnd;
    }
    for (std::size_t i = 0; i < previous_.size(); ++i)
        if (!inherited_[i]) dissipation.tangential += previous_[i].tangentialEnergy;
}

void ContactPair::inherit(std::size_t oldBegin, std::size_t oldEnd, std::size_t newBegin)
{
    auto const hand = [&](auto const& matches) {
        for (std::size_t i = newBegin; i < contacts_.size(); ++i)
            for (std::size_t k = oldBegin; k < oldEnd && contacts_[i].fresh; ++k)
            {
                if (inherited_[k] || !matches(contacts_[i], previous_[k])) continue;
                turnSlip(contacts_[i], previous_[k]);
                inherited_[k] = 1;
            }
    };
    hand([](Contact const& now, Contact const& old) { return now.patch == old.patch; });
    hand([](Contact const& now, Contact const& old) { return now.normal.dot(old.normal) > 0.5; });
}

void ContactPair::addSums(std::vector<BodyContactSums>& sums) const
{
    for (Contact const& contact : contacts_)
    {
        Tensor const k = parts_.law->normalStiffness(contact, parts_.referenceOverlap) * contact.normal * contact.normal.transpose();
        sums[parts_.body].stiffness += k;
        ++sums[parts_.body].count;
        if (parts_.other < 0) continue;
        sums[static_cast<std::size_t>(parts_.other)].stiffness += k;
        ++sums[static_cast<std::size_t>(parts_.other)].count;
    }
}

Real ContactPair::reducedMass(std::span<RigidBody* const> bodies, std::vector<BodyContactSums> const& sums, Contact const& contact) const
{
    Real const k = parts_.law->normalStiffness(contact, parts_.referenceOverlap);
    auto const inverse = [&](std::size_t index) {
        RigidBody const& body = *bodies[index];
        if (sums[index].immovable) return Real(0);
        if (sums[index].count == 1) return inverseMassAt(body, contact.position, contact.normal);
        return contact.normal.dot(sums[index].stiffness * contact.normal) / (k * body.mass());
    };
    Real total = inverse(parts_.body);
    if (parts_.other >= 0) total += inverse(static_cast<std::size_t>(parts_.other));
    return total > 0 ? 1 / total : bodies[parts_.body]->mass();
}

void ContactPair::shareMass(std::span<RigidBody* const> bodies, std::vector<BodyContactSums> const& sums)
{
    auto const fixed = [&](int index) { return index < 0 || sums[static_cast<std::size_t>(index)].immovable; };
    bool const held = fixed(static_cast<int>(parts_.body)) && fixed(parts_.other);
    for (Contact& contact : contacts_)
    {
        contact.mass = reducedMass(bodies, sums, contact);
        contact.held = held;
    }
}

void ContactPair::addForces(std::span<RigidBody* const> bodies, Real h, Real kick, ContactDissipation& dissipation)
{
    parts_.law->evaluate(contacts_, h, dissipation);
    if (kick != 1)
        for (Contact& contact : contacts_)
        {
            if (contact.fresh) continue;
            contact.normalForce *= kick;
            contact.tangentialForce *= kick;
        }
    auto const add = [](RigidBody& body, Real sign, Contact const& contact) {
        Vector const arm = contact.position - body.centre();
        body.contactNormal.add(sign * contact.normalForce, arm);
        body.contactTangential.add(sign * contact.tangentialForce, arm);
    };
    for (Contact const& contact : contacts_)
    {
        add(*bodies[parts_.body], 1, contact);
        if (parts_.other >= 0) add(*bodies[static_cast<std::size_t>(parts_.other)], -1, contact);
    }
}

} // namespace mpsDem
