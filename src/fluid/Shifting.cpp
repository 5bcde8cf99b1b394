#include "fluid/Shifting.h"

#include <algorithm>

namespace mpsDem {

namespace {

/// Courant number from which a particle is shifted by the whole coefficient.
constexpr Real fullCourant = 0.05;

/// Sum of the surface vectors of the surface particles around i: the direction out of the fluid there.
Vector outwards(ParticleSet const& particles, NeighbourList const& neighbours, int i)
{
    Vector sum = Vector::Zero();
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        bool const surface = particles.isFluid(j) && particles.surface[j] == SurfaceLabel::Surface;
        if (surface && neighbours.gradientWeight()[k] > 0) sum += particles.F[j];
    }
    return sum;
}

} // namespace

std::unique_ptr<Shifting> Shifting::read(Dictionary const& dict, SchemeSet set, Lattice const& lattice)
{
    std::string const type =
        dict.getWordOr("type", set == SchemeSet::Paper ? "none" : "surfaceVector", {"surfaceVector", "none"}, "shifting schemes");
    if (type == "none")
    {
        for (char const* key : {"coefficient", "limit", "minDensity", "minSurfaceDensity"}) dict.ignore(key);
        return nullptr;
    }
    return std::unique_ptr<Shifting>(new Shifting(dict, lattice));
}

Shifting::Shifting(Dictionary const& dict, Lattice const& lattice)
    : spacing_(lattice.spacing),
      factor_(lattice.spacing * dict.getInRangeOr("coefficient", 0.2, 0, 1)),
      limit_(lattice.spacing * dict.getInRangeOr("limit", 0.1, 0, 0.5)),
      minDensity_(dict.getInRangeOr("minDensity", 0.8, 0, 1)),
      minSurfaceDensity_(dict.getInRangeOr("minSurfaceDensity", 0.5, 0, 1))
{}

Shifting::Kind Shifting::kindOf(ParticleSet const& particles, int i) const
{
    if (!particles.isFluid(i)) return Kind::Fixed;
    if (particles.surface[i] == SurfaceLabel::Surface) return particles.n[i] > minSurfaceDensity_ ? Kind::Surface : Kind::Fixed;
    return particles.n[i] > minDensity_ ? Kind::Below : Kind::Fixed;
}

Field<Vector>& Shifting::propose(ParticleSet const& particles, NeighbourList const& neighbours, Real dt)
{
    proposed_.reserve(particles.r.capacity());
    proposed_.assign(particles.r.size(), Vector::Zero());
    for (int i : particles.fluid())
    {
        if (kindOf(particles, i) == Kind::Fixed) continue;
        Real const courant = particles.u[i].norm() * dt / spacing_;
        Vector shift = factor_ * (0.5 + 0.5 * std::min(Real(1), courant / fullCourant)) * particles.F[i];
        if (particles.surface[i] != SurfaceLabel::Interior)
        {
            Vector const normal = outwards(particles, neighbours, i);
            Real const length2 = normal.squaredNorm();
            if (length2 > 1e-18) shift -= shift.dot(normal) / length2 * normal;
        }
        proposed_[i] = shift;
    }
    return proposed_;
}

void Shifting::apply(ParticleSet& particles, NeighbourList const& neighbours) const
{
    Real const* const w = neighbours.gradientWeight();
    for (int i : particles.fluid())
    {
        Kind const kind = kindOf(particles, i);
        if (kind == Kind::Fixed) continue;
        Vector sum = Vector::Zero();
        Real weight = 0;
        int alike = 0;
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            int const j = neighbours.index()[k];
            if (kindOf(particles, j) != kind) continue;
            sum += w[k] * proposed_[j];
            weight += w[k];
            ++alike;
        }
        if (kind == Kind::Surface && alike < 2) continue; // the edge of a jet
        Vector const shift = weight > 0 ? Vector(proposed_[i] - sum / weight) : proposed_[i];
        Real const length = shift.norm();
        particles.r[i] += length > limit_ ? Vector(limit_ / length * shift) : shift;
    }
}

} // namespace mpsDem
