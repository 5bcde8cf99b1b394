#pragma once

#include <map>

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type momentumBudget;`: does the momentum of water and bodies change by the impulses that act on them from outside? No keys of its own.
///
/// \f[ \mathbf R = \mathbf P(t)-\mathbf P(0)-\sum_k\mathbf J_k,\qquad \mathbf P=\sum_i m\,\mathbf u_i+\sum_b M_b\mathbf V_b \f]
/// with the external impulses J_k of the ledger (gravity, walls, collisions with walls, contact and supports). M_b V_b includes what particles that
/// struck a body still have to hand over to it. Pressure between water and bodies is internal:
/// what the two sides feel differently appears in R.
/// P(0) and the sums J_k are those of the first run with this object: one that is added to a run at its restart begins there, with J_k = 0, and
/// the head of the table tells the time.
/// Table `momentum.dat` [N s]: fluidx y z, bodies.., each ledger entry.., residual.., share = |R| / (m g 1 s), with m g the weight of the
/// water (of the bodies where there is none); nan without gravity. Columns of an absent effect are absent.
class MomentumBudget : public FunctionObject
{
public:
    MomentumBudget(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override { table_.printLast(os); }
    void save(State& state) const override;
    void load(State const& state) override;

private:
    [[nodiscard]] Vector fluidMomentum() const;
    [[nodiscard]] Vector bodyMomentum() const;
    /// P less all impulses [N s].
    [[nodiscard]] Vector balance() const;
    [[nodiscard]] Real weight() const;
    /// Takes the present state as the start.
    void startNow();
    [[nodiscard]] TableFile newTable() const;

    RunContext const& context_;
    std::string name_, block_;
    Real startTime_;                            ///< Time from which impulses count [s].
    Vector start_;                              ///< Balance at that time.
    std::map<std::string, Vector> startLedger_; ///< Impulses of the ledger at that time [N s].
    TableFile table_;
};

} // namespace mpsDem
