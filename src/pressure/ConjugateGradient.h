#pragma once

#include <vector>

#include "pressure/IncompleteCholesky.h"
#include "pressure/LinearSolver.h"

namespace mpsDem {

/// Conjugate gradients on the rows themselves, without any allocation once the sizes have been seen.
///
/// Preconditioners: none, diagonal, or modified incomplete Cholesky (IncompleteCholesky), M = (D + L) D^-1 (D + L^T). Because M has A's
/// own triangles, M^-1 A needs two triangular sweeps and no product with A (Eisenstat, SIAM J. Sci. Stat. Comput. 2 (1981) 1).
/// The iterations grow with N^(1/(2d)) for rows in geometric order, e.g. by columns of cells; where rows are mixed, the elimination
/// follows an order found by breadth-first search, which needs up to twice the iterations.
class ConjugateGradient : public LinearSolver
{
public:
    enum class Preconditioner
    {
        None,
        Diagonal,
        IncompleteCholesky
    };

    ConjugateGradient(Preconditioner preconditioner, SolverControls const& controls);

    void setMatrix(SparseMatrix const& matrix, bool rowsChanged) override;
    SolveReport solve(std::span<Real const> b, std::span<Real> x, Real tolerance) override;
    void rebuild(Real shift) override;

private:
    Real formResidual(std::span<Real const> b, std::span<Real const> x);
    int iteratePlain(std::span<Real> x, Real target, int most);
    int iterateFactorised(std::span<Real> x, Real target, int most);
    Real applyFactorised(Real beta);
    [[nodiscard]] Real squaredResidual() const;

    Preconditioner preconditioner_;
    SolverControls controls_;
    SparseMatrix const* matrix_ = nullptr;

    IncompleteCholesky cholesky_;
    std::vector<Real> scale_; // without it: 1 / a_ii, or 1

    std::vector<Real> residual_;
    std::vector<Real> direction_;
    std::vector<Real> image_;
    std::vector<Real> step_;
    std::vector<Real> correction_;
};

} // namespace mpsDem
