#pragma once

#include <memory>

#include "pressure/LinearSolver.h"

namespace mpsDem {

/// Conjugate gradients of Eigen, with its own incomplete Cholesky, diagonal or no preconditioner.
///
/// Five to eight times slower than ConjugateGradient; kept as an independent check of it (`solver EigenPCG;`).
class EigenSolver : public LinearSolver
{
public:
    explicit EigenSolver(SolverControls const& controls);
    ~EigenSolver() override;

    void setMatrix(SparseMatrix const& matrix, bool rowsChanged) override;
    SolveReport solve(std::span<Real const> b, std::span<Real> x, Real tolerance) override;
    void rebuild(Real shift) override;

private:
    struct Implementation; // everything of Eigen's sparse part
    std::unique_ptr<Implementation> implementation_;
};

} // namespace mpsDem
