#include "pressure/ConjugateGradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mpsDem {

namespace {

/// The true residual is formed in every so many iterations, and earlier where the estimate says that the end is near.
constexpr int checkInterval = 4;

constexpr std::array<char const*, 3> names = {"noPreconditionerPCG", "diagonalPCG", "ICPCG"};

} // namespace

ConjugateGradient::ConjugateGradient(Preconditioner preconditioner, SolverControls const& controls)
    : preconditioner_(preconditioner),
      controls_(controls)
{}

void ConjugateGradient::setMatrix(SparseMatrix const& matrix, bool rowsChanged)
{
    bool const resized = static_cast<int>(cholesky_.order.size()) != matrix.rows;
    matrix_ = &matrix;
    if (preconditioner_ == Preconditioner::IncompleteCholesky && (rowsChanged || resized)) cholesky_.chooseOrder(matrix);
    rebuild(0);
}

void ConjugateGradient::rebuild(Real shift)
{
    auto const n = static_cast<std::size_t>(matrix_->rows);
    for (auto* const work : {&residual_, &direction_, &image_, &step_, &correction_, &scale_}) work->resize(n);
    if (preconditioner_ == Preconditioner::IncompleteCholesky)
    {
        cholesky_.factorise(*matrix_, shift, controls_.dimensions);
        return;
    }
    for (int i = 0; i < matrix_->rows; ++i)
    {
        Real diagonal = 1;
        for (int k = matrix_->rowStart[i]; k < matrix_->rowStart[i + 1]; ++k)
        {
            if (matrix_->column[k] == i) diagonal = matrix_->value[k];
        }
        scale_[i] = preconditioner_ == Preconditioner::Diagonal ? 1 / diagonal : 1;
    }
}

SolveReport ConjugateGradient::solve(std::span<Real const> b, std::span<Real> x, Real tolerance)
{
    SolveReport report;
    Real const size = norm(b);
    Real const scale = size > 0 ? size : 1;
    report.initialResidual = formResidual(b, x) / scale;
    report.finalResidual = report.initialResidual;
    Real const goal = std::max(tolerance, controls_.relTol * report.initialResidual);
    // A further round starts from the true residual where round-off kept that of the recurrence away from it.
    while (report.finalResidual > goal && report.iterations < controls_.maxIter)
    {
        int const most = controls_.maxIter - report.iterations;
        bool const factorised = preconditioner_ == Preconditioner::IncompleteCholesky;
        int const done = factorised ? iterateFactorised(x, goal * scale, most) : iteratePlain(x, goal * scale, most);
        report.iterations += done;
        report.finalResidual = formResidual(b, x) / scale;
        if (done == 0) break;
    }
    report.solverName = names[static_cast<std::size_t>(preconditioner_)];
    report.converged = report.finalResidual <= goal; // false for a NaN
    return report;
}

/// residual_ = b - A x; returns its norm.
Real ConjugateGradient::formResidual(std::span<Real const> b, std::span<Real const> x)
{
    SparseMatrix const& a = *matrix_;
    Real square = 0;
    for (int i = 0; i < a.rows; ++i)
    {
        Real rest = b[i];
        for (int k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k) rest -= a.value[k] * x[a.column[k]];
        residual_[i] = rest;
        square += rest * rest;
    }
    return std::sqrt(square);
}

int ConjugateGradient::iteratePlain(std::span<Real> x, Real target, int most)
{
    int const n = matrix_->rows;
    Real rho = 0;
    Real square = std::numeric_limits<Real>::max();
    for (int i = 0; i < n; ++i)
    {
        direction_[i] = scale_[i] * residual_[i];
        rho += residual_[i] * direction_[i];
    }
    int iteration = 0;
    for (; square > target * target && iteration < most; ++iteration)
    {
        multiply(*matrix_, direction_, image_);
        Real curvature = 0;
        for (int i = 0; i < n; ++i) curvature += direction_[i] * image_[i];
        if (!(curvature > 0)) break;
        Real const alpha = rho / curvature;
        Real next = 0;
        square = 0;
        for (int i = 0; i < n; ++i)
        {
            x[i] += alpha * direction_[i];
            Real const rest = residual_[i] - alpha * image_[i];
            residual_[i] = rest;
            square += rest * rest;
            next += rest * rest * scale_[i];
        }
        Real const beta = next / rho;
        rho = next;
        for (int i = 0; i < n; ++i) direction_[i] = scale_[i] * residual_[i] + beta * direction_[i];
    }
    return iteration;
}

/// With A scaled to D = 1, A = L + (2 - C) + U where C = 2 - a_ii / D_i, and in the unknowns (1 + U) D^1/2 x the matrix is
/// (1 + L)^-1 A (1 + U)^-1 = t + w for t = (1 + U)^-1 p and w = (1 + L)^-1 (p - C t): two sweeps.
/// Takes p = residual_ + beta direction_; returns p . (t + w). @post direction_ = p, step_ = t, image_ = w.
Real ConjugateGradient::applyFactorised(Real beta)
{
    int const n = matrix_->rows;
    for (int i = n - 1; i >= 0; --i)
    {
        Real const own = residual_[i] + beta * direction_[i];
        direction_[i] = own;
        step_[i] = cholesky_.upper.subtractBackward(i, step_.data(), own);
    }
    Real curvature = 0;
    for (int i = 0; i < n; ++i)
    {
        Real const w = cholesky_.lower.subtractForward(i, image_.data(), direction_[i] - cholesky_.defect[i] * step_[i]);
        image_[i] = w;
        curvature += direction_[i] * (step_[i] + w);
    }
    return curvature;
}

/// |b - A x|^2 from the residual of the transformed system: r = D^1/2 (1 + L) residual_.
Real ConjugateGradient::squaredResidual() const
{
    Real square = 0;
    for (int i = 0; i < matrix_->rows; ++i)
    {
        Real const rest = cholesky_.lower.subtractForward(i, residual_.data(), -residual_[i]) / cholesky_.scale[i];
        square += rest * rest;
    }
    return square;
}

int ConjugateGradient::iterateFactorised(std::span<Real> x, Real target, int most)
{
    int const n = matrix_->rows;
    Real rho = 0;
    Real square = 0;
    residual_.swap(image_);
    for (int i = 0; i < n; ++i)
    {
        Real const rest = image_[cholesky_.order[i]];
        square += rest * rest;
        residual_[i] = cholesky_.lower.subtractForward(i, residual_.data(), cholesky_.scale[i] * rest);
        rho += residual_[i] * residual_[i];
        direction_[i] = 0;
        correction_[i] = 0;
    }
    Real ratio = square / rho;
    Real beta = 0;
    int iteration = 0;
    while (square > target * target && iteration < most)
    {
        Real const curvature = applyFactorised(beta);
        if (!(curvature > 0)) break;
        Real const alpha = rho / curvature;
        Real next = 0;
        for (int i = 0; i < n; ++i)
        {
            correction_[i] += alpha * step_[i];
            Real const rest = residual_[i] - alpha * (step_[i] + image_[i]);
            residual_[i] = rest;
            next += rest * rest;
        }
        beta = next / rho;
        rho = next;
        ++iteration;
        if (iteration % checkInterval == 0 || ratio * rho <= target * target)
        {
            square = squaredResidual();
            ratio = square / rho;
        }
    }
    for (int i = 0; i < n; ++i) x[cholesky_.order[i]] += cholesky_.scale[i] * correction_[i];
    return iteration;
}

} // namespace mpsDem
