#include "pressure/SurfacePressure.h"

#include <algorithm>

#include "particles/Gradient.h"
#include "particles/GradientSums.h"

namespace mpsDem {

namespace {

bool isOnSurface(ParticleSet const& particles, int i)
{
    return particles.surface[i] == SurfaceLabel::Surface && (particles.isFluid(i) || particles.wet[i]);
}

/// The formula of the class for a fluid particle on the surface, before the average [Pa].
template <int d>
Real halfSpacing(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants, int i)
{
    Real const length = particles.F[i].norm();
    if (length < tiny) return 0;
    GradientSums<d> sums;
    Real largest = 0;
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        if (!particles.isFluid(j) && !(particles.type[j] == ParticleType::Wall && particles.wet[j])) continue;
        sums.add(particles.r[j] - particles.r[i], particles.p[i], particles.p[j], neighbours.gradientWeight()[k]);
        largest = std::max(largest, particles.p[j]);
    }
    Vector gradient;
    if (!sums.corrected(d / constants.n0, gradient)) return 0;
    Real const slope = -gradient.dot(particles.F[i]) / length;
    return std::clamp(0.5 * particles.lattice().spacing * slope, Real(0), 0.5 * largest);
}

} // namespace

std::unique_ptr<SurfacePressure> SurfacePressure::read(Dictionary const& freeSurfaceSchemes, Dictionary const& gradSchemes, SchemeSet set)
{
    bool const consistent = GradientScheme::readName(gradSchemes, set) == "corrected";
    std::string const word =
        freeSurfaceSchemes.getWordOr("pressure", consistent ? "halfSpacing" : "zero", {"halfSpacing", "zero"}, "surface pressures");
    return word == "zero" ? nullptr : std::make_unique<SurfacePressure>();
}

void SurfacePressure::average(ParticleSet const& particles, NeighbourList const& neighbours, int i)
{
    Real weight = particles.isFluid(i) ? 1 : 0, sum = single_[i];
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        if (!particles.isFluid(j) || particles.surface[j] != SurfaceLabel::Surface) continue;
        Real const w = neighbours.gradientWeight()[k];
        sum += w * single_[j];
        weight += w;
    }
    value_[i] = weight > 0 ? sum / weight : 0;
}

void SurfacePressure::evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                               PeriodicImages const& images)
{
    single_.reserve(particles.r.capacity());
    value_.reserve(particles.r.capacity());
    single_.assign(particles.r.size(), 0);
    value_.assign(particles.r.size(), 0);
    bool const flat = particles.lattice().dimensions == 2;
    for (int i : particles.fluid())
    {
        if (particles.surface[i] != SurfaceLabel::Surface) continue;
        single_[i] = flat ? halfSpacing<2>(particles, neighbours, constants, i) : halfSpacing<3>(particles, neighbours, constants, i);
    }
    images.update(single_, particles.halo());
    for (int i : particles.owned())
        if (isOnSurface(particles, i)) average(particles, neighbours, i);
    images.update(value_, particles.halo());
}

void SurfacePressure::assign(ParticleSet& particles) const
{
    for (int i : particles.owned())
        if (isOnSurface(particles, i)) particles.p[i] = value_[i];
}

} // namespace mpsDem
