#pragma once

#include <memory>

#include "pressure/LinearSolver.h"

namespace mpsDem {

/// Conjugate gradients of Trilinos (Belos) with smoothed aggregation (MueLu), for many unknowns.
///
/// The aggregates are kept while the rows stay the same points: only the coarse matrices are made anew (reuse type RAP). Everything is rebuilt
/// when the rows changed, after `rebuildInterval` solves, and when a solve needed more than `rebuildRatio` times the iterations of the
/// first one after a rebuild. Runs on one rank.
class BelosSolver : public LinearSolver
{
public:
    explicit BelosSolver(SolverControls const& controls);
    ~BelosSolver() override;

    void setMatrix(SparseMatrix const& matrix, bool rowsChanged) override;
    SolveReport solve(std::span<Real const> b, std::span<Real> x, Real tolerance) override;
    void rebuild(Real shift) override;

    /// How often the aggregates were made, for tests and the log.
    [[nodiscard]] int rebuilds() const;

private:
    struct Implementation; // everything of Trilinos
    std::unique_ptr<Implementation> implementation_;
};

} // namespace mpsDem
