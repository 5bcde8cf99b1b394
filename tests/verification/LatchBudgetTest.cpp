// A latch takes the energy and the momentum of its body out of the motion: both budgets count them.

#include <cmath>

#include "support/RunCase.h"

namespace mpsDem::test {

// A block of 0.4 m x 0.1 m slides in air down a slope of 45 degrees, 0.5 m until a latch locks it.
TEST(LatchBudget, closesWhereALatchLocksASlide)
{
    RunCase run(0.05);
    std::filesystem::remove(run.root() / "constant/transportProperties");
    run.write("system/setParticlesDict", "geometry { slope { type polyline; points ((0 2 0) (2 0 0)); } }");
    run.write("constant/rigidBodyProperties", "bodies { block { shape { type polygon; points ((0.5 1.5 0) (0.8 1.2 0) (0.9 1.3 0)"
                                              " (0.6 1.6 0)); } density 2000; } }");
    run.write("constant/contactProperties",
              "mu 0.1; stoppers { foot { type latch; body block; point (1.1536 0.8464 0); normal (-1 1 0); } }");
    run.control(1, 1e-3, budgetEntry).make();
    auto const energy = [&] {
        RigidBody const& block = run.body();
        Real sum = block.kineticEnergy() + block.mass() * 9.81 * block.centre().y();
        for (auto const& [name, value] : run.scene().ledger().energies()) sum += value;
        return sum;
    };
    auto const momentum = [&] {
        Vector sum = run.body().mass() * run.body().velocity();
        for (auto const& [name, impulse] : run.scene().ledger().impulses()) sum -= impulse;
        return sum;
    };
    run.start();
    Real const before = energy();
    Real heat = 0; // of the contact, when the latch has locked the block
    run.run([&](Scene const& scene, Step const&) {
        if (heat == 0 && run.body().locked()) heat = scene.ledger().energies().at("energy/contactDissipated");
    });
    ASSERT_TRUE(run.body().locked());
    Real const taken = run.scene().ledger().energies().at("energy/latch");
    Real const fallen = run.body().mass() * 9.81 * 0.5 / std::sqrt(2.0);
    expectBetween("block at a latch: energy it took over that of the fall", taken / fallen, 0.88, 0.92); // 1 - mu
    expectBelow("block at a latch: change of the total over the energy it took", (energy() - before) / taken, 0.005);
    Real const later = run.scene().ledger().energies().at("energy/contactDissipated");
    expectBelow("block at a latch: heat of its contact after that, over the energy it took", std::abs(later - heat) / taken, 1e-12);
    expectBelow("block at a latch: momentum residual over weight x 1 s", momentum().norm() / (run.body().mass() * 9.81), 1e-9);
}

} // namespace mpsDem::test
