#include "pressure/ConjugateGradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mpsDem {

namespace {

/// Rows of the scaled triangles are filled with zeros to a multiple of this: a loop of nearly constant length costs no mispredicted branch
/// per row, which halves the time of a sweep over short rows.
constexpr int rowUnit = 4;
/// A pivot below this share of the diagonal is replaced by the diagonal.
constexpr Real smallestPivot = 0.02;
/// The true residual is formed in every so many iterations, and earlier where the estimate says that the end is near.
constexpr int checkInterval = 4;

constexpr std::array<char const*, 3> names = {"noPreconditionerPCG", "diagonalPCG", "ICPCG"};

int padded(int count) { return (count + rowUnit - 1) / rowUnit * rowUnit; }

/// Share m of the dropped fill that is moved to the diagonal, m = 1 - c h^2 with h = N^(-1/d) for the mesh width.
/// With m = 1 the smallest pivots spoil the condition number, with a constant m < 1 the iterations grow as without modification;
/// c = 20 (2-D) and 6 (3-D) are the best of a scan over 1e3 .. 1e5 rows (etc/doc/linear-solvers.md).
Real fillShare(int rows, int dimensions)
{
    Real const n = std::max(rows, 1);
    Real const loss = dimensions == 2 ? 20 / n : 6 / std::cbrt(n * n);
    return std::max(Real(0), 1 - loss);
}

/// start - sum_k value[k] x[column[k]] over a padded row, from front to back: the last entries depend on the row before.
Real forwardSum(int const* column, Real const* value, int count, Real const* x, Real start)
{
    for (int k = 0; k < count; k += rowUnit)
    {
        start -= value[k] * x[column[k]];
        start -= value[k + 1] * x[column[k + 1]];
        start -= value[k + 2] * x[column[k + 2]];
        start -= value[k + 3] * x[column[k + 3]];
    }
    return start;
}

/// The same from back to front: the first entries depend on the row after.
Real backwardSum(int const* column, Real const* value, int count, Real const* x, Real start)
{
    for (int k = count - 1; k >= 0; k -= rowUnit)
    {
        start -= value[k] * x[column[k]];
        start -= value[k - 1] * x[column[k - 1]];
        start -= value[k - 2] * x[column[k - 2]];
        start -= value[k - 3] * x[column[k - 3]];
    }
    return start;
}

/// Moves the entries [first, last) to the end of their row and fills its front with zeros.
void padFront(std::vector<int>& column, std::vector<Real>& value, int first, int last, int end)
{
    int const gap = end - last;
    if (gap == 0) return;
    int const nearest = column[first];
    std::move_backward(column.begin() + first, column.begin() + last, column.begin() + end);
    std::move_backward(value.begin() + first, value.begin() + last, value.begin() + end);
    std::fill_n(column.begin() + first, gap, nearest);
    std::fill_n(value.begin() + first, gap, Real(0));
}

} // namespace

ConjugateGradient::ConjugateGradient(Preconditioner preconditioner, SolverControls const& controls)
    : preconditioner_(preconditioner), controls_(controls)
{}

void ConjugateGradient::setMatrix(SparseMatrix const& matrix, bool)
{
    matrix_ = &matrix;
    rebuild(0);
}

