#include "fluid/Viscosity.h"

#include <algorithm>
#include <limits>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace mpsDem {

namespace {

/// Largest nu dt/dx^2 of the explicit form.
constexpr Real explicitLimit = 0.125;

/// Distance of fluid particle i from the surface of the walls beside it [m], from the wall rows half a spacing behind it; at least a
/// quarter of a spacing, infinity without walls.
Real wallDistance(ParticleSet const& particles, NeighbourList const& neighbours, int i)
{
    Real const spacing = particles.lattice().spacing;
    Real distance = std::numeric_limits<Real>::infinity();
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        if (particles.type[j] != ParticleType::Wall) continue;
        distance = std::min(distance, (particles.r[i] - particles.r[j]).dot(particles.normal[j]) - 0.5 * spacing);
    }
    return std::max(distance, 0.25 * spacing);
}

/// Factor on (u_wall - u_i) for a no-slip boundary particle j: its velocity is that of the wall mirrored through the surface,
/// u_j = u_wall - (u_i - u_wall) d_j / d_i, so that the water is at rest on the surface and not half a spacing behind it.
Real mirrorFactor(ParticleSet const& particles, Real wallDistanceOfI, int i, int j)
{
    Real const apart = (particles.r[i] - particles.r[j]).dot(particles.normal[j]);
    return std::max(Real(1), apart / wallDistanceOfI);
}

class Explicit final : public Viscosity
{
public:
    Explicit(Lattice const& lattice, Real nu, bool noSlip) : spacing_(lattice.spacing), nu_(nu), noSlip_(noSlip) {}

    void addTo(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& laplacian, Real dt) override
    {
        Real const factor = dt * nu_ * laplacian.laplacianFactor(particles.lattice().dimensions);
        Real const* const w = neighbours.laplacianWeight();
        for (int i : particles.fluid())
        {
            Real const distance = noSlip_ ? wallDistance(particles, neighbours, i) : 0;
            Vector sum = Vector::Zero();
            for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
            {
                int const j = neighbours.index()[k];
                bool const fluid = particles.isFluid(j);
                if (!fluid && !noSlip_) continue;
                sum += w[k] * (fluid ? 1 : mirrorFactor(particles, distance, i, j)) * (particles.u[j] - particles.u[i]);
            }
            particles.uStar[i] += factor * sum;
        }
    }

    [[nodiscard]] Real largestStableDt() const override { return explicitLimit * spacing_ * spacing_ / nu_; }
    [[nodiscard]] char const* name() const override { return "explicit"; }

private:
    Real spacing_, nu_;
    bool noSlip_;
};

/// (1 - dt nu lap) u* = u + dt g, one system for all components, conjugate gradients of Eigen.
class Implicit final : public Viscosity
{
public:
    Implicit(Real nu, bool noSlip, Real tolerance) : nu_(nu), noSlip_(noSlip) { solver_.setTolerance(tolerance); }

    void addTo(ParticleSet& particles, NeighbourList const& neighbours, ReferenceConstants const& laplacian, Real dt) override
    {
        assemble(particles, neighbours, dt * nu_ * laplacian.laplacianFactor(particles.lattice().dimensions));
        solver_.compute(matrix_);
        Eigen::MatrixXd const solution = solver_.solveWithGuess(right_, guess_);
        int const first = particles.fluid().first;
        for (int i : particles.fluid()) particles.uStar[i] = solution.row(i - first).transpose();
    }

    [[nodiscard]] Real largestStableDt() const override { return std::numeric_limits<Real>::infinity(); }
    [[nodiscard]] char const* name() const override { return "implicit"; }

private:
    void assemble(ParticleSet const& particles, NeighbourList const& neighbours, Real factor)
    {
        int const first = particles.fluid().first, count = particles.fluid().size();
        Real const* const w = neighbours.laplacianWeight();
        right_.resize(count, 3);
        guess_.resize(count, 3);
        entries_.clear();
        for (int i : particles.fluid())
        {
            Real const distance = noSlip_ ? wallDistance(particles, neighbours, i) : 0;
            Real diagonal = 1;
            Vector right = particles.uStar[i];
            for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
            {
                int const j = neighbours.index()[k];
                bool const fluid = particles.isFluid(j);
                if (!fluid && !noSlip_) continue;
                Real const a = factor * w[k] * (fluid ? 1 : mirrorFactor(particles, distance, i, j));
                diagonal += a;
                if (fluid && particles.fluid().contains(j))
                    entries_.emplace_back(i - first, j - first, -a);
                else
                    right += a * particles.u[j];
            }
            entries_.emplace_back(i - first, i - first, diagonal);
            right_.row(i - first) = right.transpose();
            guess_.row(i - first) = particles.u[i].transpose();
        }
        matrix_.resize(count, count);
        matrix_.setFromTriplets(entries_.begin(), entries_.end());
    }

    Real nu_;
    bool noSlip_;
    std::vector<Eigen::Triplet<Real>> entries_;
    Eigen::SparseMatrix<Real> matrix_;
    Eigen::MatrixXd right_, guess_;
    Eigen::ConjugateGradient<Eigen::SparseMatrix<Real>, Eigen::Lower | Eigen::Upper> solver_;
};

} // namespace

std::unique_ptr<Viscosity> Viscosity::read(Dictionary const& dict, Lattice const& lattice, Real nu, Real largestDt)
{
    std::string const type = dict.getWordOr("type", "auto", {"none", "explicit", "implicit", "auto"}, "viscosity schemes");
    bool const noSlip = dict.getWordOr("walls", "slip", {"slip", "noSlip"}, "wall conditions") == "noSlip";
    Real const tolerance = dict.getInRangeOr("tolerance", 1e-8, 1e-14, 0.1);
    if (type == "none" || nu == 0) return nullptr;
    bool const stiff = nu * largestDt > explicitLimit * lattice.spacing * lattice.spacing;
    if (type == "implicit" || (type == "auto" && stiff)) return std::make_unique<Implicit>(nu, noSlip, tolerance);
    return std::make_unique<Explicit>(lattice, nu, noSlip);
}

} // namespace mpsDem
