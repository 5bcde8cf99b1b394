#include "pressure/PressureEquation.h"

#include <algorithm>
#include <sstream>

#include "core/Errors.h"
#include "parallel/Reduce.h"
#include "pressure/SolverLadder.h"

namespace mpsDem {

namespace {

/// Residual of the added-mass solves: their result is a coefficient, not a state.
constexpr Real responseTolerance = 1e-3;
/// A particle this far behind the plane of a wall particle lies on another side of the solid, in spacings.
constexpr Real beyond = 0.5;
/// The same for fluid straight behind: nearer, it lies at the only wall row that a body thinner than 1.75 spacings has for both sides.
constexpr Real straightBeyond = 1.5;
constexpr Real straight = 0.9; ///< Cosine from which a direction is straight.

/// Whether fluid at distance r, `behind` the plane of a wall particle, is on another side of the solid.
bool isBeyond(Real behind, Real r, Real spacing) { return behind > (behind > straight * r ? straightBeyond : beyond) * spacing; }

/// Whether two particles face each other through a solid: pressure does not act that way.
bool solidBetween(ParticleSet const& particles, int i, int j)
{
    bool const fluidI = particles.isFluid(i), fluidJ = particles.isFluid(j);
    if (fluidI && fluidJ) return false;
    Real const spacing = particles.lattice().spacing;
    Vector const rij = particles.r[j] - particles.r[i];
    Real const behindI = -rij.dot(particles.normal[i]), behindJ = rij.dot(particles.normal[j]);
    if (fluidI || fluidJ) return isBeyond(fluidI ? behindJ : behindI, rij.norm(), spacing);
    return particles.body[i] == particles.body[j] && behindI > beyond * spacing && behindJ > beyond * spacing;
}

} // namespace

PressureEquation::PressureEquation(Dictionary const& solver, PressureSource const& source, std::unique_ptr<SurfacePressure> surface,
                                   Lattice const& lattice, Real density, ReferenceConstants const& gradientConstants,
                                   ReferenceConstants const& laplacianConstants)
    : source_(source),
      surface_(std::move(surface)),
      lattice_(lattice),
      density_(density),
      gradientConstants_(gradientConstants),
      laplacianConstants_(laplacianConstants),
      controls_(readSolverControls(solver))
{
    controls_.dimensions = lattice.dimensions;
    solver_ = std::make_unique<SolverLadder>(controls_);
}

PressureEquation::~PressureEquation() = default;

bool PressureEquation::isUnknown(ParticleSet const& particles, int i) const
{
    bool const carries = particles.isFluid(i) || (particles.type[i] == ParticleType::Wall && particles.wet[i]);
    return carries && particles.surface[i] != SurfaceLabel::Surface;
}

void PressureEquation::chooseRows(ParticleSet const& particles, NeighbourList const& neighbours)
{
    row_.assign(static_cast<std::size_t>(particles.owned().last), -1);
    particle_.clear();
    unknowns_ = static_cast<int>(countOver(particles.owned(), [&](int i) { return isUnknown(particles, i); }));
    stableRows_ = resolveAutomatic(controls_, unknowns_).preconditioner == "AMG";
    for (int i : particles.owned())
    {
        bool const wanted = stableRows_ ? particles.type[i] != ParticleType::Ghost : isUnknown(particles, i);
        if (!wanted) continue;
        row_[i] = static_cast<int>(particle_.size());
        particle_.push_back(i);
    }
    matrix_.rows = static_cast<int>(particle_.size());
    reserve(neighbours.pairs() + particle_.size());
    matrix_.rowStart.assign(1, 0);
    matrix_.column.clear();
    matrix_.value.clear();
    pinned_.assign(particle_.size(), 0);
    known_.assign(particle_.size(), 0);
}

/// Room for the matrix and for all fields by row. As many rows as particles may be needed, and the number of pairs grows slowly: with a
/// quarter to spare hardly any step allocates.
void PressureEquation::reserve(std::size_t entries)
{
    for (auto* const field : {&known_, &right_, &solution_}) field->reserve(row_.size());
    particle_.reserve(row_.size());
    pinned_.reserve(row_.size());
    matrix_.rowStart.reserve(row_.size() + 1);
    if (matrix_.column.capacity() >= entries) return;
    matrix_.column.reserve(entries + entries / 4);
    matrix_.value.reserve(entries + entries / 4);
}

void PressureEquation::appendRow(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images, int i)
{
    Real const factor = laplacianConstants_.laplacianFactor(lattice_.dimensions);
    Real const* const w = neighbours.laplacianWeight();
    int const row = row_[i];
    Real diagonal = 0;
    entries_.clear();
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        bool const carries = particles.isFluid(j) || (particles.type[j] == ParticleType::Wall && particles.wet[j]);
        if (w[k] <= 0 || !carries || solidBetween(particles, i, j)) continue;
        Real const a = factor * w[k];
        diagonal += a;
        if (particles.surface[j] == SurfaceLabel::Surface)
        {
            pinned_[row] = 1;
            if (surface_) known_[row] += a * (*surface_)[j];
        }
        else
            entries_.emplace_back(row_[images.source(particles, j)], -a);
    }
    if (diagonal == 0)
    {
        diagonal = factor;
        pinned_[row] = 1;
    }
    entries_.emplace_back(row, diagonal);
    std::sort(entries_.begin(), entries_.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
    std::size_t const begin = matrix_.column.size();
    for (auto const& [column, value] : entries_)
    {
        // Two images of one particle may both be neighbours: one entry.
        if (matrix_.column.size() > begin && matrix_.column.back() == column)
            matrix_.value.back() += value;
        else
        {
            matrix_.column.push_back(column);
            matrix_.value.push_back(value);
        }
    }
}

void PressureEquation::assemble(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images)
{
    chooseRows(particles, neighbours);
    if (surface_) surface_->evaluate(particles, neighbours, gradientConstants_, images);
    for (int const i : particle_)
    {
        if (isUnknown(particles, i))
            appendRow(particles, neighbours, images, i);
        else
        {
            pinned_[row_[i]] = 1;
            matrix_.column.push_back(row_[i]);
            matrix_.value.push_back(laplacianConstants_.laplacianFactor(lattice_.dimensions) * laplacianConstants_.n0);
        }
        matrix_.rowStart.push_back(static_cast<int>(matrix_.column.size()));
    }
    groups_.find(matrix_, pinned_);
    bool const changed = !stableRows_ || matrixGeneration_ != particles.generation();
    matrixGeneration_ = particles.generation();
    solver_->setMatrix(matrix_, changed);
}

SolveReport PressureEquation::solveRows(ParticleSet const& particles, Field<Real>& pressure, Real tolerance)
{
    groups_.makeCompatible(right_);
    SolveReport report;
    try
    {
        report = solver_->solve(right_, solution_, tolerance);
    }
    catch (CaseError const& error)
    {
        explain(error, particles);
    }
    groups_.shift(solution_);
    std::fill(pressure.begin(), pressure.end(), 0);
    for (std::size_t row = 0; row < particle_.size(); ++row) pressure[particle_[row]] = solution_[row];
    return report;
}

SolveReport PressureEquation::solve(ParticleSet& particles, NeighbourList const& neighbours, Step const& step)
{
    right_.resize(particle_.size());
    solution_.resize(particle_.size());
    for (std::size_t row = 0; row < particle_.size(); ++row)
    {
        int const i = particle_[row];
        bool const unknown = isUnknown(particles, i);
        right_[row] = unknown ? known_[row] - source_.evaluate(particles, neighbours, gradientConstants_, step, i) : 0;
        solution_[row] = unknown ? particles.p[i] : 0;
    }
    SolveReport const report = solveRows(particles, particles.p, controls_.tolerance);
    if (surface_) surface_->assign(particles);
    return report;
}

SolveReport PressureEquation::response(ParticleSet const& particles, NeighbourList const& neighbours, Step const& step,
                                       Field<Vector> const& acceleration, Field<Real>& pressure)
{
    right_.assign(particle_.size(), 0);
    solution_.assign(particle_.size(), 0);
    Real const factor = -density_ * source_.divergenceShare(step);
    int const boundary = particles.boundary().last;
    Vector const none = Vector::Zero();
    auto const of = [&](int j) -> Vector const& { return j < boundary ? acceleration[j] : none; };
    auto const besideBoundary = [&](int i) {
        return std::any_of(neighbours.index() + neighbours.first(i), neighbours.index() + neighbours.last(i),
                           [&](int j) { return j < boundary; });
    };
    for (std::size_t row = 0; row < particle_.size(); ++row)
    {
        int const i = particle_[row];
        if (!isUnknown(particles, i) || (i >= boundary && !besideBoundary(i))) continue;
        right_[row] = factor * source_.divergence(particles, neighbours, gradientConstants_, of, i);
    }
    pressure.resize(particles.r.size());
    return solveRows(particles, pressure, std::max(controls_.tolerance, responseTolerance));
}

void PressureEquation::explain(CaseError const& error, ParticleSet const& particles) const
{
    std::ostringstream text;
    text << "pressure equation: " << error.what();
    // The row that the solver names, but where the right side is finite and its norm is not: that of the largest right side.
    auto const* const failure = dynamic_cast<SolverFailure const*>(&error);
    bool const named = failure && !(std::isfinite(right_[failure->row()]) && !std::isfinite(norm(right_)));
    auto const worst = std::max_element(right_.begin(), right_.end(), [](Real a, Real b) { return !(std::abs(a) >= std::abs(b)); });
    if (worst != right_.end())
    {
        std::ptrdiff_t const row = named ? failure->row() : worst - right_.begin();
        int const i = particle_[static_cast<std::size_t>(row)];
        Vector const r = particles.r[i];
        text << "\n    " << (named ? "that row is" : "largest right side at") << " particle " << particles.id[i] << " at (" << r.x() << ' '
             << r.y() << ' ' << r.z() << "), |u| = " << particles.u[i].norm() << " m/s, n/n0 = " << particles.n[i];
    }
    throw CaseError(error.code(), text.str(), "a smaller maxDeltaT or maxCo, or another scheme of system/mpsSchemes, may help");
}

} // namespace mpsDem
