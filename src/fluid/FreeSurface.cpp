#include "fluid/FreeSurface.h"

#include <cmath>
#include <numbers>

namespace mpsDem {

namespace {

/// Sweeps a test (i) -> bool over the fluid.
template <class Test>
void label(ParticleSet& particles, Test isSurface)
{
    for (int i : particles.fluid()) particles.surface[i] = isSurface(i) ? SurfaceLabel::Surface : SurfaceLabel::Interior;
}

class Cone final : public FreeSurface
{
public:
    Cone(Dictionary const& dict, Lattice const& lattice)
        : lowDensity_(dict.getInRangeOr("lowDensity", lattice.dimensions == 2 ? 0.7 : 0.65, 0, 1)),
          threshold_(dict.getInRangeOr("vectorThreshold", 0.5, 0, 2)),
          radius_(lattice.spacing * dict.getInRangeOr("coneRadius", 2.1, 1, 4)),
          cosine_(std::cos(std::numbers::pi / 180 * dict.getInRangeOr("coneAngle", 45, 10, 90)))
    {}

    void mark(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& constants) const override
    {
        Real const longVector = threshold_ * constants.planeSurface;
        label(particles, [&](int i) {
            if (particles.n[i] < lowDensity_) return true;
            Real const length = particles.F[i].norm();
            return length > longVector && isOpen(particles, neighbours, i, particles.F[i] / length);
        });
    }

    [[nodiscard]] bool isOpen(ParticleSet const& particles, NeighbourList const& neighbours, int i, Vector const& outwards) const
    {
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            Vector const rij = particles.r[neighbours.index()[k]] - particles.r[i];
            Real const r = rij.norm();
            if (r < radius_ && rij.dot(outwards) > cosine_ * r) return false;
        }
        return true;
    }

    Real lowDensity_, threshold_, radius_, cosine_;
};

class Sjtu final : public FreeSurface
{
public:
    explicit Sjtu(Dictionary const& dict)
        : lowDensity_(dict.getInRangeOr("lowDensity", 0.8, 0, 1)),
          highDensity_(dict.getInRangeOr("highDensity", 0.97, 0, 2)),
          threshold_(dict.getInRangeOr("vectorThreshold", 0.9, 0, 2))
    {}

    void mark(ParticleSet& particles, NeighbourList const&, ReferenceConstants const& constants) const override
    {
        Real const longVector = threshold_ * constants.planeSurface;
        label(particles, [&](int i) {
            return particles.n[i] < lowDensity_ || (particles.n[i] <= highDensity_ && particles.F[i].norm() > longVector);
        });
    }

    Real lowDensity_, highDensity_, threshold_;
};

class DensityOnly final : public FreeSurface
{
public:
    explicit DensityOnly(Dictionary const& dict) : lowDensity_(dict.getInRangeOr("lowDensity", 0.97, 0, 1)) {}

    void mark(ParticleSet& particles, NeighbourList const&, ReferenceConstants const&) const override
    {
        label(particles, [&](int i) { return particles.n[i] < lowDensity_; });
    }

    Real lowDensity_;
};

class NoSurface final : public FreeSurface
{
public:
    void mark(ParticleSet& particles, NeighbourList const&, ReferenceConstants const&) const override
    {
        label(particles, [](int) { return false; });
    }
};

} // namespace

std::unique_ptr<FreeSurface> FreeSurface::read(Dictionary const& dict, SchemeSet set, Lattice const& lattice)
{
    std::string const type = dict.getWordOr("type", set == SchemeSet::Paper ? "sjtu" : "cone", {"cone", "sjtu", "numberDensity", "none"},
                                            "free-surface schemes");
    if (type == "sjtu") return std::make_unique<Sjtu>(dict);
    if (type == "numberDensity") return std::make_unique<DensityOnly>(dict);
    if (type == "none") return std::make_unique<NoSurface>();
    return std::make_unique<Cone>(dict, lattice);
}

void markNearSurface(ParticleSet& particles, NeighbourList const& neighbours)
{
    auto const isSurface = [&](int j) { return particles.isFluid(j) && particles.surface[j] == SurfaceLabel::Surface; };
    for (int i : particles.fluid())
    {
        if (particles.surface[i] == SurfaceLabel::Surface) continue;
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            if (neighbours.gradientWeight()[k] <= 0 || !isSurface(neighbours.index()[k])) continue;
            particles.surface[i] = SurfaceLabel::NearSurface;
            break;
        }
    }
}

} // namespace mpsDem
