#pragma once

#include <map>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/Polyline.h"
#include "core/State.h"
#include "core/TriSurface.h"
#include "dem/BroadPhase.h"
#include "dem/ContactPair.h"
#include "dem/ContactProperties.h"
#include "dem/Latch.h"
#include "dem/PairStiffness.h"

namespace mpsDem {

/// A wall that bodies can touch.
struct RestingSurface
{
    std::string name;
    std::shared_ptr<ContactSurface const> surface;
};

/// Polylines or triangle surfaces as walls: where the end of one lies on another one it goes on there.
std::vector<RestingSurface> restingSurfaces(std::vector<Polyline> const& lines, Real spacing);
std::vector<RestingSurface> restingSurfaces(std::vector<TriSurface> const& surfaces, Real spacing);

/// All contacts of a scene: bodies with resting surfaces, with one another, with stoppers and latches (eqs 11-12).
///
/// constant/contactProperties, beside the keys of ContactProperties:
///
/// | key                      | meaning                                                | default |
/// |--------------------------|--------------------------------------------------------|---------|
/// | collisionResolutionSteps | sub-steps in one undamped contact, 20 .. 10000         | 32      |
/// | pairs                    | `"slide:ramp" { mu 0.0105; }`, either order of names   | none    |
/// | stoppers                 | `foot { type stopper; body slide; point (..); normal (..); e 0.1; }`; type `latch` locks the body | none |
///
/// A stopper is a plane that only its body feels: keys of ContactProperties, but mu 0 and e 0.1 by default.
/// Body against body: the points of each against the outline of the other, each with half the stiffness.
///
/// Once a fluid step the bodies are looked through for pairs that may touch in it, and their points for those that may (BroadPhase,
/// ContactPair::watch); sub-steps look at these only, for as long as no body has moved further than was allowed for. In scenes of more than
/// 8 bodies a pair of bodies is made when its bodies come near one another. Results depend on neither.
class ContactModel
{
public:
    /// In 2-D.
    /// @param spacing    dx [m].  @param thickness  Width in z [m].
    /// @param surfaces   Resting surfaces, normals into the free side.
    /// @param bodies     In the order of all later calls.  @param shapes  One for each body, in body axes.
    /// @throw CaseError BadInput for wrong entries and for an overlap above 0.3 dx at the start.
    ContactModel(Dictionary const& contactProperties, Real spacing, Real thickness, std::vector<Polyline> const& surfaces,
                 std::span<RigidBody* const> bodies, std::vector<ContactShape> const& shapes);
    /// In 3-D: no thickness.
    ContactModel(Dictionary const& contactProperties, Real spacing, std::vector<TriSurface> const& surfaces,
                 std::span<RigidBody* const> bodies, std::vector<ContactShape> const& shapes);
    /// With surfaces of any kind. @param thickness  Width in z; in 3-D the spacing, the width of a contact point [m].
    ContactModel(Dictionary const& contactProperties, Real spacing, Real thickness, std::vector<RestingSurface> const& surfaces,
                 std::span<RigidBody* const> bodies, std::vector<ContactShape> const& shapes);

    /// Number of equal sub-steps of a fluid step dt [s]: 1 where nothing can touch (farther away than 5 mm + v dt), else so many that
    /// one contact takes collisionResolutionSteps of them: h = pi / (omega steps), omega^2 the largest eigenvalue of M^-1 K
    /// with K of all points that may touch; and no point moves more than 0.2 dx.
    /// @throw CaseError (Solver) above 2000.
    [[nodiscard]] int subSteps(std::span<RigidBody* const> bodies, Real dt);

    /// Sets contactNormal and contactTangential of every body for the sub-step h [s] that begins now. Once a sub-step: history grows.
    ///
    /// Velocities stand half a sub-step behind positions. Where h differs from the last one h', the forces of contacts that last are taken
    /// times (h' + h) / (2 h), at most 2, so that velocities stand half of the new sub-step behind: else each change of h in the middle of an
    /// elastic impact would give or take energy of first order in h.
    /// Source: R. Skeel, BIT 33 (1993), on leapfrog with changing steps.
    /// @throw CaseError (Solver) for an overlap above 0.3 dx.
    void addTo(std::span<RigidBody* const> bodies, Real h);

