#include "pressure/BelosSolver.h"

#include <algorithm>
#include <cfenv>
#include <cstdlib>
#include <exception>
#include <string>

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Kokkos_Core.hpp>
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

namespace mpsDem {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;
using Map = Tpetra::Map<>;
using LocalIndex = Map::local_ordinal_type;
using GlobalIndex = Map::global_ordinal_type;
using Matrix = Tpetra::CrsMatrix<Real>;
using MultiVector = Tpetra::MultiVector<Real>;
using Operator = Tpetra::Operator<Real>;
using Hierarchy = MueLu::TpetraOperator<Real, LocalIndex, GlobalIndex, Map::node_type>;

/// Belos and MueLu compare with NaN and divide by zero on the way to an exception: floating-point traps are held off meanwhile.
class TrapHold
{
public:
    TrapHold() { std::feholdexcept(&environment_); }
    ~TrapHold() { std::fesetenv(&environment_); }
    TrapHold(TrapHold const&) = delete;
    TrapHold& operator=(TrapHold const&) = delete;

private:
    std::fenv_t environment_{};
};

/// MueLu needs MPI even on one rank. Whoever started it before us ends it.
void startTrilinos()
{
    if (Tpetra::isInitialized()) return;
    int count = 0;
    char** words = nullptr;
    Tpetra::initialize(&count, &words);
    std::atexit([] { Tpetra::finalize(); });
}

/// Each rank solves its own rows. With a matrix over several ranks the coarse solver must change as well: KLU2 of Trilinos 13.2 gives
/// wrong answers on two ranks.
RCP<Teuchos::Comm<int> const> communicator() { return rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF)); }

/// A copy of the rows in Trilinos' own views.
RCP<Matrix> makeMatrix(SparseMatrix const& a, RCP<Map const> const& map)
{
    using Local = Matrix::local_matrix_device_type;
    using Graph = Local::staticcrsgraph_type;
    using Kokkos::ViewAllocateWithoutInitializing;
    auto const rows = static_cast<std::size_t>(a.rows);
    Graph::row_map_type::non_const_type starts(ViewAllocateWithoutInitializing("starts"), rows + 1);
    Graph::entries_type::non_const_type columns(ViewAllocateWithoutInitializing("columns"), a.entries());
    Local::values_type values(ViewAllocateWithoutInitializing("values"), a.entries());
    for (std::size_t i = 0; i <= rows; ++i) starts.data()[i] = static_cast<std::size_t>(a.rowStart[i]);
    std::copy(a.column.begin(), a.column.end(), columns.data());
    std::copy(a.value.begin(), a.value.end(), values.data());
    RCP<Matrix> const matrix = rcp(new Matrix(map, map, starts, columns, values));
    matrix->expertStaticFillComplete(map, map);
    return matrix;
}

void addSmoother(Teuchos::ParameterList& list, std::string const& smoother)
{
    Teuchos::ParameterList& details = list.sublist("smoother: params");
    if (smoother == "Chebyshev")
    {
        list.set("smoother: type", "CHEBYSHEV");
        details.set("chebyshev: degree", 2);
        // The ten power iterations of the default underestimate the largest eigenvalue in 3-D, which makes the cycle indefinite.
        details.set("chebyshev: eigenvalue max iterations", 40);
        details.set("chebyshev: boost factor", 1.1);
        return;
    }
    bool const jacobi = smoother == "Jacobi";
    list.set("smoother: type", "RELAXATION");
    details.set("relaxation: type", jacobi ? "Jacobi" : "Symmetric Gauss-Seidel");
    details.set("relaxation: sweeps", 1);
    details.set("relaxation: damping factor", jacobi ? 0.66 : 1.0);
}

Teuchos::ParameterList hierarchyParameters(SolverControls const& controls)
{
    Teuchos::ParameterList list;
    list.set("verbosity", "none");
    list.set("multigrid algorithm", "sa");
    list.set("aggregation: drop tol", 0.0);
    list.set("coarse: max size", 2000);
    list.set("reuse: type", "RAP");
    addSmoother(list, controls.smoother);
    return list;
}

} // namespace

struct BelosSolver::Implementation
{
    explicit Implementation(SolverControls const& c) : controls(c) { startTrilinos(); }

    /// Hierarchy for the present matrix, from scratch or with the aggregates kept.
    void prepare(bool fromScratch)
    {
        TrapHold const hold;
        if (fromScratch || hierarchy.is_null())
        {
            hierarchy = Teuchos::null;
            Teuchos::ParameterList list = hierarchyParameters(controls);
            RCP<Operator> const a = matrix;
            hierarchy = MueLu::CreateTpetraPreconditioner(a, list);
            ++rebuilds;
            solvesSince = 0;
            iterationsAfterRebuild = -1;
            return;
        }
        MueLu::ReuseTpetraPreconditioner(matrix, *hierarchy);
    }

