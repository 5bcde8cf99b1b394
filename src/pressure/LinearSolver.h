#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/Types.h"
#include "pressure/SparseMatrix.h"

namespace mpsDem {

class Dictionary;

/// What `solvers { p { ... } }` of system/mpsSolution says about the linear solver.
struct SolverControls
{
    std::string solver = "auto";         ///< PCG | EigenPCG | auto
    std::string preconditioner = "auto"; ///< none | diagonal | IC | AMG | auto
    std::string smoother = "auto";       ///< of AMG: symGaussSeidel | Chebyshev | Jacobi | auto
    Real tolerance = 1e-6;               ///< |b - A x| / |b| at which a solve ends.
    Real relTol = 0;          ///< A solve also ends when the residual fell to this share of the initial one; 0 switches this off.
    int maxIter = 500;        ///< Iterations of one solve; more are a failure.
    int dimensions = 2;       ///< 2 or 3: decides with the number of rows what `auto` means.
    int rebuildInterval = 50; ///< AMG: solves after which the hierarchy is rebuilt from scratch.
    Real rebuildRatio = 1.3;  ///< AMG: growth of the iteration count after which it is rebuilt.
};

/// Reads the controls from the dictionary `p`; unknown words are refused with the known ones.
/// `dimensions` isn't a keyword: the caller sets it.
SolverControls readSolverControls(Dictionary const& dictionary);

/// The words that `auto` stands for with so many unknowns (etc/doc/linear-solvers.md has the measurements).
SolverControls resolveAutomatic(SolverControls const& controls, int rows);

/// What one solve did.
struct SolveReport
{
    std::string_view solverName; ///< As in the log, e.g. "ICPCG".
    Real initialResidual = 0;    ///< |b - A x| / |b| of the guess.
    Real finalResidual = 0;      ///< The same of the answer, from b - A x itself, never from a recurrence.
    int iterations = 0;
    bool converged = false;
};

/// Solves A x = b with one matrix and any number of right-hand sides.
class LinearSolver
{
public:
    LinearSolver() = default;
    virtual ~LinearSolver() = default;
    LinearSolver(LinearSolver const&) = delete;
    LinearSolver& operator=(LinearSolver const&) = delete;

    /// Takes a matrix, which must stay unchanged until the last solve with it.
    /// @param rowsChanged  false where row i means the same particle as before: what was set up may then be reused.
    virtual void setMatrix(SparseMatrix const& matrix, bool rowsChanged) = 0;

    /// @param b          right-hand side. @param x guess on entry, solution on return.
    /// @param tolerance  on |b - A x| / |b|.
    /// Never throws for a bad convergence: see SolveReport::converged; a residual that isn't finite counts as not converged.
    virtual SolveReport solve(std::span<Real const> b, std::span<Real> x, Real tolerance) = 0;

    /// Forgets all that was kept from earlier matrices. @param shift rise of the diagonal that an incomplete factorisation is made of, in
    /// units of it; solvers without one ignore it.
    virtual void rebuild(Real shift) = 0;
};

/// The solver that the controls ask for; `auto` must be resolved.
std::unique_ptr<LinearSolver> makeLinearSolver(SolverControls const& controls);

} // namespace mpsDem
