#include <algorithm>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "pressure/BelosSolver.h"
#include "pressure/ConjugateGradient.h"
#include "support/LinearSolverProblem.h"

namespace mpsDem {
namespace {

using Kind = ConjugateGradient::Preconditioner;

SolverControls controlsFor(int maxIter)
{
    SolverControls controls;
    controls.smoother = "symGaussSeidel";
    controls.maxIter = maxIter;
    return controls;
}

/// The same matrix with its rows in another order: row i of the result is row order[i].
SparseMatrix reordered(SparseMatrix const& a, std::vector<int> const& order)
{
    std::vector<int> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<int>(i);
    SparseMatrix result;
    result.rows = a.rows;
    result.rowStart = {0};
    for (int const row : order)
    {
        std::vector<std::pair<int, Real>> entries;
        for (int k = a.rowStart[row]; k < a.rowStart[row + 1]; ++k) entries.emplace_back(rank[a.column[k]], a.value[k]);
        std::sort(entries.begin(), entries.end());
        for (auto const& [column, value] : entries)
        {
            result.column.push_back(column);
            result.value.push_back(value);
        }
        result.rowStart.push_back(static_cast<int>(result.value.size()));
    }
    return result;
}

TEST(LinearSolverReuse, multigridKeepsItsAggregatesOverThirtyMovingSteps)
{
    test::MovingTank tank(2, 6000, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    std::vector<Real> x;
    BelosSolver solver(controlsFor(60));
    int first = 0;
    for (int step = 0; step < 30; ++step)
    {
        tank.assemble(a, b);
        x.resize(b.size(), 0);
        solver.setMatrix(a, step == 20); // at step 20 the rows are said to be others
        SolveReport const report = solver.solve(b, x, 1e-6);
        ASSERT_TRUE(report.converged) << "step " << step;
        EXPECT_LE(relativeResidual(a, b, x), 1e-6);
        if (step == 0) first = report.iterations;
        EXPECT_LE(report.iterations, 1.5 * first);
        tank.advance(0.1);
    }
    EXPECT_LE(solver.rebuilds(), 4);
    EXPECT_GE(solver.rebuilds(), 2);
}

TEST(LinearSolverReuse, multigridFollowsAChangeOfSize)
{
    BelosSolver solver(controlsFor(60));
    for (int const rows : {900, 4900, 2500})
    {
        test::MovingTank tank(2, rows, 2.1);
        SparseMatrix a;
        std::vector<Real> b;
        tank.assemble(a, b);
        std::vector<Real> x(b.size(), 0);
        solver.setMatrix(a, false);
        EXPECT_TRUE(solver.solve(b, x, 1e-8).converged);
        EXPECT_LE(relativeResidual(a, b, x), 1e-8);
    }
}

TEST(LinearSolverReuse, severalRightHandSidesShareOneMatrix)
{
    test::MovingTank tank(2, 2500, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b);
    ConjugateGradient solver(Kind::IncompleteCholesky, controlsFor(200));
    solver.setMatrix(a, true);
    for (int column = 0; column < 3; ++column)
    {
        std::vector<Real> x(b.size(), 0);
        for (Real& value : b) value *= -2;
        EXPECT_TRUE(solver.solve(b, x, 1e-6).converged);
        EXPECT_LE(relativeResidual(a, b, x), 1e-6);
    }
}

/// Modified incomplete Cholesky: four times the rows cost about the square root of two in iterations, plain ones two.
TEST(LinearSolverReuse, choleskyIterationsGrowWithTheFourthRootOfTheRows)
{
    std::vector<int> iterations;
    for (int const rows : {2500, 10000, 40000})
    {
        test::MovingTank tank(2, rows, 2.1);
        SparseMatrix a;
        std::vector<Real> b;
        tank.assemble(a, b);
        std::vector<Real> x(b.size(), 0);
        ConjugateGradient solver(Kind::IncompleteCholesky, controlsFor(500));
        solver.setMatrix(a, true);
        iterations.push_back(solver.solve(b, x, 1e-6).iterations);
    }
    Real const growth = static_cast<Real>(iterations[2]) / iterations[0];
    std::printf("%-48s %14.6g  bound %g\n", "IC iterations, 40000 over 2500 rows", growth, 2.4);
    EXPECT_LT(growth, 2.4); // 2 = 16^(1/4)
    EXPECT_LT(iterations[1], 60);
}

TEST(LinearSolverReuse, mixedRowsCostAtMostTwiceTheIterations)
{
    test::MovingTank tank(2, 10000, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b);
    std::vector<int> order(b.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>((i * 7919) % order.size());
    SparseMatrix const mixed = reordered(a, order);
    std::vector<Real> mixedRight(b.size());
    for (std::size_t i = 0; i < order.size(); ++i) mixedRight[i] = b[order[i]];

    ConjugateGradient solver(Kind::IncompleteCholesky, controlsFor(500));
    std::vector<Real> x(b.size(), 0);
    solver.setMatrix(a, true);
    int const inOrder = solver.solve(b, x, 1e-6).iterations;
    std::vector<Real> y(b.size(), 0);
    solver.setMatrix(mixed, true);
    SolveReport const report = solver.solve(mixedRight, y, 1e-6);
    EXPECT_TRUE(report.converged);
    std::printf("%-48s %14d  bound %d\n", "IC iterations with mixed rows", report.iterations, 2 * inOrder);
    EXPECT_LE(report.iterations, 2 * inOrder);
    Real most = 0;
    for (std::size_t i = 0; i < order.size(); ++i) most = std::max(most, std::abs(y[i] - x[order[i]]));
    EXPECT_LT(most, 1e-3 * *std::max_element(x.begin(), x.end()));
}

TEST(LinearSolverReuse, theSameSolveTwiceGivesTheSameBits)
{
    test::MovingTank tank(2, 2500, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b);
    std::vector<std::vector<Real>> answers;
    for (int run = 0; run < 2; ++run)
    {
        ConjugateGradient solver(Kind::IncompleteCholesky, controlsFor(500));
        solver.setMatrix(a, true);
        std::vector<Real> x(b.size(), 0);
        solver.solve(b, x, 1e-6);
        answers.push_back(x);
    }
    EXPECT_EQ(answers[0], answers[1]);
}

} // namespace
} // namespace mpsDem
