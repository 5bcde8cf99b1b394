#include "fluid/Shifting.h"

namespace mpsDem {

namespace {

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
        for (char const* key : {"coefficient", "limit", "minDensity"}) dict.ignore(key);
        return nullptr;
    }
    return std::unique_ptr<Shifting>(new Shifting(dict, lattice));
}

Shifting::Shifting(Dictionary const& dict, Lattice const& lattice)
    : factor_(lattice.spacing * dict.getInRangeOr("coefficient", 0.2, 0, 1)),
      limit_(lattice.spacing * dict.getInRangeOr("limit", 0.1, 0, 0.5)),
      minDensity_(dict.getInRangeOr("minDensity", 0.8, 0, 1))
{}

void Shifting::apply(ParticleSet& particles, NeighbourList const& neighbours) const
{
    for (int i : particles.fluid())
    {
        if (particles.surface[i] == SurfaceLabel::Surface || particles.n[i] <= minDensity_) continue;
        Vector shift = factor_ * particles.F[i];
        if (particles.surface[i] == SurfaceLabel::NearSurface)
        {
            Vector const normal = outwards(particles, neighbours, i);
            Real const length2 = normal.squaredNorm();
            if (length2 > 1e-18) shift -= shift.dot(normal) / length2 * normal;
        }
        Real const length = shift.norm();
        particles.r[i] += length > limit_ ? Vector(limit_ / length * shift) : shift;
    }
}

} // namespace mpsDem
