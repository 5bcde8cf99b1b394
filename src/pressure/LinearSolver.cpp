#include "pressure/LinearSolver.h"

#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Errors.h"
#include "pressure/BelosSolver.h"
#include "pressure/ConjugateGradient.h"
#include "pressure/EigenSolver.h"

namespace mpsDem {

namespace {

/// From so many unknowns on `auto` means algebraic multigrid (etc/doc/linear-solvers.md).
constexpr int multigridRows2D = 150000;
constexpr int multigridRows3D = 1000000;

std::vector<std::string> const solverWords = {"PCG", "EigenPCG", "auto"};
std::vector<std::string> const preconditionerWords = {"none", "diagonal", "IC", "AMG", "auto"};
std::vector<std::string> const smootherWords = {"symGaussSeidel", "Chebyshev", "Jacobi", "auto"};

int countIn(Dictionary const& dictionary, std::string const& key, int fallback)
{
    int const count = dictionary.getOr<int>(key, fallback);
    require(count >= 1, dictionary.where(key), key + " is " + std::to_string(count), "allowed: 1 or more");
    return count;
}

} // namespace

SolverControls readSolverControls(Dictionary const& dictionary)
{
    SolverControls controls;
    controls.solver = dictionary.getWordOr("solver", controls.solver, solverWords, "solvers");
    controls.preconditioner = dictionary.getWordOr("preconditioner", controls.preconditioner, preconditionerWords, "preconditioners");
    controls.smoother = dictionary.getWordOr("smoother", controls.smoother, smootherWords, "smoothers");
    controls.tolerance = dictionary.getInRangeOr("tolerance", controls.tolerance, 1e-14, 0.1);
    controls.relTol = dictionary.getInRangeOr("relTol", controls.relTol, 0, 0.99);
    controls.maxIter = countIn(dictionary, "maxIter", controls.maxIter);
    controls.rebuildInterval = countIn(dictionary, "rebuildInterval", controls.rebuildInterval);
    require(controls.solver != "EigenPCG" || controls.preconditioner != "AMG", dictionary.where("preconditioner"),
            "EigenPCG has no preconditioner \"AMG\"", "allowed: none, diagonal, IC, auto; or solver PCG");
    return controls;
}

SolverControls resolveAutomatic(SolverControls const& controls, int rows)
{
    int const multigridFrom = controls.dimensions == 2 ? multigridRows2D : multigridRows3D;
    SolverControls resolved = controls;
    if (resolved.solver == "auto") resolved.solver = "PCG";
    if (resolved.preconditioner == "auto")
    {
        resolved.preconditioner = resolved.solver == "PCG" && rows >= multigridFrom ? "AMG" : "IC";
    }
    if (resolved.smoother == "auto") resolved.smoother = "symGaussSeidel";
    return resolved;
}

std::unique_ptr<LinearSolver> makeLinearSolver(SolverControls const& controls)
{
    if (controls.solver == "EigenPCG") return std::make_unique<EigenSolver>(controls);
    if (controls.preconditioner == "AMG") return std::make_unique<BelosSolver>(controls);
    using Kind = ConjugateGradient::Preconditioner;
    Kind kind = Kind::IncompleteCholesky;
    if (controls.preconditioner == "diagonal") kind = Kind::Diagonal;
    if (controls.preconditioner == "none") kind = Kind::None;
    return std::make_unique<ConjugateGradient>(kind, controls);
}

} // namespace mpsDem
