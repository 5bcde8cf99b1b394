#include "fluid/Viscosity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/Errors.h"
#include "fluid/VelocitySystem.h"

namespace mpsDem {

namespace {

/// Largest nu dt/dx^2 of the explicit form.
constexpr Real explicitLimit = 0.125;
/// nu dt/dx^2 up to which water that slips along its walls has no viscosity to speak of.
constexpr Real negligible = 1e-5;
/// Pivot of the system for the pairs' shares below which a particle has too few neighbours around for it; on the lattice 0.2 and more.
constexpr Real smallestPivot = 0.05;
/// Bounds of a share; 1 is the largest one at and near the free surface, where neighbours are missing and not far.
constexpr Real smallestShare = 0.25, largestShare = 1.25;

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

/// e e^T of a unit vector as a list of components whose scalar product is that of the tensors.
template <int d>
Eigen::Matrix<Real, d*(d + 1) / 2, 1> dyad(Vector const& e)
{
    Eigen::Matrix<Real, d*(d + 1) / 2, 1> v;
    int k = 0;
    for (int a = 0; a < d; ++a)
        for (int b = a; b < d; ++b) v[k++] = (a == b ? 1 : std::numbers::sqrt2) * e[a] * e[b];
    return v;
}

/// The symmetric tensor of a list made as by dyad().
template <int d>
Tensor tensorOf(Eigen::Matrix<Real, d*(d + 1) / 2, 1> const& v)
{
    Tensor all = Tensor::Identity();
    int k = 0;
    for (int a = 0; a < d; ++a)
        for (int b = a; b < d; ++b, ++k) all(a, b) = all(b, a) = v[k] / (a == b ? 1 : std::numbers::sqrt2);
    return all;
}

/// Of each fluid particle, halo included, the tensor S with which the second moment of the shares e S e is that of the lattice,
/// sum_j w_ij r^2 (e S e) e e^T = (n0 lambda/d) I. Identity on the lattice, and where neighbours don't determine it.
template <int d>
void shareTensors(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images,
                  ReferenceConstants const& laplacian, Field<Tensor>& tensor)
{
    constexpr int size = d * (d + 1) / 2;
    using List = Eigen::Matrix<Real, size, 1>;
    List identity = List::Zero();
    for (int a = 0; a < d; ++a) identity += dyad<d>(Vector::Unit(a));
    Real const lattice = laplacian.n0 * laplacian.lambda / d;
    tensor.reserve(particles.r.capacity());
    tensor.assign(particles.r.size(), Tensor::Identity());
    for (int i : particles.fluid())
    {
        Eigen::Matrix<Real, size, size> system = Eigen::Matrix<Real, size, size>::Zero();
        for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
        {
            Vector const rij = particles.r[neighbours.index()[k]] - particles.r[i];
            Real const r2 = rij.squaredNorm();
            List const v = dyad<d>(rij / std::sqrt(r2 + tiny));
            system += neighbours.laplacianWeight()[k] * r2 / lattice * v * v.transpose();
        }
        auto const factors = system.ldlt();
        if (factors.vectorD().minCoeff() > smallestPivot) tensor[i] = tensorOf<d>(factors.solve(identity));
    }
    images.update(tensor, particles.halo());
}

/// What a pair takes of eq 6's factor in a disordered cloud.
class Moments
{
public:
    void update(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images,
                ReferenceConstants const& laplacian)
    {
        if (particles.lattice().dimensions == 2)
            shareTensors<2>(particles, neighbours, images, laplacian, tensor_);
        else
            shareTensors<3>(particles, neighbours, images, laplacian, tensor_);
    }

    /// Mean of both particles' shares; that of i where j is no fluid.
    [[nodiscard]] Real share(ParticleSet const& particles, int i, int j) const
    {
        Vector const rij = particles.r[j] - particles.r[i];
        Real const own = along(particles, i, rij);
        return particles.isFluid(j) ? 0.5 * (own + along(particles, j, rij)) : own;
    }

private:
    [[nodiscard]] Real along(ParticleSet const& particles, int i, Vector const& rij) const
    {
        Real const most = particles.surface[i] == SurfaceLabel::Interior ? largestShare : 1;
        return std::clamp(rij.dot(tensor_[i] * rij) / (rij.squaredNorm() + tiny), smallestShare, most);
    }

    Field<Tensor> tensor_;
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

std::string Viscosity::whyAbsent(Dictionary const& dict, Lattice const& lattice, Real nu, Real largestDt)
{
    std::string const type = dict.getWordOr("type", "auto", {"none", "explicit", "implicit", "auto"}, "viscosity schemes");
    bool const slip = dict.getWordOr("walls", "slip", {"slip", "noSlip"}, "wall conditions") == "slip";
    if (nu == 0) return "nu 0";
    if (type == "none") return "mpsSchemes/viscositySchemes: type none";
    Real const diffusion = nu * largestDt / (lattice.spacing * lattice.spacing);
    if (type != "auto" || !slip || diffusion > negligible) return "";
    return "mpsSchemes/viscositySchemes: type auto, walls slip and nu dt/dx^2 <= " + shortNumber(diffusion) + " has no effect";
}

std::unique_ptr<Viscosity> Viscosity::read(Dictionary const& dict, Lattice const& lattice, Real nu, Real largestDt)
{
    std::string const type = dict.getWordOr("type", "auto", {"none", "explicit", "implicit", "auto"}, "viscosity schemes");
    bool const noSlip = dict.getWordOr("walls", "slip", {"slip", "noSlip"}, "wall conditions") == "noSlip";
    Real const tolerance = dict.getInRangeOr("tolerance", 1e-8, 1e-14, 0.1);
    if (!whyAbsent(dict, lattice, nu, largestDt).empty()) return nullptr;
    bool const stiff = nu * largestDt > explicitLimit * lattice.spacing * lattice.spacing;
    if (type == "implicit" || (type == "auto" && stiff)) return std::make_unique<Implicit>(nu, noSlip, tolerance);
    return std::make_unique<Explicit>(lattice, nu, noSlip);
}

} // namespace mpsDem
