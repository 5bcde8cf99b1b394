#include "particles/Gradient.h"

#include "particles/GradientSums.h"

namespace mpsDem {

namespace {

struct Symmetric
{
    static bool corrects(SurfaceLabel) { return false; }
};
struct Corrected
{
    static bool corrects(SurfaceLabel) { return true; }
};
struct Hybrid
{
    static bool corrects(SurfaceLabel label) { return label == SurfaceLabel::Interior; }
};

template <class Rule>
class Scheme final : public GradientScheme
{
public:
    void evaluate(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                  Field<Vector>& gradient) const override
    {
        if (particles.lattice().dimensions == 2)
            sweep<2>(particles, neighbours, constants, gradient);
        else
            sweep<3>(particles, neighbours, constants, gradient);
    }

private:
    template <int d>
    static void sweep(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants,
                      Field<Vector>& gradient)
    {
        int const* const index = neighbours.index();
        Real const* const w = neighbours.gradientWeight();
        Real const factor = d / constants.n0;
        for (int i : particles.fluid())
        {
            Vector const ri = particles.r[i];
            Real const pi = particles.p[i];
            GradientSums<d> sums;
            for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
            {
                int const j = index[k];
                sums.add(particles.r[j] - ri, pi, particles.mirror[j] ? pi : particles.p[j], w[k]);
            }
            bool const consistent = Rule::corrects(particles.surface[i]) && sums.corrected(factor, gradient[i]);
            if (!consistent) gradient[i] = factor * sums.symmetric;
        }
    }
};

} // namespace

std::string GradientScheme::readName(Dictionary const& gradSchemes, SchemeSet set)
{
    return gradSchemes.getWordOr("grad(p)", set == SchemeSet::Paper ? "symmetric" : "corrected", {"symmetric", "corrected", "hybrid"},
                                 "gradient schemes");
}

std::unique_ptr<GradientScheme> GradientScheme::read(Dictionary const& gradSchemes, SchemeSet set)
{
    std::string const name = readName(gradSchemes, set);
    if (name == "symmetric") return std::make_unique<Scheme<Symmetric>>();
    if (name == "corrected") return std::make_unique<Scheme<Corrected>>();
    return std::make_unique<Scheme<Hybrid>>();
}

} // namespace mpsDem
