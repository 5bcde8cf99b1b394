#include "pressure/SolverLadder.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pressure/ConjugateGradient.h"

namespace mpsDem {

namespace {

/// Rise of the diagonal for the preconditioner of the second try.
constexpr Real retryShift = 1e-3;
/// Iterations of the diagonal preconditioner in the last try, in units of maxIter.
constexpr int lastIterations = 4;

std::string rowText(int row) { return "row " + std::to_string(row); }

std::string number(Real value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

} // namespace

SolverFailure::SolverFailure(ExitCode code, int row, std::string const& what, std::string const& allowed)
    : CaseError(code, what, allowed),
      row_(row)
{}

SolverLadder::SolverLadder(SolverControls const& controls) : controls_(controls), resolved_(controls) {}

void SolverLadder::setMatrix(SparseMatrix const& matrix, bool rowsChanged)
{
    SolverControls const wanted = resolveAutomatic(controls_, matrix.rows);
    if (!solver_ || wanted.solver != resolved_.solver || wanted.preconditioner != resolved_.preconditioner)
    {
        solver_ = makeLinearSolver(wanted);
        resolved_ = wanted;
    }
    matrix_ = &matrix;
    if (matrix.rows > 0) solver_->setMatrix(matrix, rowsChanged);
}

void SolverLadder::rebuild(Real shift)
{
    if (matrix_ != nullptr && matrix_->rows > 0) solver_->rebuild(shift);
}

SolveReport SolverLadder::solve(std::span<Real const> b, std::span<Real> x, Real tolerance)
{
    rung_ = 0;
    requireFinite(b);
    SolveReport report;
    report.converged = true;
    report.solverName = "none";
    if (matrix_->rows == 0) return report;

    report = solver_->solve(b, x, tolerance);
    if (report.converged) return report;

    ++retries_;
    requireSoundMatrix();
    Real const initial = report.initialResidual;
    int iterations = report.iterations;
    for (rung_ = 1; rung_ <= 2 && !report.converged; ++rung_)
    {
        std::fill(x.begin(), x.end(), Real(0));
        if (rung_ == 1)
        {
            solver_->rebuild(retryShift);
            report = solver_->solve(b, x, tolerance);
        }
        else
        {
            SolverControls last = resolved_;
            last.maxIter = lastIterations * resolved_.maxIter;
            ConjugateGradient diagonal(ConjugateGradient::Preconditioner::Diagonal, last);
            diagonal.setMatrix(*matrix_, true);
            report = diagonal.solve(b, x, tolerance);
        }
        iterations += report.iterations;
    }
    --rung_;
    report.initialResidual = initial;
    report.iterations = iterations;
    if (!report.converged) giveUp(b, x, report);
    return report;
}

void SolverLadder::requireFinite(std::span<Real const> b) const
{
    if (std::isfinite(norm(b))) return;
    for (std::size_t i = 0; i < b.size(); ++i)
    {
        if (std::isfinite(b[i])) continue;
        int const row = static_cast<int>(i);
        throw SolverFailure(ExitCode::NotFinite, row, "the right-hand side is " + number(b[i]) + " in " + rowText(row));
    }
    throw SolverFailure(ExitCode::NotFinite, 0, "the norm of the right-hand side is not finite");
}

void SolverLadder::requireSoundMatrix() const
{
    SparseMatrix const& a = *matrix_;
    for (int i = 0; i < a.rows; ++i)
    {
        Real diagonal = 0;
        for (int k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k)
        {
            if (a.column[k] == i) diagonal = a.value[k];
            if (std::isfinite(a.value[k])) continue;
            throw SolverFailure(ExitCode::NotFinite, i, "the matrix has the entry " + number(a.value[k]) + " in " + rowText(i));
        }
        if (!(diagonal > 0)) throw SolverFailure(ExitCode::Solver, i, "the diagonal is " + number(diagonal) + " in " + rowText(i));
    }
}

void SolverLadder::giveUp(std::span<Real const> b, std::span<Real> x, SolveReport const& report) const
{
    int worst = 0;
    Real largest = -1;
    for (int i = 0; i < matrix_->rows; ++i)
    {
        Real rest = b[i];
        for (int k = matrix_->rowStart[i]; k < matrix_->rowStart[i + 1]; ++k) rest -= matrix_->value[k] * x[matrix_->column[k]];
        if (std::abs(rest) <= largest) continue;
        largest = std::abs(rest);
        worst = i;
        if (!std::isfinite(rest)) break;
    }
    std::fill(x.begin(), x.end(), Real(0));
    throw SolverFailure(ExitCode::Solver, worst,
                        "no convergence: residual " + number(report.finalResidual) + " after " + std::to_string(report.iterations) +
                            " iterations of all tries, largest in " + rowText(worst),
                        "a larger maxIter or tolerance in system/mpsSolution, solvers.p");
}

} // namespace mpsDem
