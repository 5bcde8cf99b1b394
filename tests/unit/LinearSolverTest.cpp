#include "pressure/LinearSolver.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Dictionary.h"
#include "core/Errors.h"
#include "support/LinearSolverProblem.h"

namespace mpsDem {
namespace {

struct Choice
{
    char const* solver;
    char const* preconditioner;
    char const* smoother;
};

std::vector<Choice> const choices = {
    {"PCG", "none", "auto"},     {"PCG", "diagonal", "auto"}, {"PCG", "IC", "auto"},      {"PCG", "AMG", "symGaussSeidel"},
    {"PCG", "AMG", "Chebyshev"}, {"PCG", "AMG", "Jacobi"},    {"EigenPCG", "IC", "auto"}, {"EigenPCG", "diagonal", "auto"},
};

std::unique_ptr<LinearSolver> make(Choice const& choice, int dimensions = 2)
{
    SolverControls controls;
    controls.solver = choice.solver;
    controls.preconditioner = choice.preconditioner;
    controls.smoother = choice.smoother;
    controls.maxIter = 2000;
    controls.dimensions = dimensions;
    return makeLinearSolver(resolveAutomatic(controls, 1));
}

std::string name(Choice const& choice) { return std::string(choice.solver) + " " + choice.preconditioner + " " + choice.smoother; }

Real largestDifference(std::vector<Real> const& a, std::vector<Real> const& b)
{
    Real most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

std::vector<Real> wave(int rows)
{
    std::vector<Real> x(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) x[i] = std::sin(0.37 * i) + 0.01 * i / rows;
    return x;
}

/// The equation of a tank whose solution is known: b = A x for the wave x.
struct Problem
{
    explicit Problem(int rows, int dimensions = 2, bool pinned = true)
    {
        test::MovingTank tank(dimensions, rows, 2.1);
        tank.assemble(a, b, 0.1, pinned);
        exact = wave(a.rows);
        multiply(a, exact, b);
    }

    SparseMatrix a;
    std::vector<Real> b, exact;
};

/// Calls check(solver) for every choice, with the matrix set.
template <class Check>
void forEachChoice(SparseMatrix const& a, int dimensions, Check const& check)
{
    for (Choice const& choice : choices)
    {
        SCOPED_TRACE(name(choice) + ", rows " + std::to_string(a.rows));
        auto const solver = make(choice, dimensions);
        solver->setMatrix(a, true);
        check(*solver);
    }
}

TEST(LinearSolver, allFindTheSameSolutionAndMeetTheTrueResidual)
{
    for (int const dimensions : {2, 3})
    {
        for (int const rows : {64, 1000, 4000})
        {
            Problem const problem(rows, dimensions);
            forEachChoice(problem.a, dimensions, [&](LinearSolver& solver) {
                std::vector<Real> x(problem.b.size(), 0);
                SolveReport const report = solver.solve(problem.b, x, 1e-10);
                EXPECT_TRUE(report.converged);
                EXPECT_NEAR(report.initialResidual, 1, 1e-12);
                EXPECT_LE(relativeResidual(problem.a, problem.b, x), 1.02e-10);
                EXPECT_NEAR(report.finalResidual, relativeResidual(problem.a, problem.b, x), 1e-13);
                EXPECT_LT(largestDifference(x, problem.exact), 1e-6);
            });
        }
    }
}

TEST(LinearSolver, aGoodGuessNeedsNoIteration)
{
    Problem const problem(400);
    forEachChoice(problem.a, 2, [&](LinearSolver& solver) {
        std::vector<Real> x = problem.exact;
        SolveReport const report = solver.solve(problem.b, x, 1e-8);
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.iterations, 0);
        EXPECT_LT(largestDifference(x, problem.exact), 1e-12);
    });
}

TEST(LinearSolver, identityRowsAndIsolatedRowsKeepTheirValue)
{
    Problem const problem(400);
    SparseMatrix const& a = problem.a;
    std::vector<Real> b = problem.b;
    // Every seventh row is made an identity row; its couplings vanish on both sides.
    SparseMatrix pinned;
    pinned.rows = a.rows;
    pinned.rowStart = {0};
    auto const known = [](int i) { return i % 7 == 3; };
    for (int i = 0; i < a.rows; ++i)
    {
        for (int k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k)
        {
            int const j = a.column[k];
            if (i != j && (known(i) || known(j))) continue;
            pinned.column.push_back(j);
            pinned.value.push_back(known(i) ? 1 : a.value[k]);
        }
        pinned.rowStart.push_back(static_cast<int>(pinned.column.size()));
        if (known(i)) b[i] = 0.5 * i;
    }
    forEachChoice(pinned, 2, [&](LinearSolver& solver) {
        std::vector<Real> x(b.size(), 0);
        EXPECT_TRUE(solver.solve(b, x, 1e-10).converged);
        for (int i = 3; i < a.rows; i += 7) EXPECT_NEAR(x[i], b[i], 1e-7);
    });
}

TEST(LinearSolver, aClosedBoxHasASolutionUpToAConstant)
{
    Problem const problem(900, 2, false); // b is compatible: it sums to zero
    forEachChoice(problem.a, 2, [&](LinearSolver& solver) {
        std::vector<Real> x(problem.b.size(), 0);
        EXPECT_TRUE(solver.solve(problem.b, x, 1e-8).converged);
        Real shift = 0;
        for (std::size_t i = 0; i < x.size(); ++i) shift += (x[i] - problem.exact[i]) / static_cast<Real>(x.size());
        for (Real& value : x) value -= shift;
        EXPECT_LT(largestDifference(x, problem.exact), 1e-5);
    });
}

TEST(LinearSolver, zeroRightHandSideGivesZero)
{
    Problem const problem(400);
    std::vector<Real> const b(problem.b.size(), 0);
    auto const solver = make({"PCG", "IC", "auto"});
    solver->setMatrix(problem.a, true);
    std::vector<Real> x = problem.exact;
    EXPECT_TRUE(solver->solve(b, x, 1e-9).converged);
    EXPECT_LT(norm(x), 1e-6);
}

TEST(LinearSolver, readsItsControlsAndRefusesUnknownWords)
{
    Dictionary const p = Dictionary::fromText("solver PCG; preconditioner AMG; smoother Jacobi; tolerance 1e-5; relTol 0.01; maxIter 60;",
                                              "system/mpsSolution");
    SolverControls const controls = readSolverControls(p);
    EXPECT_EQ(controls.preconditioner, "AMG");
    EXPECT_EQ(controls.smoother, "Jacobi");
    EXPECT_EQ(controls.tolerance, 1e-5);
    EXPECT_EQ(controls.relTol, 0.01);
    EXPECT_EQ(controls.maxIter, 60);
    EXPECT_NO_THROW(p.requireAllRead());

    for (char const* const wrong : {"solver PGC;", "preconditioner DIC;", "smoother GaussSeidel;", "tolerance 2;", "relTol -1;",
                                    "maxIter 0;", "solver EigenPCG; preconditioner AMG;"})
    {
        SCOPED_TRACE(wrong);
        EXPECT_THROW(readSolverControls(Dictionary::fromText(wrong)), CaseError);
    }
}

TEST(LinearSolver, autoMeansCholeskyForFewAndMultigridForManyRows)
{
    SolverControls controls;
    EXPECT_EQ(resolveAutomatic(controls, 1000).preconditioner, "IC");
    EXPECT_EQ(resolveAutomatic(controls, 100000).preconditioner, "IC");
    EXPECT_EQ(resolveAutomatic(controls, 1000000).preconditioner, "AMG");
    EXPECT_EQ(resolveAutomatic(controls, 1000000).solver, "PCG");
    controls.solver = "EigenPCG";
    EXPECT_EQ(resolveAutomatic(controls, 1000000).preconditioner, "IC");
    controls.preconditioner = "diagonal";
    EXPECT_EQ(resolveAutomatic(controls, 10).preconditioner, "diagonal");
}

} // namespace
} // namespace mpsDem
