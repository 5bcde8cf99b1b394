#pragma once

#include <vector>

#include "boundaries/TriangleTree.h"
#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// Keeps fluid inside of the fixed walls of a 3-D scene.
///
/// The pressure of even rows holds water back; where walls cut through each other in their middle or bend more sharply than a spacing, the
/// rows are uneven, and single particles find a gap between their particles. One that is deeper than `deepest` behind the surface (wall
/// particles lie at 0.5 l0) is put back to that depth along its way to the surface, and loses its velocity into the wall, as in an impact
/// without restitution:
/// \f[ \Delta\mathbf r_i = (-d_i - 0.1 l_0)\,\mathbf n,\quad \Delta\mathbf u_i = \max(0, -\mathbf u_i\cdot\mathbf n)\,\mathbf n \f]
/// d signed distance from the surface [m], positive in the fluid, n unit vector of the way back. The exact distance is asked for only where
/// a particle lies behind the tangent plane of a wall particle near it.
class WallGuard
{
public:
    /// @param spacing  l0 [m].
    WallGuard(std::span<TriSurface const> walls, Real spacing) : tree_(walls), spacing_(spacing) {}

    /// What the walls did in a step, over the mass of a particle, on this rank.
    struct Exchange
    {
        Real energyTaken = 0;                 ///< [J/kg].
        Vector impulseGiven = Vector::Zero(); ///< [m/s].
    };
    /// Changes u and r of fluid particles.
    Exchange apply(ParticleSet& particles, NeighbourList const& neighbours);

    /// Signed distance from the walls [m], and whether the nearest place is a rim.
    [[nodiscard]] TriangleTree::Nearest nearest(Vector const& r) const { return tree_.nearest(r); }
    /// Particles that were put back since the start, of this rank.
    [[nodiscard]] std::int64_t putBack() const { return putBack_; }

    static constexpr Real deepest = 0.1; ///< Behind the surface, in spacings.

private:
    void findSuspects(ParticleSet const& particles, NeighbourList const& neighbours);

    TriangleTree tree_;
    Real spacing_;
    Field<int> suspects_;
    Field<std::uint8_t> suspect_;
    std::int64_t putBack_ = 0;
};

} // namespace mpsDem
