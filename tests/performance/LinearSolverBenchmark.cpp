#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <benchmark/benchmark.h>

#include "pressure/LinearSolver.h"
#include "support/LinearSolverProblem.h"

namespace {

using namespace mpsDem;

/// Twelve steps of a moving tank, assembled once for all solvers of that size.
struct Series
{
    std::vector<SparseMatrix> matrix;
    std::vector<std::vector<Real>> right;
};

Series const& seriesOf(int dimensions, int rows)
{
    static std::map<std::pair<int, int>, Series> all;
    Series& series = all[{dimensions, rows}];
    if (!series.matrix.empty()) return series;
    test::MovingTank tank(dimensions, rows, 2.1);
    for (int step = 0; step < 12; ++step)
    {
        tank.assemble(series.matrix.emplace_back(), series.right.emplace_back());
        tank.advance(0.1);
    }
    return series;
}

/// One step: new matrix, set-up or its reuse, solve from the pressure of the step before. CPU time counts.
void solveStep(benchmark::State& state, std::string const& solver, std::string const& preconditioner, std::string const& smoother)
{
    int const dimensions = static_cast<int>(state.range(0));
    Series const& series = seriesOf(dimensions, static_cast<int>(state.range(1)));
    SolverControls controls;
    controls.solver = solver;
    controls.preconditioner = preconditioner;
    controls.smoother = smoother;
    controls.dimensions = dimensions;
    controls.maxIter = 5000;
    auto const linear = makeLinearSolver(resolveAutomatic(controls, series.matrix[0].rows));
    std::vector<Real> x(series.right[0].size(), 0);
    linear->setMatrix(series.matrix[0], true);
    linear->solve(series.right[0], x, controls.tolerance);
    std::vector<Real> const start = x;
    std::size_t step = 0;
    Real iterations = 0;
    for (auto _ : state)
    {
        if (++step == series.matrix.size())
        {
            step = 1;
            x = start;
        }
        linear->setMatrix(series.matrix[step], false);
        iterations += linear->solve(series.right[step], x, controls.tolerance).iterations;
    }
    auto const steps = static_cast<Real>(state.iterations());
    auto const rows = static_cast<Real>(series.matrix[0].rows);
    state.counters["iterations"] = iterations / steps;
    state.counters["seconds/row"] = benchmark::Counter(rows * steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void addSizes(benchmark::internal::Benchmark* benchmark)
{
    for (int const rows : {1000, 3000, 10000, 30000, 100000}) benchmark->Args({2, rows});
    for (int const rows : {10000, 100000}) benchmark->Args({3, rows});
    benchmark->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(solveStep, diagonal, "PCG", "diagonal", "auto")->Apply(addSizes);
BENCHMARK_CAPTURE(solveStep, IC, "PCG", "IC", "auto")->Apply(addSizes);
BENCHMARK_CAPTURE(solveStep, EigenIC, "EigenPCG", "IC", "auto")->Apply(addSizes);
BENCHMARK_CAPTURE(solveStep, multigridGaussSeidel, "PCG", "AMG", "symGaussSeidel")->Apply(addSizes);
BENCHMARK_CAPTURE(solveStep, multigridChebyshev, "PCG", "AMG", "Chebyshev")->Apply(addSizes);
BENCHMARK_CAPTURE(solveStep, multigridJacobi, "PCG", "AMG", "Jacobi")->Apply(addSizes);

} // namespace
