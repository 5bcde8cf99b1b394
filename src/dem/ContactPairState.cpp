#include <algorithm>

#include "dem/ContactPair.h"

namespace mpsDem {

bool ContactPair::addStiffness(std::span<RigidBody* const> bodies, Real reach, std::vector<Matrix6>& stiffness) const
{
    placeSpheres(bodies);
    features_.clear();
    parts_.surface->collect(spheres_, reach, features_);
    Real const twice = parts_.other < 0 ? 1 : 2; // (a - b)^2 <= 2 a^2 + 2 b^2
    auto const add = [&](std::size_t index, Contact const& contact, Real kn, Real kt) {
        Vector const arm = contact.position - bodies[index]->centre();
        Tensor const k = kt * Tensor::Identity() + (kn - kt) * contact.normal * contact.normal.transpose();
        Eigen::Matrix<Real, 3, 6> jacobian; // velocity at the contact = J (V, omega)
        jacobian << Tensor::Identity(), Tensor{{0, arm.z(), -arm.y()}, {-arm.z(), 0, arm.x()}, {arm.y(), -arm.x(), 0}};
        stiffness[index] += twice * jacobian.transpose() * k * jacobian;
    };
    for (ContactFeature const& feature : features_)
    {
        Contact const contact = makeContact(bodies, feature);
        Real const approach = std::max(Real(0), -contact.velocity.dot(contact.normal));
        Real const overlap = std::max({parts_.referenceOverlap, contact.overlap, parts_.law->impactOverlap(contact, approach)});
        Real const kn = parts_.law->normalStiffness(contact, overlap);
        Real const kt = parts_.law->tangentialStiffness(contact, overlap);
        add(parts_.body, contact, kn, kt);
        if (parts_.other >= 0) add(static_cast<std::size_t>(parts_.other), contact, kn, kt);
    }
    return !features_.empty();
}

Real ContactPair::overlapNow(std::span<RigidBody* const> bodies) const
{
    placeSpheres(bodies);
    features_.clear();
    parts_.surface->collect(spheres_, 0, features_);
    Real most = 0;
    for (ContactFeature const& feature : features_) most = std::max(most, -feature.gap);
    return most;
}

void ContactPair::save(State& state) const
{
    State::Integers keys;
    State::Reals history;
    for (Contact const& contact : contacts_)
    {
        keys.insert(keys.end(), {contact.point, contact.patch});
        history.insert(history.end(),
                       {contact.slip.x(), contact.slip.y(), contact.slip.z(), contact.normal.x(), contact.normal.y(), contact.normal.z(),
                        contact.tangentialStiffness, contact.tangentialEnergy, contact.normalEnergy, contact.overlap});
    }
    state.set("contact/" + parts_.name + "/keys", std::span<std::int64_t const>(keys));
    state.set("contact/" + parts_.name + "/history", std::span<Real const>(history));
}

void ContactPair::load(State const& state)
{
    State::Integers const& keys = state.integers("contact/" + parts_.name + "/keys");
    State::Reals const& history = state.reals("contact/" + parts_.name + "/history");
    std::size_t const count = keys.size() / 2;
    if (keys.size() != 2 * count || history.size() != 10 * count)
        throw CaseError(ExitCode::InputOutput, "contact history of " + parts_.name + " has blocks of different length",
                        "2 integers and 10 numbers a contact");
    contacts_.assign(count, Contact());
    for (std::size_t i = 0; i < count; ++i)
    {
        Contact& contact = contacts_[i];
        Real const* const h = history.data() + 10 * i;
        contact.point = static_cast<int>(keys[2 * i]);
        contact.patch = static_cast<int>(keys[2 * i + 1]);
        contact.slip = Vector(h[0], h[1], h[2]);
        contact.normal = Vector(h[3], h[4], h[5]);
        contact.tangentialStiffness = h[6];
        contact.tangentialEnergy = h[7];
        contact.normalEnergy = h[8];
        contact.overlap = h[9];
        contact.fresh = false;
    }
}

} // namespace mpsDem
