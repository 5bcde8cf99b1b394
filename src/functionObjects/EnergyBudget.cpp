#include "functionObjects/EnergyBudget.h"

#include <numeric>

#include "functionObjects/Observed.h"
#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

std::vector<std::string> columnsFor(RunContext const& context)
{
    std::vector<std::string> columns;
    if (context.particles.fluid().size() > 0) columns = {"fluidKinetic", "fluidPotential"};
    if (!context.bodies.empty()) columns.insert(columns.end(), {"bodyKinetic", "bodyPotential"});
    for (auto const& [name, value] : context.ledger.energies()) columns.push_back(name.substr(name.find('/') + 1));
    columns.insert(columns.end(), {"total", "change"});
    return columns;
}

} // namespace

EnergyBudget::EnergyBudget(std::string const& name, Dictionary const&, RunContext const& context)
    : context_(context),
      block_("functionObject/" + name + "/start"),
      start_(total()),
      table_(makeTable(context, name, "energy", columnsFor(context), {"Energies [J]; change: of the total since the start"}))
{}

std::vector<Real> EnergyBudget::parts() const
{
    std::vector<Real> values;
    ParticleSet const& particles = context_.particles;
    if (particles.fluid().size() > 0)
    {
        Real const mass = context_.density * particles.lattice().particleVolume();
        auto const kineticOf = [&](int i) { return 0.5 * mass * particles.u[i].squaredNorm(); };
        auto const potentialOf = [&](int i) { return -(mass * context_.gravity.dot(particles.r[i])); };
        Real const kinetic = sumOver(particles.fluid(), Real(0), kineticOf);
        Real const potential = sumOver(particles.fluid(), Real(0), potentialOf);
        values = {kinetic, potential};
    }
    if (!context_.bodies.empty())
    {
        Real kinetic = 0, potential = 0;
        for (auto const& body : context_.bodies)
        {
            kinetic += body->kineticEnergy();
            potential -= body->mass() * context_.gravity.dot(body->centre());
        }
        values.insert(values.end(), {kinetic, potential});
    }
    for (auto const& [name, value] : context_.ledger.energies()) values.push_back(value);
    return values;
}

Real EnergyBudget::total() const
{
    std::vector<Real> const values = parts();
    return std::accumulate(values.begin(), values.end(), Real(0));
}

void EnergyBudget::write(Step const& step)
{
    std::vector<Real> row = parts();
    Real const sum = std::accumulate(row.begin(), row.end(), Real(0));
    row.insert(row.end(), {sum, sum - start_});
    table_.add(step.time, row);
}

void EnergyBudget::save(State& state) const { state.set(block_, start_); }

void EnergyBudget::load(State const& state) { start_ = state.has(block_) ? state.real(block_) : total(); }

} // namespace mpsDem
