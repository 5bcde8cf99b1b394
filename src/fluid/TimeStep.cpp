#include "fluid/TimeStep.h"

#include <algorithm>
#include <cmath>

#include "core/Errors.h"
#include "core/Log.h"
#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

/// A step is at most this much longer than the one before.
constexpr Real largestGrowth = 1.1;
constexpr Real percentile = 0.95;

} // namespace

TimeStep::TimeStep(Dictionary const& dict, Lattice const& lattice)
    : lattice_(lattice),
      adjustable_(dict.getOr<bool>("adjustTimeStep", true)),
      deltaT_(dict.getInRange("deltaT", 1e-12, 1e6)),
      maxCo_(dict.getInRangeOr("maxCo", 0.25, 1e-6, 2)),
      maxPressureCo_(dict.getInRangeOr("maxPressureCo", 0.25, 1e-6, 2)),
      maxDeltaT_(dict.getInRangeOr("maxDeltaT", 1e300, 1e-12, 1e300))
{
    if (adjustable_ && deltaT_ > maxDeltaT_)
        warn(dict.where("deltaT").str() + ": deltaT " + shortNumber(deltaT_) + " s is longer than maxDeltaT: the first step has " +
                 shortNumber(maxDeltaT_) + " s at most",
             "deltaT above maxDeltaT", 1);
}

Real TimeStep::limit(ParticleSet const& particles, Real density, Real bodySpeed, Real viscousDt) const
{
    if (!adjustable_) return deltaT_;
    // What is no number stops the run where the step begins (FluidStage), with the name of the particle.
    Real const speed2 = maxOver(particles.fluid(), bodySpeed * bodySpeed, [&](int i) { return particles.u[i].squaredNorm(); }).value;
    Real const l0 = lattice_.spacing;
    Real dt = std::min(maxDeltaT_, viscousDt);
    if (speed2 > 0) dt = std::min(dt, maxCo_ * l0 / std::sqrt(speed2));
    Real const p = pressurePercentile(particles);
    if (p > 0) dt = std::min(dt, maxPressureCo_ * l0 / std::sqrt(p / density));
    return dt;
}

Real TimeStep::next(Real limit, Real last) const { return adjustable_ ? std::min(limit, largestGrowth * last) : limit; }

Real TimeStep::pressurePercentile(ParticleSet const& particles) const
{
    Range const fluid = particles.fluid();
    work_.assign(particles.p.begin() + fluid.first, particles.p.begin() + fluid.last);
    return quantileOverRanks(work_, percentile);
}

TimeStep::Courant TimeStep::courant(ParticleSet const& particles, Real dt) const
{
    Courant result;
    auto const number = [&](int i) { return particles.u[i].norm() * dt / lattice_.spacing; };
    result.mean = sumOver(particles.fluid(), Real(0), number) / std::max(1, sumOverRanks(particles.fluid().size()));
    result.max = maxOver(particles.fluid(), 0, number).value;
    return result;
}

} // namespace mpsDem
