#pragma once

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type energyBudget;`: where the energy is, over time [J]. No keys of its own.
///
/// Table `energy.dat`: fluidKinetic = sum m u^2/2, fluidPotential = -sum m g.r, bodyKinetic (rotation included), bodyPotential, each entry
/// of the energy ledger under its own name (collision, contactDissipated, contactStored, latch, ...: energy taken out of the motion), total =
/// the sum of all, and change = total less that at the start. Columns of an absent effect are absent. What the ledger does not know
/// (viscosity, truncation, the work of prescribed motions) remains in `change`.
class EnergyBudget : public FunctionObject
{
public:
    EnergyBudget(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override { table_.printLast(os); }
    void save(State& state) const override;
    void load(State const& state) override;

private:
    /// Values of all columns but the last two.
    [[nodiscard]] std::vector<Real> parts() const;
    [[nodiscard]] Real total() const;

    RunContext const& context_;
    std::string block_;
    Real start_; ///< Total at the start of the run [J].
    TableFile table_;
};

} // namespace mpsDem
