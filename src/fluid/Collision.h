#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/Ledger.h"
#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/PeriodicImages.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Particle collision: `collisionSchemes { type pairwise; }`. Keeps particles apart that approach closer than a share of the spacing.
///
/// For each approaching pair with r < c dx the normal velocity is reversed with restitution e; fluid pairs share the impulse (linear
/// momentum is conserved), a wall has infinite mass:
/// \f[ \Delta\mathbf u_i = -(1+e)\frac{m_r}{m} v_n \hat{\mathbf r}_{ij},\quad v_n = (\mathbf u_i-\mathbf u_j)\cdot\hat{\mathbf r}_{ij} > 0 \f]
/// The opposite of what the fluid gets from the particles of a body is the body's (reactions()); fixed walls keep theirs in the ledger.
///
/// c is `surfaceDistance` where one of the two is at or near the free surface or is a wall, else `distance`.
///
/// With `walls centres` a particle also meets the particles of a wall along the line of centres: a row of balls, which brakes water that
/// slips along it and throws it up. With `walls normal` it meets the plane of the wall, once: v_n is then along the normal of the wall.
/// A particle at the surface that is behind the planes of all particles within reach, as splash that falls on a corner of a body whose particle
/// looks sideways, has no pressure to hold it back either: it meets the plane of the nearest particle beside them in front of which it is.
///
/// | key | meaning | unit | default (standard, paper) | range |
/// | type | pairwise or none | - | pairwise | - |
/// | distance | c in the interior | spacings | 0.5 | 0..1 |
/// | surfaceDistance | c at surface and walls | spacings | 0.8, 0.5 | 0..1 |
/// | restitution | e | - | 0.2 | 0..1 |
/// | walls | direction of collisions with walls: centres or normal | - | centres; set `waves`: normal | |
class Collision
{
public:
    /// The model that `collisionSchemes` asks for; null for `none`. @throw CaseError BadInput
    static std::unique_ptr<Collision> read(Dictionary const& collisionSchemes, SchemeSet set, Lattice const& lattice, Real density,
                                           Ledger& ledger);

    /// Changes u and r (by dt du) of the fluid after it has moved; adds the kinetic energy taken, and the impulse of fixed walls, to the ledger.
    void apply(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt);

    /// Whether particles meet the planes of walls, or their particles.
    [[nodiscard]] bool alongNormal() const { return alongNormal_; }

    /// What a body gets in a step.
    struct Impulse
    {
        Vector linear = Vector::Zero(); ///< [N s].
        Vector moment = Vector::Zero(); ///< About the origin [N m s].
        Real amount = 0;                ///< Sum of the sizes of the single impulses [N s].
        Real rate = 0;                  ///< Sum of these sizes, each times speed of approach over the spacing [N].
    };
    /// Of this step, by number of the body.
    [[nodiscard]] std::span<Impulse const> reactions() const { return reactions_; }

private:
    Collision(Dictionary const& dict, SchemeSet set, Lattice const& lattice, Real density, Ledger& ledger);

    /// Change of the velocity of fluid particle i by all particles close to it [m/s]; notes what walls and bodies get.
    Vector changeOf(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images, int i);
    /// The part of the planes of walls in that, with `walls normal` [m/s].
    Vector meetPlanes(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images, int i);
    /// Change of the velocity of a particle at the plane of j [m/s]. @param velocity  Of the particle, with changes so far [m/s].
    Vector meetPlane(ParticleSet const& particles, PeriodicImages const& images, int j, Vector const& velocity);
    /// Fluid gets `du` [m/s] from boundary particle j. @param approach  Its speed towards it before [m/s].
    void note(ParticleSet const& particles, PeriodicImages const& images, int j, Vector const& du, Real approach);
    void clearReactions(ParticleSet const& particles);

    Real distance_, surfaceDistance_, restitution_, particleMass_;
    bool alongNormal_; ///< `walls normal`.
    Real& dissipated_;
    Vector& wallImpulse_; ///< Of fixed walls on the fluid, in the ledger [N s].
    Vector fromWalls_ = Vector::Zero();
    std::vector<Impulse> reactions_;
    Field<Vector> change_;
};

} // namespace mpsDem
