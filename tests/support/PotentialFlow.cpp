#include "support/PotentialFlow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace mpsDem::test {

namespace {

using Array = PotentialFlow::Array;
using Index = Eigen::Index;

/// Symmetric positive definite band matrix, factorised by Cholesky: A = L L^T. Column k holds A(k, k), A(k + 1, k) and so on.
class BandMatrix
{
public:
    BandMatrix(Index size, Index bandwidth) : band_(Eigen::MatrixXd::Zero(bandwidth + 1, size + bandwidth)), size_(size) {}

    /// Adds to the lower triangle; what belongs to the upper one is left out.
    void add(Index row, Index column, Real value)
    {
        if (row >= column) band_(row - column, column) += value;
    }

    void factorise()
    {
        Index const bandwidth = band_.rows() - 1;
        for (Index k = 0; k < size_; ++k)
        {
            band_.col(k) /= std::sqrt(band_(0, k));
            for (Index m = 1; m <= bandwidth; ++m)
                band_.col(k + m).head(bandwidth + 1 - m) -= band_(m, k) * band_.col(k).tail(bandwidth + 1 - m);
        }
    }

    /// x of A x = b, after factorise().
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd const& b) const
    {
        Index const bandwidth = band_.rows() - 1;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(size_ + bandwidth);
        x.head(size_) = b;
        for (Index k = 0; k < size_; ++k)
        {
            x(k) /= band_(0, k);
            x.segment(k + 1, bandwidth) -= x(k) * band_.col(k).tail(bandwidth);
        }
        for (Index k = size_ - 1; k >= 0; --k) x(k) = (x(k) - band_.col(k).tail(bandwidth).dot(x.segment(k + 1, bandwidth))) / band_(0, k);
        return x.head(size_);
    }

private:
    Eigen::MatrixXd band_; ///< With columns of zeros behind the last one.
    Index size_;
};

/// Integral of grad Ni . grad Nj over a bilinear quadrilateral with vertical sides, by 2 x 2 Gauss points. Nodes: lower left, upper left,
/// lower right, upper right. @param width  Between the sides [m]. @param z  Heights of the nodes [m].
Eigen::Matrix4d stiffness(Real width, Eigen::Vector4d const& z)
{
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    Real const low = 0.5 - std::sqrt(1.0 / 12);
    for (Real const r : {low, 1 - low})
        for (Real const s : {low, 1 - low})
        {
            Eigen::Vector4d const byR(s - 1, -s, 1 - s, s), byS(r - 1, 1 - r, -r, r);
            Real const zR = byR.dot(z), zS = byS.dot(z);
            Eigen::Vector4d const byX = (byR - byS * (zR / zS)) / width, byZ = byS / zS;
            sum += 0.25 * width * zS * (byX * byX.transpose() + byZ * byZ.transpose());
        }
    return sum;
}

/// Laplace's equation for phi between bed and surface. Unknowns are counted column by column, each from the bed up to the node below the
/// surface.
class LaplaceEquation
{
public:
    LaplaceEquation(Real width, Index layers, Array const& bed, Array const& surface)
        : layers_(layers),
          matrix_(layers * bed.size(), layers + 1)
    {
        auto const z = [&](Index column, Index level) {
            return bed(column) + static_cast<Real>(level) / static_cast<Real>(layers) * (surface(column) - bed(column));
        };
        for (Index k = 0; k + 1 < bed.size(); ++k)
            for (Index j = 0; j < layers; ++j) add(k, j, stiffness(width, {z(k, j), z(k, j + 1), z(k + 1, j), z(k + 1, j + 1)}));
        matrix_.factorise();
    }

