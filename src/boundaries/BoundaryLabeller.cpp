#include "boundaries/BoundaryLabeller.h"

namespace mpsDem {

namespace {

class Dynamic final : public BoundaryLabeller
{
public:
    Dynamic(Dictionary const& dict, Lattice const& lattice)
        : wetRadius_(lattice.spacing * dict.getInRangeOr("wetRadius", 1.5, 0.5, 3)),
          keepWetRadius_(lattice.spacing * dict.getInRangeOr("keepWetRadius", std::max(1.7, wetRadius_ / lattice.spacing), 0.5, 3))
    {
        require(keepWetRadius_ >= wetRadius_, dict.where("keepWetRadius"), "keepWetRadius is smaller than wetRadius",
                "a wet particle must not dry earlier than it was wetted");
    }

    void label(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const&) const override
    {
        for (int k : particles.wall())
        {
            Real const radius = particles.wet[k] ? keepWetRadius_ : wetRadius_;
            bool wet = false, onlySurface = true;
            for (int m = neighbours.first(k); m < neighbours.last(k); ++m)
            {
                int const j = neighbours.index()[m];
                if (!particles.isFluid(j)) continue;
                Vector const rkj = particles.r[j] - particles.r[k];
                Real const r = rkj.norm();
                if (r >= radius || rkj.dot(particles.normal[k]) <= fluidSide * r) continue;
                wet = true;
                onlySurface = onlySurface && particles.surface[j] == SurfaceLabel::Surface;
            }
            particles.wet[k] = wet;
            particles.surface[k] = wet && onlySurface ? SurfaceLabel::Surface : SurfaceLabel::Interior;
        }
    }

    [[nodiscard]] bool needsAllWalls() const override { return false; }

private:
    static constexpr Real fluidSide = 0.3; ///< Cosine to the normal above which a fluid particle counts as in front.
    Real wetRadius_, keepWetRadius_;
};

class Off final : public BoundaryLabeller
{
public:
    void label(ParticleSet& particles, NeighbourList const&, ReferenceConstants const& constants) const override
    {
        for (int k : particles.wall())
        {
            Real const n = particles.n[k];
            bool const surface = n < 0.8 || (n <= 0.97 && particles.F[k].norm() > 0.9 * constants.planeSurface);
            particles.wet[k] = 1;
            particles.surface[k] = surface ? SurfaceLabel::Surface : SurfaceLabel::Interior;
        }
    }

    [[nodiscard]] bool needsAllWalls() const override { return true; }
};

} // namespace

std::unique_ptr<BoundaryLabeller> BoundaryLabeller::read(Dictionary const& dict, Lattice const& lattice)
{
    if (dict.getWordOr("labelling", "dynamic", {"dynamic", "off"}, "labelling rules") == "dynamic")
        return std::make_unique<Dynamic>(dict, lattice);
    for (char const* key : {"wetRadius", "keepWetRadius"}) dict.ignore(key);
    return std::make_unique<Off>();
}

} // namespace mpsDem
