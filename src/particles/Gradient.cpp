#include "particles/Gradient.h"

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

/// Both sums of one particle: of (p_j + p_i) for eq 4 and of (p_j - p_i) with the matrix C^-1 for the corrected form.
template <int d>
struct Sums
{
    Vector symmetric = Vector::Zero();
    Vector difference = Vector::Zero();
    Tensor moment = Tensor::Zero();

    void add(Vector const& rij, Real pi, Real pj, Real w)
    {
        Real const q = w / (rij.squaredNorm() + tiny);
        symmetric += (q * (pj + pi)) * rij;
        difference += (q * (pj - pi)) * rij;
        for (int a = 0; a < d; ++a)
            for (int b = a; b < d; ++b) moment(a, b) += q * rij[a] * rij[b];
    }
    [[nodiscard]] Vector corrected(Real factor) const
    {
        Eigen::Matrix<Real, d, d> inverse;
        for (int a = 0; a < d; ++a)
            for (int b = a; b < d; ++b) inverse(a, b) = inverse(b, a) = factor * moment(a, b);
        if (inverse.determinant() < GradientScheme::smallestDeterminant) return factor * symmetric;
        Vector result = Vector::Zero();
        result.template head<d>() = inverse.inverse() * (factor * difference.template head<d>());
        return result;
    }
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
            Sums<d> sums;
            for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
            {
                int const j = index[k];
                sums.add(particles.r[j] - ri, pi, particles.mirror[j] ? pi : particles.p[j], w[k]);
            }
            gradient[i] = Rule::corrects(particles.surface[i]) ? sums.corrected(factor) : Vector(factor * sums.symmetric);
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
