#include "pressure/PressureSource.h"

#include <algorithm>

namespace mpsDem {

PressureSource::PressureSource(Dictionary const& dict, SchemeSet set, Real density) : density_(density)
{
    bool const paper = set == SchemeSet::Paper;
    std::string const type = dict.getWordOr("type", "mixed", {"mixed", "density", "divergence"}, "source schemes");
    type_ = type == "density" ? Type::Density : type == "divergence" ? Type::Divergence : Type::Mixed;
    bool const fixedGamma = dict.found("gamma") && !dict.found("relaxationTime");
    relaxationTime_ = dict.getInRangeOr("relaxationTime", paper || fixedGamma ? 0 : 0.05, 0, 10);
    gamma_ = dict.getInRangeOr("gamma", 0.01, 0, 1);
    maxGamma_ = dict.getInRangeOr("maxGamma", 0.1, 0, 1);
    clip_ = dict.getInRangeOr("densityClip", 0, 0, 1);
    rampSteps_ = static_cast<int>(dict.getInRangeOr("rampSteps", paper ? 0 : 20, 0, 1000));
}

Real PressureSource::gamma(Step const& step) const
{
    if (type_ == Type::Divergence) return 0;
    Real const full = relaxationTime_ > 0 ? std::min(step.dt / relaxationTime_, maxGamma_) : gamma_;
    Real const ramp = rampSteps_ > 0 ? std::min(Real(1), static_cast<Real>(step.number) / rampSteps_) : 1;
    return ramp * full;
}

Real PressureSource::evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                              Step const& step, int i) const
{
    Real const dt = step.dt, rho = density_;
    Real const g = gamma(step);
    Real source = 0;
    if (type_ != Type::Density) source += (1 - g) * rho / dt * divergence(particles, neighbours, constants, particles.uStar, i);
    if (type_ != Type::Divergence && particles.isFluid(i))
    {
        Real e = particles.n[i] - 1;
        if (clip_ > 0) e = std::clamp(e, -clip_, clip_);
        source -= g * rho / (dt * dt) * e;
    }
    return source;
}

} // namespace mpsDem
