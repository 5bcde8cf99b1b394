#include "functionObjects/MomentumBudget.h"

#include <limits>
#include <sstream>

#include "functionObjects/Observed.h"
#include "parallel/Reduce.h"

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
      name_(name),
      block_("functionObject/" + name + "/"),
      startTime_(context.startTime),
      table_(newTable())
{
    startNow();
}

void MomentumBudget::startNow()
{
    start_ = balance();
    startLedger_ = context_.ledger.impulses();
}

TableFile MomentumBudget::newTable() const
{
    std::ostringstream since;
    since << "Momenta, and impulses from outside since t = " << startTime_ << " s, where this table's sums begin [N s]";
    return makeTable(context_, name_, "momentum", columnsFor(context_),
                     {since.str(), "residual: change of momentum without an impulse from outside; share: of the weight during 1 s [-]"});
}

Vector MomentumBudget::fluidMomentum() const
{
    ParticleSet const& particles = context_.particles;
    Vector const sum = sumOver(particles.fluid(), Vector(Vector::Zero()), [&](int i) { return particles.u[i]; });
    return context_.density * particles.lattice().particleVolume() * sum;
}

Vector MomentumBudget::bodyMomentum() const
{
    Vector sum = Vector::Zero();
    for (auto const& body : context_.bodies) sum += body->momentum();
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
    for (auto const& [name, impulse] : context_.ledger.impulses())
    {
        auto const before = startLedger_.find(name);
        addVector(row, before == startLedger_.end() ? impulse : Vector(impulse - before->second));
    }
    Vector const residual = balance() - start_;
    addVector(row, residual);
    row.push_back(weight() > 0 ? residual.norm() / weight() : std::numeric_limits<Real>::quiet_NaN());
    table_.add(step.time, row);
}

void MomentumBudget::save(State& state) const
{
    state.set(block_ + "start", start_);
    state.set(block_ + "startTime", startTime_);
    for (auto const& [name, impulse] : startLedger_) state.set(block_ + name, impulse);
}

void MomentumBudget::load(State const& state)
{
    startNow();
    if (state.has(block_ + "start"))
    {
        start_ = state.vector(block_ + "start");
        startTime_ = state.real(block_ + "startTime");
        startLedger_.clear();
        for (auto const& [name, impulse] : context_.ledger.impulses())
            if (state.has(block_ + name)) startLedger_[name] = state.vector(block_ + name);
    }
    table_ = newTable();
}

} // namespace mpsDem
