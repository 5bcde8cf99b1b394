#pragma once

#include <vector>

#include "pressure/LinearSolver.h"

namespace mpsDem {

/// Conjugate gradients on the rows themselves, without any allocation once the sizes have been seen.
///
/// Preconditioners: none, diagonal, or incomplete Cholesky without fill, M = (D + L) D^-1 (D + L^T), where L is the lower triangle of A
/// and the diagonal D makes the row sums of M and A agree up to a factor (modified incomplete factorisation, Gustafsson, BIT 18 (1978) 142;
/// the blend of Bridson, Fluid Simulation for Computer Graphics, 2nd ed., section 5.3). Because M has A's own triangles, M^-1 A needs two triangular
/// sweeps and no product with A (Eisenstat, SIAM J. Sci. Stat. Comput. 2 (1981) 1).
/// In two dimensions the iterations grow with the fourth root of the number of rows.
class ConjugateGradient : public LinearSolver
{
public:
    enum class Preconditioner { None, Diagonal, IncompleteCholesky };

    ConjugateGradient(Preconditioner preconditioner, SolverControls const& controls);

    void setMatrix(SparseMatrix const& matrix, bool rowsChanged) override;
    SolveReport solve(std::span<Real const> b, std::span<Real> x, Real tolerance) override;
    void rebuild(Real shift) override;

private:
    void factorise(Real shift);
    void scaleTriangles();
    Real formResidual(std::span<Real const> b, std::span<Real const> x);
    int iteratePlain(std::span<Real> x, Real target, int most);
    int iterateFactorised(std::span<Real> x, Real target, int most);
    Real applyFactorised(Real beta);
    [[nodiscard]] Real squaredResidual() const;

    Preconditioner preconditioner_;
    SolverControls controls_;
    SparseMatrix const* matrix_ = nullptr;

    // A scaled to D = 1, triangle by triangle, rows padded with zeros.
    std::vector<int> lowerStart_;
    std::vector<int> lowerColumn_;
    std::vector<Real> lower_;
    std::vector<int> upperStart_;
    std::vector<int> upperColumn_;
    std::vector<Real> upper_;
    std::vector<Real> scale_;   // 1 / sqrt(D), or 1 / a_ii (diagonal), or 1
    std::vector<Real> defect_;  // 2 - a_ii / D

    std::vector<Real> residual_;
    std::vector<Real> direction_;
    std::vector<Real> image_;
    std::vector<Real> step_;
};

} // namespace mpsDem
