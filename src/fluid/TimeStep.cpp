#include "fluid/TimeStep.h"

#include <algorithm>
#include <cmath>

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
{}

Real TimeStep::next(ParticleSet const& particles, Real density, Real last, Real bodySpeed, Real viscousDt) const
{
    if (!adjustable_) return deltaT_;
    Real speed2 = bodySpeed * bodySpeed;
    for (int i : particles.fluid()) speed2 = std::max(speed2, particles.u[i].squaredNorm());
    Real const l0 = lattice_.spacing;
    Real dt = std::min({maxDeltaT_, viscousDt, largestGrowth * last});
    if (speed2 > 0) dt = std::min(dt, maxCo_ * l0 / std::sqrt(speed2));
    Real const p = particles.fluid().size() > 0 ? pressurePercentile(particles) : 0;
    if (p > 0) dt = std::min(dt, maxPressureCo_ * l0 / std::sqrt(p / density));
    return dt;
}

Real TimeStep::pressurePercentile(ParticleSet const& particles) const
{
    Range const fluid = particles.fluid();
    work_.assign(particles.p.begin() + fluid.first, particles.p.begin() + fluid.last);
    auto const nth = work_.begin() + static_cast<std::ptrdiff_t>(percentile * static_cast<Real>(work_.size() - 1));
    std::nth_element(work_.begin(), nth, work_.end());
    return *nth;
}

TimeStep::Courant TimeStep::courant(ParticleSet const& particles, Real dt) const
{
    Courant result;
    for (int i : particles.fluid())
    {
        Real const c = particles.u[i].norm() * dt / lattice_.spacing;
        result.mean += c;
        result.max = std::max(result.max, c);
    }
    result.mean /= std::max(1, particles.fluid().size());
    return result;
}

} // namespace mpsDem