    /// Flux out through the surface at each of its nodes, from their residuals, so that volume is conserved [m2/s].
    /// @param psi  phi on the surface [m2/s]. @param bedFlux  In through the bed at each node [m2/s].
    [[nodiscard]] Array surfaceFlux(Array const& psi, Array const& bedFlux) const
    {
        Eigen::VectorXd load = Eigen::VectorXd::Zero(layers_ * psi.size());
        for (Index k = 0; k < psi.size(); ++k) load(layers_ * k) = -bedFlux(k);
        for (Index k = 0; k + 1 < psi.size(); ++k)
        {
            Eigen::Vector4d const given = surfaceCell(k) * Eigen::Vector4d(0, psi(k), 0, psi(k + 1));
            load(below(k)) -= given(0);
            load(below(k + 1)) -= given(2);
        }
        Eigen::VectorXd const phi = matrix_.solve(load);
        Array flux = Array::Zero(psi.size());
        for (Index k = 0; k + 1 < psi.size(); ++k)
        {
            Eigen::Vector4d const residual = surfaceCell(k) * Eigen::Vector4d(phi(below(k)), psi(k), phi(below(k + 1)), psi(k + 1));
            flux(k) += residual(1);
            flux(k + 1) += residual(3);
        }
        return flux;
    }

private:
    /// Cell j, counted from the bed, between the nodes of column k and of the next one.
    void add(Index k, Index j, Eigen::Matrix4d const& cell)
    {
        Index const left = layers_ * k + j, right = left + layers_;
        bool const atSurface = j == layers_ - 1;
        std::array<Index, 4> const index{left, left + 1, right, right + 1};
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b)
                if (!atSurface || (a % 2 == 0 && b % 2 == 0))
                    matrix_.add(index[a], index[b], cell(static_cast<Index>(a), static_cast<Index>(b)));
        if (atSurface) surfaceCells_.push_back(cell);
    }

    [[nodiscard]] Eigen::Matrix4d const& surfaceCell(Index k) const { return surfaceCells_[static_cast<std::size_t>(k)]; }

    /// Unknown of the node below that of the surface.
    [[nodiscard]] Index below(Index k) const { return layers_ * (k + 1) - 1; }

    Index layers_;
    BandMatrix matrix_;
    std::vector<Eigen::Matrix4d> surfaceCells_;
};

/// df/dx, central; zero at the walls.
Array slope(Array const& f, Real width)
{
    Index const n = f.size();
    Array result = Array::Zero(n);
    result.segment(1, n - 2) = (f.tail(n - 2) - f.head(n - 2)) / (2 * width);
    return result;
}

Array trapezoidalWeights(int columns, Real width)
{
    Array result = Array::Constant(columns + 1, width);
    result(0) = result(columns) = 0.5 * width;
    return result;
}

} // namespace

PotentialFlow::PotentialFlow(Real length, int columns, int layers, Bed bed, SurfaceCondition condition)
    : width_(length / columns),
      layers_(layers),
      bed_(std::move(bed)),
      condition_(condition),
      x_(Array::LinSpaced(columns + 1, 0, length)),
      weights_(trapezoidalWeights(columns, width_)),
      state_(State::Zero(columns + 1, 2))
{}

void PotentialFlow::setSurface(Array const& elevation, Array const& potential)
{
    state_.col(0) = elevation;
    state_.col(1) = potential;
}

void PotentialFlow::advance(Real dt)
{
    State const a = rate(state_, time_);
    State const b = rate(state_ + 0.5 * dt * a, time_ + 0.5 * dt);
    State const c = rate(state_ + 0.5 * dt * b, time_ + 0.5 * dt);
    State const d = rate(state_ + dt * c, time_ + dt);
    state_ += dt / 6 * (a + 2 * b + 2 * c + d);
    time_ += dt;
}

Real PotentialFlow::elevation(Real x) const
{
    Real const place = x / width_;
    Index const k = std::min(static_cast<Index>(place), x_.size() - 2);
    return state_(k, 0) + (place - static_cast<Real>(k)) * (state_(k + 1, 0) - state_(k, 0));
}

Real PotentialFlow::energy() const { return 0.5 * integral(state_.col(1) * rate(state_, time_).col(0) + gravity * state_.col(0).square()); }

PotentialFlow::State PotentialFlow::rate(State const& state, Real t) const
{
    Array const eta = state.col(0), psi = state.col(1);
    bool const linear = condition_ == SurfaceCondition::linear;
    State result(state.rows(), 2);
    result.col(0) = surfaceFlux(linear ? Array::Zero(eta.size()).eval() : eta, psi, t);
    result.col(1) = -gravity * eta;
    if (linear) return result;
    Array const etaX = slope(eta, width_), psiX = slope(psi, width_);
    result.col(1) += -0.5 * psiX.square() + 0.5 * (result.col(0) + etaX * psiX).square() / (1 + etaX.square());
    return result;
}

Array PotentialFlow::surfaceFlux(Array const& surface, Array const& potential, Real t) const
{
    constexpr Real instant = 1e-5; // [s]
    Array const rise = (bed_(x_, t + instant) - bed_(x_, t - instant)) / (2 * instant);
    return LaplaceEquation(width_, layers_, bed_(x_, t), surface).surfaceFlux(potential, weights_ * rise) / weights_;
}

} // namespace mpsDem::test