    /// One call of Belos; false where it threw or did not converge.
    bool run(std::span<Real const> b, std::span<Real> x, Real tolerance, int& iterations)
    {
        TrapHold const hold;
        RCP<MultiVector> const right = rcp(new MultiVector(map, 1, false));
        RCP<MultiVector> const left = rcp(new MultiVector(map, 1, false));
        std::copy(b.begin(), b.end(), right->getDataNonConst(0).getRawPtr());
        std::copy(x.begin(), x.end(), left->getDataNonConst(0).getRawPtr());
        RCP<Belos::LinearProblem<Real, MultiVector, Operator>> const problem =
            rcp(new Belos::LinearProblem<Real, MultiVector, Operator>(matrix, left, right));
        problem->setRightPrec(hierarchy);
        if (!problem->setProblem()) return false;
        RCP<Teuchos::ParameterList> const list = Teuchos::parameterList();
        list->set("Maximum Iterations", controls.maxIter);
        list->set("Convergence Tolerance", tolerance);
        list->set("Implicit Residual Scaling", "Norm of RHS");
        Belos::PseudoBlockCGSolMgr<Real, MultiVector, Operator> solver(problem, list);
        bool const converged = solver.solve() == Belos::Converged;
        iterations += solver.getNumIters();
        auto const answer = left->getData(0);
        std::copy(answer.begin(), answer.end(), x.begin());
        return converged;
    }

    SolverControls controls;
    SparseMatrix const* rows = nullptr;
    RCP<Map const> map;
    RCP<Matrix> matrix;
    RCP<Hierarchy> hierarchy;
    std::vector<Real> guess;
    int solvesSince = 0;
    int iterationsAfterRebuild = -1;
    int rebuilds = 0;
    bool worn = false;   ///< The iterations have grown: rebuild at the next matrix.
    bool broken = false; ///< MueLu threw: solves fail until a rebuild works.
};

BelosSolver::BelosSolver(SolverControls const& controls) : implementation_(std::make_unique<Implementation>(controls)) {}

BelosSolver::~BelosSolver() = default;

int BelosSolver::rebuilds() const { return implementation_->rebuilds; }

void BelosSolver::setMatrix(SparseMatrix const& matrix, bool rowsChanged)
{
    Implementation& i = *implementation_;
    bool const resized = i.rows == nullptr || i.map.is_null() || static_cast<int>(i.map->getGlobalNumElements()) != matrix.rows;
    i.rows = &matrix;
    if (resized) i.map = rcp(new Map(static_cast<Tpetra::global_size_t>(matrix.rows), 0, communicator()));
    i.matrix = makeMatrix(matrix, i.map);
    bool const fromScratch =
        resized || rowsChanged || i.worn || i.broken || i.hierarchy.is_null() || i.solvesSince >= i.controls.rebuildInterval;
    try
    {
        i.prepare(fromScratch);
        i.worn = false;
        i.broken = false;
    }
    catch (std::exception const&)
    {
        if (fromScratch)
            i.broken = true;
        else
            rebuild(0);
    }
}

void BelosSolver::rebuild(Real)
{
    Implementation& i = *implementation_;
    try
    {
        i.prepare(true);
        i.broken = false;
    }
    catch (std::exception const&)
    {
        i.broken = true;
    }
    i.worn = false;
}

SolveReport BelosSolver::solve(std::span<Real const> b, std::span<Real> x, Real tolerance)
{
    Implementation& i = *implementation_;
    SolveReport report;
    report.solverName = "MueLuPCG";
    report.initialResidual = relativeResidual(*i.rows, b, x);
    report.finalResidual = report.initialResidual;
    Real const goal = std::max(tolerance, i.controls.relTol * report.initialResidual);
    report.converged = report.initialResidual <= goal;
    if (report.converged || i.broken) return report;
    i.guess.assign(x.begin(), x.end());
    // The second round answers a recurrence that has drifted from the true residual.
    for (int round = 0; round < 2 && !report.converged; ++round)
    {
        try
        {
            i.run(b, x, round == 0 ? goal : 0.5 * goal, report.iterations);
        }
        catch (std::exception const&)
        {
            std::copy(i.guess.begin(), i.guess.end(), x.begin());
            i.worn = true;
            break;
        }
        report.finalResidual = relativeResidual(*i.rows, b, x);
        report.converged = report.finalResidual <= goal;
    }
    ++i.solvesSince;
    if (i.iterationsAfterRebuild < 0) i.iterationsAfterRebuild = std::max(report.iterations, 1);
    if (report.iterations > i.controls.rebuildRatio * i.iterationsAfterRebuild + 1) i.worn = true;
    return report;
}

} // namespace mpsDem
