#include <vector>

#include <gtest/gtest.h>

#include "boundaries/BoundaryRows.h"
#include "boundaries/SurfaceRows.h"
#include "boundaries/WallGuard.h"
#include "core/TriSurface.h"
#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "support/Measured.h"

namespace {

using namespace mpsDem;
using test::expectBelow;

constexpr Real spacing = 0.1;
constexpr Real deepest = WallGuard::deepest * spacing;

/// A tank 1 x 1 x 1 m without a lid, with the fluid particles given.
class GuardedTank
{
public:
    explicit GuardedTank(std::vector<Vector> const& fluid, Vector const& velocity) : particles(Lattice{.dimensions = 3, .spacing = spacing})
    {
        std::vector<int> const rows(walls.size(), 2);
        BoundaryRows const boundary = boundaryRows(walls, rows, spacing);
        Field<Vector> position = boundary.position, u(position.size(), Vector::Zero()), normal = boundary.normal;
        Field<ParticleType> type = boundary.type;
        for (Vector const& r : fluid)
        {
            position.push_back(r);
            u.push_back(velocity);
            normal.emplace_back(Vector::Zero());
            type.push_back(ParticleType::Fluid);
        }
        particles.assign(position, u, Field<Real>(position.size(), 0), type, Field<int>(position.size(), -1), normal);
        neighbours.update(particles);
    }

    [[nodiscard]] Vector& r(int k) { return particles.r[particles.fluid().first + k]; }
    [[nodiscard]] Vector& u(int k) { return particles.u[particles.fluid().first + k]; }

    std::vector<TriSurface> walls{TriSurface::box("tank", {0, 0, 0}, {1, 1, 1}, {false, false, false, false, false, true}).flipped()};
    ParticleSet particles;
    NeighbourList neighbours{{2.1 * spacing, 3.1 * spacing}, false};
    WallGuard guard{walls, spacing};
};

TEST(WallGuard, PutsParticlesBackThatSlipThroughTheFloor)
{
    GuardedTank tank({{0.47, 0.52, 0.05}}, {1, 0, -2});
    tank.r(0).z() = -0.06;
    WallGuard::Exchange const taken = tank.guard.apply(tank.particles, tank.neighbours);
    expectBelow("depth behind the floor less that allowed [m]", tank.r(0).z() + deepest, 1e-12);
    expectBelow("change along the floor [m]", (tank.r(0) - Vector(0.47, 0.52, -deepest)).norm(), 1e-12);
    expectBelow("velocity less that along the floor [m/s]", (tank.u(0) - Vector(1, 0, 0)).norm(), 1e-12);
    expectBelow("energy taken per mass less that of the fall [J/kg]", taken.energyTaken - 2, 1e-12);
    expectBelow("impulse given per mass less that of the fall [m/s]", (taken.impulseGiven - Vector(0, 0, 2)).norm(), 1e-12);
    EXPECT_EQ(tank.guard.putBack(), 1);
}

TEST(WallGuard, LeavesAloneWhatIsNotDeepMovesOutOrIsNearTheRim)
{
    GuardedTank tank({{0.47, 0.52, 0.05}, {0.05, 0.5, 0.55}, {0.05, 0.2, 0.95}}, {0, 0, -1});
    tank.r(0).z() = -0.99 * deepest;      // pressed against the wall's particles
    tank.r(1).x() = -0.04;                // through a side wall, on its way along it
    tank.r(2) = Vector(-0.04, 0.2, 1.02); // over the rim
    WallGuard::Exchange const taken = tank.guard.apply(tank.particles, tank.neighbours);
    EXPECT_EQ(tank.r(0), Vector(0.47, 0.52, -0.99 * deepest));
    expectBelow("side wall: change less that back to the depth allowed [m]", (tank.r(1) - Vector(-deepest, 0.5, 0.55)).norm(), 1e-12);
    EXPECT_EQ(tank.u(1), Vector(0, 0, -1));
    EXPECT_EQ(tank.r(2), Vector(-0.04, 0.2, 1.02));
    EXPECT_EQ(taken.energyTaken, 0);
    EXPECT_EQ(taken.impulseGiven, Vector(0, 0, 0));
}

} // namespace
