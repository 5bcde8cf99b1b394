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

/// b = A x for a given x, so that the error of a solution is known.
std::vector<Real> imageOf(SparseMatrix const& a, std::vector<Real> const& x)
{
    std::vector<Real> b(x.size());
    multiply(a, x, b);
    return b;
}

std::vector<Real> wave(int rows)
{
    std::vector<Real> x(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) x[i] = std::sin(0.37 * i) + 0.01 * i / rows;
    return x;
}

TEST(LinearSolver, allFindTheSameSolutionAndMeetTheTrueResidual)
{
    for (int const dimensions : {2, 3})
    {
        for (int const rows : {64, 1000, 4000})
        {
            test::MovingTank tank(dimensions, rows, 2.1);
            SparseMatrix a;
            std::vector<Real> b;
            tank.assemble(a, b);
            std::vector<Real> const exact = wave(a.rows);
            b = imageOf(a, exact);
            for (Choice const& choice : choices)
            {
                SCOPED_TRACE(name(choice) + ", rows " + std::to_string(a.rows));
                auto const solver = make(choice, dimensions);
                solver->setMatrix(a, true);
                std::vector<Real> x(b.size(), 0);
                SolveReport const report = solver->solve(b, x, 1e-10);
                EXPECT_TRUE(report.converged);
                EXPECT_NEAR(report.initialResidual, 1, 1e-12);
                EXPECT_LE(relativeResidual(a, b, x), 1.02e-10);
                EXPECT_NEAR(report.finalResidual, relativeResidual(a, b, x), 1e-13);
                EXPECT_LT(largestDifference(x, exact), 1e-6);
            }
        }
    }
}

TEST(LinearSolver, aGoodGuessNeedsNoIteration)
{
    test::MovingTank tank(2, 400, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b);
    std::vector<Real> const exact = wave(a.rows);
    b = imageOf(a, exact);
    for (Choice const& choice : choices)
    {
        SCOPED_TRACE(name(choice));
        auto const solver = make(choice);
        solver->setMatrix(a, true);
        std::vector<Real> x = exact;
        SolveReport const report = solver->solve(b, x, 1e-8);
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.iterations, 0);
        EXPECT_LT(largestDifference(x, exact), 1e-12);
    }
}

TEST(LinearSolver, identityRowsAndIsolatedRowsKeepTheirValue)
{
    test::MovingTank tank(2, 400, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b);
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
    for (Choice const& choice : choices)
    {
        SCOPED_TRACE(name(choice));
        auto const solver = make(choice);
        solver->setMatrix(pinned, true);
        std::vector<Real> x(b.size(), 0);
        EXPECT_TRUE(solver->solve(b, x, 1e-10).converged);
        for (int i = 0; i < a.rows; ++i)
        {
            if (known(i))
            {
                EXPECT_NEAR(x[i], b[i], 1e-7);
            }
        }
    }
}

TEST(LinearSolver, aClosedBoxHasASolutionUpToAConstant)
{
    test::MovingTank tank(2, 900, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b, 0.1, false);
    std::vector<Real> const exact = wave(a.rows);
    b = imageOf(a, exact); // compatible: it sums to zero
    for (Choice const& choice : choices)
    {
        SCOPED_TRACE(name(choice));
        auto const solver = make(choice);
        solver->setMatrix(a, true);
        std::vector<Real> x(b.size(), 0);
        SolveReport const report = solver->solve(b, x, 1e-8);
        EXPECT_TRUE(report.converged);
        Real shift = 0;
        for (std::size_t i = 0; i < x.size(); ++i) shift += (x[i] - exact[i]) / static_cast<Real>(x.size());
        for (Real& value : x) value -= shift;
        EXPECT_LT(largestDifference(x, exact), 1e-5);
    }
}

TEST(LinearSolver, zeroRightHandSideGivesZero)
{
    test::MovingTank tank(2, 400, 2.1);
    SparseMatrix a;
    std::vector<Real> b;
    tank.assemble(a, b);
    std::fill(b.begin(), b.end(), 0);
    auto const solver = make({"PCG", "IC", "auto"});
    solver->setMatrix(a, true);
    std::vector<Real> x = wave(a.rows);
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