    /// Touching points of all pairs in the last sub-step.
    [[nodiscard]] std::size_t contactCount() const;
    [[nodiscard]] Real maxOverlap() const;    ///< Of the last sub-step [m].
    [[nodiscard]] Real elasticEnergy() const; ///< In all springs [J].
    /// Turned into heat by dashpots and sliders since the start [J]. Kinetic + potential + elastic + dissipated energy is constant.
    [[nodiscard]] Real dissipatedEnergy() const { return dissipation_.normal + dissipation_.tangential; }
    [[nodiscard]] ContactDissipation const& dissipation() const { return dissipation_; }
    /// Those made so far, by body and by what it touches: surfaces before bodies; stoppers at the end.
    [[nodiscard]] std::vector<ContactPair> const& pairs() const { return pairs_; }
    /// What one sub-step has to look at.
    struct Work
    {
        std::size_t boxes;  ///< Pairs of bodies whose boxes were compared in the last search.
        std::size_t pairs;  ///< Pairs with a point that may touch.
        std::size_t points; ///< Such points.
    };
    [[nodiscard]] Work work() const;
    [[nodiscard]] std::vector<Latch> const& latches() const { return latches_; }
    [[nodiscard]] Real latchedEnergy() const; ///< Kinetic energy that latches took from their bodies since the start [J].

    /// One line a pair: law, mu, e, stiffness, damping, static overlap, sub-step.
    void report(std::ostream& os, std::span<RigidBody* const> bodies) const;

    void save(State& state) const; ///< Blocks "contact/...".
    void load(State const& state);

    /// What sub-steps change: contacts with their history, latches, heat. For a step that is taken again.
    struct History
    {
        std::vector<std::pair<int, int>> keys;      ///< Of each pair.
        std::vector<std::vector<Contact>> contacts; ///< Of each pair.
        std::vector<Latch> latches;
        ContactDissipation dissipation;
        Real lastStep = 0;
    };
    void copyTo(History& history) const; ///< Reuses its memory.
    void restore(History const& history);

private:
    struct Target
    {
        std::string name;
        int body; ///< -1 for one at rest.
        std::shared_ptr<ContactSurface const> surface;
    };
    /// Body and number of its target; for a stopper the number of bodies and its own one. Pairs are in this order.
    using Key = std::pair<int, int>;

    void addBody(ContactShape const& shape, RigidBody const& body);
    void readPairs(Dictionary const& contactProperties);
    void addPair(Key const& key, std::size_t body, Target const& target, ContactProperties const& properties);
    void addStoppers(Dictionary const& stoppers, std::span<RigidBody* const> bodies);
    /// Makes the pair of the points of one body against another one, if it isn't there.
    void addBodyPair(int first, int second);
    [[nodiscard]] bool betweenBodies(Key const& key) const;
    [[nodiscard]] std::size_t find(Key const& key) const; ///< Where it is, or where it should be inserted.
    [[nodiscard]] Target const& target(std::size_t body) const { return targets_[targets_.size() - points_.size() + body]; }
    /// Looks for what may touch while no body moves further than it will in dt [s] at its present speed, and a margin.
    void search(std::span<RigidBody* const> bodies, Real dt);
    void checkStart(std::span<RigidBody* const> bodies) const;
    void checkOverlap(std::span<RigidBody* const> bodies) const;
    [[nodiscard]] Real speed(RigidBody const& body, std::size_t index) const;

    static constexpr std::size_t fewBodies = 8; ///< Up to so many bodies all pairs are made at once, and each is warned of by itself.
    static constexpr Real mayTouch = 5e-3;      ///< Gap within which a point counts for the sub-step [m].

    Real spacing_;
    Real thickness_;
    Real collisionResolutionSteps_ = 32;
    std::vector<std::shared_ptr<ContactPointSet const>> points_; ///< Of each body.
    std::vector<bool> disc_;                                     ///< For each body.
    std::vector<Real> masses_;                                   ///< For each body [kg].
    std::vector<Target> targets_;                                ///< Surfaces at rest, then bodies.
    ContactProperties common_;
    std::map<Key, ContactProperties> named_; ///< Of pairs of bodies with an entry of their own, the lower number first.
    BroadPhase broadPhase_;
    std::vector<Real> margins_;       ///< Scratch, one a body.
    std::vector<std::size_t> active_; ///< Numbers of pairs that may touch now.
    Real searchTime_ = 0;             ///< Last fluid step [s].
    bool searched_ = false;           ///< active_ fits the contacts.
    std::vector<Key> keys_;           ///< Of each pair; sorted.
    std::vector<ContactPair> pairs_;
    std::vector<ContactProperties> properties_; ///< Of each pair.
    std::vector<ContactMaterial> materials_;    ///< Of each pair.
    std::vector<Latch> latches_;
    std::vector<BodyContactSums> sums_;
    std::vector<Matrix6> stiffness_; ///< Scratch of subSteps(), one a body; so is movable_.
    std::vector<char> movable_;
    ContactDissipation dissipation_;
    Real lastStep_ = 0; ///< Sub-step of the last forces; 0 before the first [s].
};

} // namespace mpsDem
