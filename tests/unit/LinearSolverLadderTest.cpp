#include "pressure/SolverLadder.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/LinearSolverProblem.h"

namespace mpsDem {
namespace {

struct System
{
    explicit System(int rows = 900)
    {
        test::MovingTank tank(2, rows, 2.1);
        tank.assemble(a, b);
        x.assign(b.size(), 0);
    }

    SparseMatrix a;
    std::vector<Real> b;
    std::vector<Real> x;
};

SolverControls controlsFor(int maxIter, std::string const& preconditioner = "auto")
{
    SolverControls controls;
    controls.preconditioner = preconditioner;
    controls.maxIter = maxIter;
    return controls;
}

/// Runs a solve that must fail and returns what it threw.
SolverFailure failureOf(SolverLadder& ladder, System& system)
{
    try
    {
        ladder.setMatrix(system.a, true);
        ladder.solve(system.b, system.x, 1e-6);
    }
    catch (SolverFailure const& failure)
    {
        return failure;
    }
    ADD_FAILURE() << "nothing was thrown";
    return {ExitCode::Internal, -1, "nothing"};
}

TEST(LinearSolverLadder, aSoundSystemNeedsTheFirstTryOnly)
{
    System system;
    SolverLadder ladder(controlsFor(500));
    ladder.setMatrix(system.a, true);
    SolveReport const report = ladder.solve(system.b, system.x, 1e-8);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.solverName, "ICPCG");
    EXPECT_EQ(ladder.lastRung(), 0);
    EXPECT_EQ(ladder.retries(), 0);
    EXPECT_LE(relativeResidual(system.a, system.b, system.x), 1e-8);
}

TEST(LinearSolverLadder, aNonFiniteGuessIsReplacedByZero)
{
    System system;
    system.x[17] = std::numeric_limits<Real>::quiet_NaN();
    for (char const* const preconditioner : {"IC", "AMG", "diagonal"})
    {
        SCOPED_TRACE(preconditioner);
        std::vector<Real> x = system.x;
        SolverLadder ladder(controlsFor(500, preconditioner));
        ladder.setMatrix(system.a, true);
        EXPECT_TRUE(ladder.solve(system.b, x, 1e-8).converged);
        EXPECT_EQ(ladder.lastRung(), 1);
        EXPECT_EQ(ladder.retries(), 1);
        EXPECT_LE(relativeResidual(system.a, system.b, x), 1e-8);
    }
}

TEST(LinearSolverLadder, diagonalPreconditionerWithMoreIterationsIsTheLastTry)
{
    // In a small tank Cholesky is less than four times as good as the diagonal: two iterations fewer than it needs make it fail twice.
    System system(49);
    SolverLadder enough(controlsFor(500, "IC"));
    enough.setMatrix(system.a, true);
    std::vector<Real> x = system.x;
    int const needed = enough.solve(system.b, x, 1e-8).iterations;

    SolverLadder ladder(controlsFor(needed - 2, "IC"));
    ladder.setMatrix(system.a, true);
    SolveReport const report = ladder.solve(system.b, system.x, 1e-8);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.solverName, "diagonalPCG");
    EXPECT_EQ(ladder.lastRung(), 2);
    EXPECT_GT(report.iterations, 2 * (needed - 2));
    EXPECT_LE(relativeResidual(system.a, system.b, system.x), 1e-8);
}

TEST(LinearSolverLadder, oneIterationAllowedEndsInAFailureWithTheWorstRow)
{
    System system;
    SolverLadder ladder(controlsFor(1));
    SolverFailure const failure = failureOf(ladder, system);
    EXPECT_EQ(failure.code(), ExitCode::Solver);
    EXPECT_GE(failure.row(), 0);
    EXPECT_LT(failure.row(), system.a.rows);
    EXPECT_NE(std::string(failure.what()).find("no convergence"), std::string::npos);
    EXPECT_EQ(norm(system.x), 0);
}

TEST(LinearSolverLadder, namesTheRowOfANonFiniteRightHandSide)
{
    System system;
    system.b[123] = std::numeric_limits<Real>::quiet_NaN();
    SolverLadder ladder(controlsFor(500));
    SolverFailure const failure = failureOf(ladder, system);
    EXPECT_EQ(failure.code(), ExitCode::NotFinite);
    EXPECT_EQ(failure.row(), 123);
}

TEST(LinearSolverLadder, namesTheRowOfANonFiniteMatrixEntry)
{
    for (char const* const preconditioner : {"IC", "AMG", "diagonal", "none"})
    {
        SCOPED_TRACE(preconditioner);
        System system;
        system.a.value[system.a.rowStart[55]] = std::numeric_limits<Real>::infinity();
        SolverLadder ladder(controlsFor(500, preconditioner));
        SolverFailure const failure = failureOf(ladder, system);
        EXPECT_EQ(failure.code(), ExitCode::NotFinite);
        EXPECT_EQ(failure.row(), 55);
    }
}

TEST(LinearSolverLadder, namesARowWithoutDiagonal)
{
    System system;
    for (int k = system.a.rowStart[200]; k < system.a.rowStart[201]; ++k)
    {
        if (system.a.column[k] == 200) system.a.value[k] = 0;
    }
    // Its couplings vanish as well: the row says 0 = b.
    for (int i = 0; i < system.a.rows; ++i)
    {
        for (int k = system.a.rowStart[i]; k < system.a.rowStart[i + 1]; ++k)
        {
            if ((i == 200) != (system.a.column[k] == 200)) system.a.value[k] = 0;
        }
    }
    system.b[200] = 1;
    SolverLadder ladder(controlsFor(100));
    SolverFailure const failure = failureOf(ladder, system);
    EXPECT_EQ(failure.code(), ExitCode::Solver);
    EXPECT_EQ(failure.row(), 200);
}

TEST(LinearSolverLadder, worksAgainAfterAFailure)
{
    System bad;
    bad.b[3] = std::numeric_limits<Real>::infinity();
    SolverLadder ladder(controlsFor(500));
    EXPECT_EQ(failureOf(ladder, bad).row(), 3);
    System good;
    ladder.setMatrix(good.a, false);
    EXPECT_TRUE(ladder.solve(good.b, good.x, 1e-8).converged);
}

TEST(LinearSolverLadder, noRowsIsASolvedSystem)
{
    SparseMatrix empty;
    empty.rowStart = {0};
    SolverLadder ladder(controlsFor(500));
    ladder.setMatrix(empty, true);
    EXPECT_TRUE(ladder.solve({}, {}, 1e-6).converged);
}

} // namespace
} // namespace mpsDem
