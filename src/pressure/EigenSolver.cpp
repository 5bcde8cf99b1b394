#include "pressure/EigenSolver.h"

#include <algorithm>
#include <variant>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace mpsDem {

namespace {

using Matrix = Eigen::SparseMatrix<Real>;
using Cholesky = Eigen::IncompleteCholesky<Real, Eigen::Lower, Eigen::NaturalOrdering<int>>;
template <class Preconditioner>
using Gradients = Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Preconditioner>;
using Solver = std::variant<Gradients<Cholesky>, Gradients<Eigen::DiagonalPreconditioner<Real>>, Gradients<Eigen::IdentityPreconditioner>>;

} // namespace

struct EigenSolver::Implementation
{
    SolverControls controls;
    SparseMatrix const* rows = nullptr;
    Matrix matrix;
    Solver solver;
};

EigenSolver::EigenSolver(SolverControls const& controls) : implementation_(std::make_unique<Implementation>())
{
    implementation_->controls = controls;
    Solver& solver = implementation_->solver;
    if (controls.preconditioner == "diagonal") solver.emplace<1>();
    if (controls.preconditioner == "none") solver.emplace<2>();
}

EigenSolver::~EigenSolver() = default;

void EigenSolver::setMatrix(SparseMatrix const& matrix, bool)
{
    implementation_->rows = &matrix;
    // Rows and columns may be exchanged: the matrix is symmetric.
    implementation_->matrix = Eigen::Map<Matrix const>(matrix.rows, matrix.rows, static_cast<Eigen::Index>(matrix.entries()),
                                                       matrix.rowStart.data(), matrix.column.data(), matrix.value.data());
    rebuild(0);
}

void EigenSolver::rebuild(Real shift)
{
    Matrix const& matrix = implementation_->matrix;
    if (auto* const cholesky = std::get_if<0>(&implementation_->solver)) cholesky->preconditioner().setInitialShift(std::max(shift, 1e-3));
    std::visit([&matrix](auto& solver) { solver.compute(matrix); }, implementation_->solver);
}

SolveReport EigenSolver::solve(std::span<Real const> b, std::span<Real> x, Real tolerance)
{
    SolverControls const& controls = implementation_->controls;
    SolveReport report;
    report.solverName = "EigenPCG";
    report.initialResidual = relativeResidual(*implementation_->rows, b, x);
    Real const goal = std::max(tolerance, controls.relTol * report.initialResidual);
    auto const size = static_cast<Eigen::Index>(x.size());
    Eigen::Map<Eigen::VectorXd const> const right(b.data(), size);
    Eigen::Map<Eigen::VectorXd> answer(x.data(), size);
    std::visit(
        [&](auto& solver) {
            solver.setTolerance(goal);
            solver.setMaxIterations(controls.maxIter);
            Eigen::VectorXd const found = solver.solveWithGuess(right, answer);
            answer = found;
            report.iterations = static_cast<int>(solver.iterations());
        },
        implementation_->solver);
    report.finalResidual = relativeResidual(*implementation_->rows, b, x);
    report.converged = report.finalResidual <= 1.01 * goal; // Eigen's residual is a recurrence
    return report;
}

} // namespace mpsDem
