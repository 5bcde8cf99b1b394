#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/State.h"
#include "dem/ContactLaw.h"
#include "dem/ContactPoints.h"
#include "dem/ContactSurface.h"

namespace mpsDem {

/// Sums over all contacts of one body in one sub-step, from which each contact gets its share of the mass.
struct BodyContactSums
{
    Tensor stiffness = Tensor::Zero(); ///< Sum of k n n^T [N/m].
    int count = 0;                     ///< Number of contacts.
    bool immovable = false;            ///< No contact can move the body.
};

/// The points of one body against one surface: search, history, forces.
class ContactPair
{
public:
    /// What a pair consists of.
    struct Parts
    {
        std::string name;                              ///< "slide:ramp"; unique.
        std::size_t body;                              ///< Index of the body of the points.
        std::shared_ptr<ContactPointSet const> points; ///< In body axes.
        int other = -1;                                ///< Index of the body of the surface; -1 for one at rest.
        std::shared_ptr<ContactSurface const> surface; ///< In the axes of its body.
        std::shared_ptr<ContactLaw const> law;
        Real referenceOverlap; ///< At which stiffnesses are compared where the law is not linear [m].
    };

    explicit ContactPair(Parts parts);

    [[nodiscard]] std::string const& name() const { return parts_.name; }
    [[nodiscard]] Parts const& parts() const { return parts_; }
    [[nodiscard]] std::vector<Contact> const& contacts() const { return contacts_; }
    /// Largest overlap of the last sub-step [m], 0 without contact, and energy in its springs [J].
    [[nodiscard]] Real maxOverlap() const;
    [[nodiscard]] Real elasticEnergy() const;

    /// Notes which points may touch as long as body and surface come nearer by no more than `reach` [m]; all functions below look at these
    /// only. Before the first call all points are looked at.
    void watch(std::span<RigidBody* const> bodies, Real reach);
    void watchNothing() { watched_.clear(); }
    [[nodiscard]] std::vector<int> const& watched() const { return watched_; }

    /// Finds all touching points and hands the history of the last sub-step on to them. A contact inherits from the
    /// one of the same point and patch, else from one of the same point that has ended on a neighbouring patch with a similar normal.
    /// What ends is erased.
    void detect(std::span<RigidBody* const> bodies, ContactDissipation& dissipation);
    /// Adds k n n^T of each contact to the sums of its bodies.
    void addSums(std::vector<BodyContactSums>& sums) const;
    /// Each contact's share of the reduced mass: m k / (n . S n) with the sums S of each body.
    void shareMass(std::span<RigidBody* const> bodies, std::vector<BodyContactSums> const& sums);
    /// Eqs 11-12, added to both bodies; equal and opposite.
    /// @param kick  Factor of the forces of contacts that last from before, see ContactModel::addTo.
    void addForces(std::span<RigidBody* const> bodies, Real h, Real kick, ContactDissipation& dissipation);

    /// Adds the stiffness matrix (6 x 6, about the centre of mass) of all points within `reach` of the surface to each body's one.
    /// @return false where none is.
    bool addStiffness(std::span<RigidBody* const> bodies, Real reach, std::vector<Matrix6>& stiffness) const;
    /// Largest overlap now, without touching the history [m].
    [[nodiscard]] Real overlapNow(std::span<RigidBody* const> bodies) const;

    void save(State& state) const;
    void load(State const& state);
    /// Takes back contacts() of an earlier sub-step.
    void restore(std::vector<Contact> const& contacts) { contacts_ = contacts; }

private:
    void watchAll();
    void placeSpheres(std::span<RigidBody* const> bodies) const;
    [[nodiscard]] Vector toSpace(std::span<RigidBody* const> bodies, Vector const& direction) const;
    [[nodiscard]] Contact makeContact(std::span<RigidBody* const> bodies, ContactFeature const& feature) const;
    void inherit(std::size_t oldBegin, std::size_t oldEnd, std::size_t newBegin);
    [[nodiscard]] Real reducedMass(std::span<RigidBody* const> bodies, std::vector<BodyContactSums> const& sums,
                                   Contact const& contact) const;

    Parts parts_;
    std::vector<Contact> contacts_;                ///< Sorted by point and patch.
    std::vector<Contact> previous_;                ///< Those of the last sub-step.
    std::vector<char> inherited_;                  ///< For each of previous_.
    std::vector<int> watched_;                     ///< Numbers of points, rising.
    mutable std::vector<Sphere> spheres_;          ///< Scratch: of the watched points.
    mutable std::vector<ContactFeature> features_; ///< Scratch.
};

/// True for a body that no contact can move.
bool immovable(RigidBody const& body);

} // namespace mpsDem
