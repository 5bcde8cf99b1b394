#include "fluid/Viscosity.h"

#include <algorithm>
#include <limits>

#include "fluid/VelocitySystem.h"

namespace mpsDem {

namespace {

/// Largest nu dt/dx^2 of the explicit form.
constexpr Real explicitLimit = 0.125;
/// Determinant of the second moment, over that of the lattice, below which it isn't inverted.
constexpr Real smallestDeterminant = 0.1;

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

/// Of each fluid particle, halo included: its second moment of w over that of the lattice, inverted. Identity on the lattice, and where the
/// moment has no inverse.
template <int d>
void inverseMoments(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images,
                    ReferenceConstants const& laplacian, Field<Tensor>& inverse)
{
    Real const lattice = laplacian.n0 * laplacian.lambda / d;
    inverse.reserve(particles.r.capacity());
    inverse.assign(particles.r.size(), Tensor::Identity());
    for (int i : particles.fluid())
    {
        Eigen::Matrix<Real, d, d> moment = Eigen::Matrix<Real, d, d>::Zero();
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            auto const rij = (particles.r[neighbours.index()[k]] - particles.r[i]).template head<d>().eval();
            moment += neighbours.laplacianWeight()[k] / lattice * rij * rij.transpose();
        }
        if (moment.determinant() > smallestDeterminant) inverse[i].template topLeftCorner<d, d>() = moment.inverse();
    }
    images.update(inverse, particles.halo());
}

/// What a pair takes of eq 6's factor in a disordered cloud.
class Moments
{
public:
    void update(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images,
                ReferenceConstants const& laplacian)
    {
        if (particles.lattice().dimensions == 2)
            inverseMoments<2>(particles, neighbours, images, laplacian, inverse_);
        else
            inverseMoments<3>(particles, neighbours, images, laplacian, inverse_);
    }

    /// Mean of both particles' shares; that of i where j is no fluid.
    [[nodiscard]] Real share(ParticleSet const& particles, int i, int j) const
    {
        Vector const rij = particles.r[j] - particles.r[i];
        Real const own = along(inverse_[i], rij);
        return particles.isFluid(j) ? 0.5 * (own + along(inverse_[j], rij)) : own;
    }

private:
    static Real along(Tensor const& inverse, Vector const& rij)
    {
        return std::min(Real(1), rij.dot(inverse * rij) / (rij.squaredNorm() + tiny));
    }

    Field<Tensor> inverse_;
};

class Explicit final : public Viscosity
{
public:
    Explicit(Lattice const& lattice, Real nu, bool noSlip) : spacing_(lattice.spacing), nu_(nu), noSlip_(noSlip) {}

    void addTo(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, ReferenceConstants const& laplacian,
               Real dt) override
    {
        Real const factor = dt * nu_ * laplacian.laplacianFactor(particles.lattice().dimensions);
        Real const* const w = neighbours.laplacianWeight();
        moments_.update(particles, neighbours, images, laplacian);
        for (int i : particles.fluid())
        {
            Real const distance = noSlip_ ? wallDistance(particles, neighbours, i) : 0;
            Vector sum = Vector::Zero();
            for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
            {
                int const j = neighbours.index()[k];
                bool const fluid = particles.isFluid(j);
                if (!fluid && !noSlip_) continue;
                Real const pair = moments_.share(particles, i, j) * (fluid ? 1 : mirrorFactor(particles, distance, i, j));
                sum += w[k] * pair * (particles.u[j] - particles.u[i]);
            }
            particles.uStar[i] += factor * sum;
        }
    }

    [[nodiscard]] Real largestStableDt() const override { return explicitLimit * spacing_ * spacing_ / nu_; }
    [[nodiscard]] char const* name() const override { return "explicit"; }

private:
    Real spacing_, nu_;
    bool noSlip_;
    Moments moments_;
};

/// (1 - dt nu lap) u* = u + dt g, one system for all components.
class Implicit final : public Viscosity
{
public:
    Implicit(Real nu, bool noSlip, Real tolerance) : nu_(nu), noSlip_(noSlip), tolerance_(tolerance) {}

    void addTo(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, ReferenceConstants const& laplacian,
               Real dt) override
    {
        moments_.update(particles, neighbours, images, laplacian);
        assemble(particles, neighbours, dt * nu_ * laplacian.laplacianFactor(particles.lattice().dimensions));
        system_.solve(tolerance_);
        int const first = particles.fluid().first;
        for (int i : particles.fluid()) particles.uStar[i] = system_.solution(i - first);
    }

    [[nodiscard]] Real largestStableDt() const override { return std::numeric_limits<Real>::infinity(); }
    [[nodiscard]] char const* name() const override { return "implicit"; }

private:
    void assemble(ParticleSet const& particles, NeighbourList const& neighbours, Real factor)
    {
        int const first = particles.fluid().first;
        Real const* const w = neighbours.laplacianWeight();
        system_.begin(particles.fluid().size());
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
                Real const pair = moments_.share(particles, i, j) * (fluid ? 1 : mirrorFactor(particles, distance, i, j));
                Real const a = factor * w[k] * pair;
                diagonal += a;
                if (fluid && particles.fluid().contains(j))
                    system_.add(j - first, -a);
                else
                    right += a * particles.u[j];
            }
            system_.endRow(diagonal, right, particles.u[i]);
        }
    }

    Real nu_;
    bool noSlip_;
    Real tolerance_;
    Moments moments_;
    VelocitySystem system_;
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