void ConjugateGradient::rebuild(Real shift)
{
    auto const n = static_cast<std::size_t>(matrix_->rows);
    for (auto* const work : {&residual_, &direction_, &image_, &step_, &scale_}) work->resize(n);
    if (preconditioner_ == Preconditioner::IncompleteCholesky)
    {
        factorise(shift);
        scaleTriangles();
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

/// D_i = a_ii - sum_{k<i} a_ik / D_k (m U_k + (1 - m) a_ki), U_k = sum of row k right of its diagonal, m = fillShare.
/// While it runs, `step_` holds U and `image_` 1 / D; at the end `scale_` is D^-1/2 and `defect_` is 2 - a_ii / D_i.
void ConjugateGradient::factorise(Real shift)
{
    SparseMatrix const& a = *matrix_;
    defect_.resize(scale_.size());
    lowerStart_.assign(scale_.size() + 1, 0);
    upperStart_.assign(scale_.size() + 1, 0);
    Real const share = fillShare(a.rows, controls_.dimensions);
    for (int i = 0; i < a.rows; ++i)
    {
        int k = a.rowStart[i];
        int const end = a.rowStart[i + 1];
        Real fill = 0;
        for (; a.column[k] < i; ++k)
        {
            int const j = a.column[k];
            fill += a.value[k] * image_[j] * (share * step_[j] + (1 - share) * a.value[k]);
        }
        Real const diagonal = a.value[k];
        lowerStart_[i + 1] = lowerStart_[i] + padded(k - a.rowStart[i]);
        upperStart_[i + 1] = upperStart_[i] + padded(end - k - 1);
        Real right = 0;
        for (++k; k < end; ++k) right += a.value[k];
        Real pivot = (1 + shift) * diagonal - fill;
        if (!(pivot >= smallestPivot * diagonal)) pivot = diagonal;
        step_[i] = right;
        image_[i] = 1 / pivot;
        scale_[i] = 1 / std::sqrt(pivot);
        defect_[i] = 2 - diagonal / pivot;
    }
}

void ConjugateGradient::scaleTriangles()
{
    SparseMatrix const& a = *matrix_;
    lowerColumn_.resize(static_cast<std::size_t>(lowerStart_.back()));
    upperColumn_.resize(static_cast<std::size_t>(upperStart_.back()));
    lower_.resize(lowerColumn_.size());
    upper_.resize(upperColumn_.size());
    for (int i = 0; i < a.rows; ++i)
    {
        Real const own = scale_[i];
        int k = a.rowStart[i];
        int const end = a.rowStart[i + 1];
        int l = lowerStart_[i];
        for (; a.column[k] < i; ++k, ++l)
        {
            lowerColumn_[l] = a.column[k];
            lower_[l] = a.value[k] * own * scale_[a.column[k]];
        }
        // Zeros go to the far side of the row, onto a column that is read anyway.
        padFront(lowerColumn_, lower_, lowerStart_[i], l, lowerStart_[i + 1]);
        int u = upperStart_[i];
        for (++k; k < end; ++k, ++u)
        {
            upperColumn_[u] = a.column[k];
            upper_[u] = a.value[k] * own * scale_[a.column[k]];
        }
        for (; u < upperStart_[i + 1]; ++u)
        {
            upperColumn_[u] = a.column[end - 1];
            upper_[u] = 0;
        }
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
        int const start = upperStart_[i];
        Real const own = residual_[i] + beta * direction_[i];
        direction_[i] = own;
        step_[i] = backwardSum(upperColumn_.data() + start, upper_.data() + start, upperStart_[i + 1] - start, step_.data(), own);
    }
    Real curvature = 0;
    for (int i = 0; i < n; ++i)
    {
        int const start = lowerStart_[i];
        Real const own = direction_[i] - defect_[i] * step_[i];
        Real const w = forwardSum(lowerColumn_.data() + start, lower_.data() + start, lowerStart_[i + 1] - start, image_.data(), own);
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
        int const start = lowerStart_[i];
        Real const negative = forwardSum(lowerColumn_.data() + start, lower_.data() + start, lowerStart_[i + 1] - start, residual_.data(),
                                         -residual_[i]);
        Real const rest = negative / scale_[i];
        square += rest * rest;
    }
    return square;
}

int ConjugateGradient::iterateFactorised(std::span<Real> x, Real target, int most)
{
    int const n = matrix_->rows;
    Real rho = 0;
    Real square = 0;
    for (int i = 0; i < n; ++i)
    {
        int const start = lowerStart_[i];
        square += residual_[i] * residual_[i];
        residual_[i] = forwardSum(lowerColumn_.data() + start, lower_.data() + start, lowerStart_[i + 1] - start, residual_.data(),
                                  scale_[i] * residual_[i]);
        rho += residual_[i] * residual_[i];
        direction_[i] = 0;
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
            x[i] += alpha * scale_[i] * step_[i];
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
    return iteration;
}

} // namespace mpsDem
