#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "boundaries/BoundaryLabeller.h"
#include "boundaries/WallGuard.h"
#include "core/Surface.h"
#include "coupling/FluidBodyCoupling.h"
#include "fluid/Fluid.h"
#include "fluid/TimeStep.h"
#include "particles/PeriodicImages.h"
#include "pressure/PressureEquation.h"

namespace mpsDem {

/// Dictionaries and constants that the fluid part of a scene is built from.
struct FluidSetup
{
    Dictionary schemes;  ///< system/mpsSchemes.
    Dictionary solution; ///< system/mpsSolution.
    Real density;        ///< [kg/m3].
    Real nu;             ///< [m2/s].
    Vector gravity;      ///< [m/s2].
    Real largestDt;      ///< [s].
};

/// Fluid, boundaries and pressure: the stages of a step that a scene with fluid has.
class FluidStage
{
public:
    FluidStage(ParticleSet& particles, std::vector<Surface> const& walls, FluidSetup const& setup, Ledger& ledger);
    ~FluidStage();

    /// Body particles have moved: periodic images, order in space, neighbours at r^n, number density.
    void updateNeighbours(Step const& step);
    /// Free surface, then DBL.
    void label();
    /// u* of the fluid. @pre uStar of moving boundary particles is set.
    void predict(Step const& step);
    /// Eq 8.
    SolveReport solvePressure(Step const& step);
    /// Clamped pressure, pressure of the boundary, eq 4, motion, collision, shifting.
    void correct(Step const& step);

    [[nodiscard]] ParticleSet& particles() { return particles_; }
    [[nodiscard]] NeighbourList const& neighbours() const { return neighbours_; }
    [[nodiscard]] PressureEquation& pressure() { return *pressure_; }
    [[nodiscard]] Fluid const& fluid() const { return fluid_; }
    [[nodiscard]] Fluid& fluid() { return fluid_; }
    [[nodiscard]] BoundaryLabeller const& labeller() const { return *labeller_; }
    [[nodiscard]] PressureSource const& source() const { return pressure_->source(); }
    [[nodiscard]] bool givesSurfacePressure() const { return pressure_->givesSurfacePressure(); }
    [[nodiscard]] bool positivePressure() const { return fluid_.negativePressure() == NegativePressure::Clamp; }

    /// An initial state made without the periodic box has boundary particles where images of others will stand. @throw CaseError BadInput
    void requireWallsInside(Location const& where) const;
    /// Whether a direction is periodic (`cyclic` of system/mpsSchemes).
    [[nodiscard]] bool periodic() const { return images_.any(); }

    /// Warns of particles that have left the domain since they were last looked for. @param time [s].
    /// @throw CaseError Solver  where they are too many.
    void checkOutside(Real time) const;
    /// Particles taken out because they left the domain or went through a wall, since the start; of all ranks.
    [[nodiscard]] std::int64_t escaped() const;

    /// Times that a particle was put back from behind a wall since the start of the program, of all ranks (3-D).
    [[nodiscard]] std::int64_t putBack() const;

    /// Called where a state is written: forgets what a restarted run would not have.
    void forget() { pressure_->forget(); }
    void save(State& state) const;
    void load(State const& state);

    /// Steps between two sortings of the fluid in space.
    static constexpr int sortInterval = 50;

private:
    void findFloor(std::vector<Surface> const& walls);
    void guardWalls();
    void sortAndCheck(Step const& step);
    void requireFewLost(std::int64_t lost) const;
    [[nodiscard]] bool hasEscaped(int i) const;
    /// @throw CaseError NotFinite, naming the first particle of the range whose position, velocity or pressure is no number.
    void checkFinite(Range const& range, Step const& step) const;

    ParticleSet& particles_;
    std::vector<Polyline> walls_;        ///< 2-D
    std::optional<WallGuard> wallGuard_; ///< 3-D
    Real* takenByWalls_ = nullptr;       ///< Entry of the ledger [J].
    Vector* givenByWalls_ = nullptr;     ///< The same [N s].
    Vector gravity_;
    Radii radii_;
    std::unique_ptr<BoundaryLabeller> labeller_;
    NeighbourList neighbours_;
    PeriodicImages images_;
    Fluid fluid_;
    std::unique_ptr<PressureEquation> pressure_;
    Vector low_, high_;                                   ///< Box beyond which a particle is lost [m].
    Vector up_ = Vector::Zero();                          ///< Against gravity; zero without a floor.
    Real floor_ = -std::numeric_limits<Real>::infinity(); ///< Height of the lowest wall less a spacing: what is lower has left [m].
    Field<int> order_;                                    ///< Scratch of sortAndCheck().
    std::int64_t escaped_ = 0;                            ///< Of this rank.
    std::int64_t initialFluid_ = 0;                       ///< Of all ranks.
    int neighbourTimer_, densityTimer_, labelTimer_, predictTimer_, assembleTimer_, solveTimer_, boundaryTimer_, gradientTimer_,
        collisionTimer_, shiftTimer_;
};

} // namespace mpsDem
