#include "fluid/VelocityDamping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles/GradientSums.h"

namespace mpsDem {

namespace {

/// Largest share of a deviation that one step takes away.
constexpr Real largestShare = 0.5;

} // namespace

std::unique_ptr<VelocityDamping> VelocityDamping::read(Dictionary const& velocityDamping, SchemeSet set, Lattice const& lattice, Real n0,
                                                       Real gravity)
{
    std::string const type =
        velocityDamping.getWordOr("type", set == SchemeSet::Waves ? "deviation" : "none", {"deviation", "none"}, "dampings of velocity");
    Real const coefficient = velocityDamping.getInRangeOr("coefficient", 1, 0, 10);
    if (type == "none" || coefficient <= 0 || gravity <= 0) return nullptr;
    Real const rate = coefficient * std::sqrt(std::numbers::pi * gravity / lattice.spacing);
    return std::unique_ptr<VelocityDamping>(new VelocityDamping(rate, n0));
}

template <int d>
void VelocityDamping::findGradients(ParticleSet const& particles, NeighbourList const& neighbours)
{
    int const* const index = neighbours.index();
    Real const* const w = neighbours.gradientWeight();
    Real const factor = d / n0_;
    for (int i : particles.fluid())
    {
        Vector const ri = particles.r[i], ui = particles.u[i];
        MomentSum<d> moment;
        Tensor slope = Tensor::Zero();
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            int const j = index[k];
            if (!particles.isFluid(j)) continue;
            Vector const rij = particles.r[j] - ri;
            Real const q = w[k] / (rij.squaredNorm() + tiny);
            moment.add(rij, q);
            slope.noalias() += q * (particles.u[j] - ui) * rij.transpose();
        }
        typename MomentSum<d>::Square c;
        defined_[i] = particles.surface[i] != SurfaceLabel::Surface && moment.invert(factor, c);
        if (!defined_[i]) continue;
        gradient_[i].setZero();
        gradient_[i].template leftCols<d>() = factor * slope.template leftCols<d>() * c;
    }
}

void VelocityDamping::addTo(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt)
{
    gradient_.reserve(particles.r.capacity());
    gradient_.resize(particles.r.size());
    defined_.reserve(particles.r.capacity());
    defined_.assign(particles.r.size(), 0);
    if (particles.lattice().dimensions == 2)
        findGradients<2>(particles, neighbours);
    else
        findGradients<3>(particles, neighbours);
    images.update(gradient_, particles.halo());
    images.update(defined_, particles.halo());
    int const* const index = neighbours.index();
    Real const* const w = neighbours.gradientWeight();
    Real const share = std::min(dt * rate_, largestShare) / n0_;
    for (int i : particles.fluid())
    {
        if (!defined_[i]) continue;
        Vector const ri = particles.r[i], ui = particles.u[i];
        Tensor const& gradient = gradient_[i];
        Vector sum = Vector::Zero();
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            int const j = index[k];
            if (w[k] <= 0 || !defined_[j]) continue;
            sum += w[k] * (particles.u[j] - ui - 0.5 * ((gradient + gradient_[j]) * (particles.r[j] - ri)));
        }
        particles.uStar[i] += share * sum;
    }
}

} // namespace mpsDem
