#include "fluid/Fluid.h"

#include <algorithm>

namespace mpsDem {

Fluid::Fluid(Dictionary const& schemes, SchemeSet set, Lattice const& lattice, Radii const& radii, Real density, Real nu,
             Vector const& gravity, Real largestDt, Ledger& ledger)
    : gradientConstants_(referenceConstants(lattice, radii.gradient)),
      laplacianConstants_(referenceConstants(lattice, radii.laplacian)),
      density_(density),
      nu_(nu),
      gravity_(gravity),
      gradient_(GradientScheme::read(schemes.subDictOrEmpty("gradSchemes"), set)),
      freeSurface_(FreeSurface::read(schemes.subDictOrEmpty("freeSurfaceSchemes"), set, lattice)),
      viscosity_(Viscosity::read(schemes.subDictOrEmpty("viscositySchemes"), lattice, nu, largestDt)),
      collision_(Collision::read(schemes.subDictOrEmpty("collisionSchemes"), set, lattice, density, ledger)),
      shifting_(Shifting::read(schemes.subDictOrEmpty("shiftingSchemes"), set, lattice)),
      surfaceDamping_(SurfaceDamping::read(schemes.subDictOrEmpty("freeSurfaceSchemes"), set, lattice, radii.gradient, gravity.norm())),
      velocityDamping_(
          VelocityDamping::read(schemes.subDictOrEmpty("velocityDamping"), set, lattice, gradientConstants_.n0, gravity.norm()))
{
    Dictionary const limiters = schemes.subDictOrEmpty("limiters");
    displacementLimit_ = lattice.spacing * limiters.getInRangeOr("displacement", set == SchemeSet::Paper ? 0 : 0.1, 0, 1);
    std::string const word = limiters.getWordOr("negativePressure", "clamp", {"clamp", "interior", "keep"}, "rules for negative pressure");
    negativePressure_ = word == "clamp"      ? NegativePressure::Clamp
                        : word == "interior" ? NegativePressure::Interior
                                             : NegativePressure::Keep;
}

void Fluid::predict(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt)
{
    for (int i : particles.fluid()) particles.uStar[i] = particles.u[i] + dt * gravity_;
    if (surfaceDamping_) surfaceDamping_->addTo(particles, neighbours, dt);
    if (velocityDamping_) velocityDamping_->addTo(particles, neighbours, images, dt);
    if (viscosity_) viscosity_->addTo(particles, neighbours, images, laplacianConstants_, dt);
}

void Fluid::clampPressure(ParticleSet& particles, NeighbourList const& neighbours) const
{
    if (negativePressure_ == NegativePressure::Keep) return;
    bool const everywhere = negativePressure_ == NegativePressure::Clamp;
    auto const besideSurface = [&](int i) {
        if (particles.isFluid(i)) return particles.surface[i] != SurfaceLabel::Interior;
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            int const j = neighbours.index()[k];
            if (particles.isFluid(j) && particles.surface[j] == SurfaceLabel::Surface) return true;
        }
        return false;
    };
    for (int i : particles.owned())
        if (particles.p[i] < 0 && (everywhere || besideSurface(i))) particles.p[i] = 0;
}

void Fluid::correct(ParticleSet& particles, NeighbourList const& neighbours, Real dt)
{
    pressureGradient_.resize(particles.r.size());
    gradient_->evaluate(particles, neighbours, gradientConstants_, pressureGradient_);
    limitedNow_ = 0;
    for (int i : particles.fluid())
    {
        Vector acceleration = -pressureGradient_[i] / density_;
        Real const displacement = acceleration.norm() * dt * dt;
        if (displacementLimit_ > 0 && displacement > displacementLimit_)
        {
            acceleration *= displacementLimit_ / displacement;
            ++limitedNow_;
        }
        particles.u[i] = particles.uStar[i] + dt * acceleration;
        particles.r[i] += dt * particles.u[i];
    }
    limited_ += limitedNow_;
}

void Fluid::collide(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt)
{
    if (collision_) collision_->apply(particles, neighbours, images, dt);
}

} // namespace mpsDem
