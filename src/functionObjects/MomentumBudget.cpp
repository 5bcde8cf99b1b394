#include "functionObjects/MomentumBudget.h"

#include <limits>

#include "functionObjects/Observed.h"

namespace mpsDem {

namespace {

std::vector<std::string> columnsFor(RunContext const& context)
{
    std::vector<std::string> columns;
    if (context.particles.fluid().size() > 0) addVectorColumns(columns, "fluid");
    if (!context.bodies.empty()) addVectorColumns(columns, "bodies");
    for (auto const& [name, value] : context.ledger.impulses()) addVectorColumns(columns, name.substr(name.find('/') + 1));
    addVectorColumns(columns, "residual");
    columns.emplace_back("share");
    return columns;
}

} // namespace

MomentumBudget::MomentumBudget(std::string const& name, Dictionary const&, RunContext const& context)
    : context_(context),
      block_("functionObject/" + name + "/start"),
      start_(balance()),
      table_(makeTable(context, name, "momentum", columnsFor(context),
                       {"Momenta and external impulses since the start [N s]",
                        "residual: change of momentum without an impulse from outside; share: of the weight during 1 s [-]"}))
{}

Vector MomentumBudget::fluidMomentum() const
{
    ParticleSet const& particles = context_.particles;
    Vector sum = Vector::Zero();
    for (int i : particles.fluid()) sum += particles.u[i];
    return context_.density * particles.lattice().particleVolume() * sum;
}

Vector MomentumBudget::bodyMomentum() const
{
    Vector sum = Vector::Zero();
    for (auto const& body : context_.bodies) sum += body->mass() * body->velocity();
    return sum;
}

Vector MomentumBudget::balance() const
{
    Vector sum = fluidMomentum() + bodyMomentum();
    for (auto const& [name, impulse] : context_.ledger.impulses()) sum -= impulse;
    return sum;
}

Real MomentumBudget::weight() const
{
    Real mass = fluidMass(context_);
    if (context_.particles.fluid().size() == 0)
        for (auto const& body : context_.bodies) mass += body->mass();
    return mass * context_.gravity.norm();
}

void MomentumBudget::write(Step const& step)
{
    std::vector<Real> row;
    if (context_.particles.fluid().size() > 0) addVector(row, fluidMomentum());
    if (!context_.bodies.empty()) addVector(row, bodyMomentum());
    for (auto const& [name, impulse] : context_.ledger.impulses()) addVector(row, impulse);
    Vector const residual = balance() - start_;
    addVector(row, residual);
    row.push_back(weight() > 0 ? residual.norm() / weight() : std::numeric_limits<Real>::quiet_NaN());
    table_.add(step.time, row);
}

void MomentumBudget::save(State& state) const { state.set(block_, start_); }

void MomentumBudget::load(State const& state) { start_ = state.has(block_) ? state.vector(block_) : balance(); }

} // namespace mpsDem
