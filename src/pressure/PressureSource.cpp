#include "pressure/PressureSource.h"

#include <algorithm>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// Share of n in the balanced density. A disordered cloud in 3-D has n up to 1 % below that of a lattice of the same density, and the
/// smooth density some 0.5 % above it: with this share both together tell its volume (etc/doc/three-dimensions.md).
constexpr Real balancedShare = 0.3;

} // namespace

PressureSource::PressureSource(Dictionary const& dict, SchemeSet set, Lattice const& lattice, Real gradientRadius, Real density)
    : density_(density)
{
    bool const paper = set == SchemeSet::Paper, waves = set == SchemeSet::Waves;
    bool const inSpace = lattice.dimensions == 3, corrected = waves || (!paper && inSpace);
    std::string const type = dict.getWordOr("type", "mixed", {"mixed", "density", "divergence"}, "source schemes");
    type_ = type == "density" ? Type::Density : type == "divergence" ? Type::Divergence : Type::Mixed;
    corrected_ = dict.getWordOr("divergence", corrected ? "corrected" : "plain", {"plain", "corrected"}, "forms of eq 5") == "corrected";
    std::string const usual = corrected && inSpace ? "balanced" : corrected ? "smooth" : "number";
    std::string const measure = dict.getWordOr("density", usual, {"number", "smooth", "balanced"}, "measures of density");
    if (measure != "number") smooth_.emplace(lattice, gradientRadius);
    if (measure == "balanced") numberShare_ = balancedShare;
    char const* const idle = type_ == Type::Density && corrected_ ? "divergence" : type_ == Type::Divergence && smooth_ ? "density" : "";
    require(*idle == 0, dict.where(idle), "type " + type + " has no " + idle + " whose form could be chosen",
            "type mixed, or no such entry");
    bool const fixedGamma = dict.found("gamma") && !dict.found("relaxationTime");
    relaxationTime_ = dict.getInRangeOr("relaxationTime", paper || fixedGamma ? 0 : waves ? 0.02 : 0.05, 0, 10);
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

Real PressureSource::densityError(ParticleSet const& particles, NeighbourList const& neighbours, int i) const
{
    bool const smooth = smooth_ && particles.surface[i] != SurfaceLabel::NearSurface;
    Real const share = smooth ? numberShare_ : 1;
    Real const e = share * particles.n[i] + (smooth ? (1 - share) * (*smooth_)(particles, neighbours, i) : 0) - 1;
    return clip_ > 0 ? std::clamp(e, -clip_, clip_) : e;
}

Real PressureSource::evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                              Step const& step, int i) const
{
    Real const dt = step.dt, rho = density_;
    Real const g = gamma(step);
    Real source = 0;
    auto const uStar = [&](int j) -> Vector const& { return particles.uStar[j]; };
    if (type_ != Type::Density) source += (1 - g) * rho / dt * divergence(particles, neighbours, constants, uStar, i);
    if (type_ != Type::Divergence && particles.isFluid(i)) source -= g * rho / (dt * dt) * densityError(particles, neighbours, i);
    return source;
}

} // namespace mpsDem
