#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/Errors.h"
#include "pressure/LinearSolver.h"

namespace mpsDem {

/// A system that can't be solved: ExitCode::NotFinite (matrix or right-hand side) or ExitCode::Solver, with the row where the cause shows.
class SolverFailure : public CaseError
{
public:
    SolverFailure(ExitCode code, int row, std::string const& what, std::string const& allowed = {});

    [[nodiscard]] int row() const { return row_; }

private:
    int row_;
};

/// The linear solver that the controls ask for, and what to try when it fails.
///
/// `auto` is decided anew whenever the number of rows passes a threshold. A solve that does not end within maxIter or gives a residual
/// that isn't finite is tried again: 1. from zero with the preconditioner built anew, its diagonal raised by a thousandth; 2. from zero with
/// diagonal PCG and four times the iterations; 3. it is given up with a SolverFailure that names the cause.
class SolverLadder : public LinearSolver
{
public:
    explicit SolverLadder(SolverControls const& controls);

    void setMatrix(SparseMatrix const& matrix, bool rowsChanged) override;

    /// The report counts the iterations of all tries. @post x is finite.
    /// @throw SolverFailure where b isn't finite or all tries failed; x is then zero.
    SolveReport solve(std::span<Real const> b, std::span<Real> x, Real tolerance) override;
    void rebuild(Real shift) override;

    /// Tries that the last solve needed beyond the first: 0, 1 or 2.
    [[nodiscard]] int lastRung() const { return rung_; }
    /// Solves since the start that needed more than one try.
    [[nodiscard]] int retries() const { return retries_; }

private:
    void requireFinite(std::span<Real const> b) const;
    void requireSoundMatrix() const;
    [[noreturn]] void giveUp(std::span<Real const> b, std::span<Real> x, SolveReport const& report) const;

    SolverControls controls_;
    SolverControls resolved_;
    SparseMatrix const* matrix_ = nullptr;
    std::unique_ptr<LinearSolver> solver_;
    int rung_ = 0;
    int retries_ = 0;
};

} // namespace mpsDem
