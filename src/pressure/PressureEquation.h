#pragma once

#include <memory>

#include "particles/PeriodicImages.h"
#include "pressure/LinearSolver.h"
#include "pressure/PressureGroups.h"
#include "pressure/PressureSource.h"
#include "pressure/SurfacePressure.h"

namespace mpsDem {

/// Eq 8: the pressure Poisson equation of a step, one row per wet particle.
///
/// \f[ \frac{2d}{n^0\lambda}\sum_{j} w_{ij}\,(p_i - p_j) = -b_i \f]
/// over fluid and wet wall particles j that do not face i through a solid (edges, thin bodies). The pressure of surface particles is given (Dirichlet: SurfacePressure, or 0); dry walls and ghosts
/// have no place in it. The matrix is a symmetric M-matrix. Groups of particles without a given pressure in reach (a closed box, an island
/// in flight) are found by a flood fill: up to three particles get p = 0, larger groups have their right side made compatible and their
/// lowest pressure set to zero.
class PressureEquation
{
public:
    /// @param solver    `solvers { p {...} }` of system/mpsSolution.
    /// @param surface   Pressure of surface particles; empty: 0.
    /// @param constants Of the gradient radius (eq 5) and of the Laplacian radius (eq 6).
    PressureEquation(Dictionary const& solver, PressureSource const& source, std::unique_ptr<SurfacePressure> surface,
                     Lattice const& lattice, Real density, ReferenceConstants const& gradientConstants,
                     ReferenceConstants const& laplacianConstants);
    ~PressureEquation();

    /// Builds the matrix for the present positions and labels.
    void assemble(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images);

    /// Solves for particles.p of all owned particles (not clamped), from uStar and n. p of particles without a row becomes zero.
    /// @throw CaseError Solver or NotFinite, naming particle and place.
    SolveReport solve(ParticleSet& particles, NeighbourList const& neighbours, Step const& step);

    /// Change of pressure where u* of the walls changes by dt times an acceleration, for the matrix and the gamma of the step: for the
    /// added mass of bodies. \f[ \langle\nabla^2 p\rangle_i = (1-\gamma)\,\rho\,\nabla\cdot\mathbf a_i \f]
    /// @param acceleration  Of every boundary particle [m/s2], length boundary().last.
    /// @param pressure      Result for all owned particles [Pa].
    SolveReport response(ParticleSet const& particles, NeighbourList const& neighbours, Step const& step, Field<Vector> const& acceleration,
                         Field<Real>& pressure);

    [[nodiscard]] int unknowns() const { return unknowns_; } ///< Of all ranks.
    [[nodiscard]] PressureSource const& source() const { return source_; }
    /// False where p = 0 at the centres of surface particles.
    [[nodiscard]] bool givesSurfacePressure() const { return surface_ != nullptr; }
    /// Groups without a free surface in the last matrix.
    [[nodiscard]] int closedGroups() const { return groups_.count(); }
    /// Forgets what was set up from earlier matrices: called where a checkpoint is written, so that both runs go on alike.
    void forget() { matrixGeneration_ = -1; }

private:
    void chooseRows(ParticleSet const& particles, NeighbourList const& neighbours);
    void reserve(std::size_t entries);
    void appendRow(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images, int i);
    [[nodiscard]] bool isUnknown(ParticleSet const& particles, int i) const;
    SolveReport solveRows(ParticleSet const& particles, Field<Real>& pressure, Real tolerance);
    [[noreturn]] void explain(CaseError const& error, ParticleSet const& particles) const;

    PressureSource source_;
    std::unique_ptr<SurfacePressure> surface_;
    Lattice lattice_;
    Real density_;
    ReferenceConstants gradientConstants_, laplacianConstants_;
    SolverControls controls_;
    std::unique_ptr<LinearSolver> solver_;
    bool stableRows_ = false; ///< One row per fluid and wall particle (identity where known), so that a hierarchy can be kept.
    int matrixGeneration_ = -1;
    int unknowns_ = 0;
    Field<int> row_;      ///< Row of each owned particle, -1 without.
    Field<int> particle_; ///< Particle of each row.
    SparseMatrix matrix_;
    Field<std::uint8_t> pinned_; ///< Per row: coupled to a particle of given pressure.
    PressureGroups groups_;
    Field<Real> known_; ///< Per row: part of the right side from particles of given pressure.
    Field<Real> right_, solution_;
    std::vector<std::pair<int, Real>> entries_;
};

} // namespace mpsDem
