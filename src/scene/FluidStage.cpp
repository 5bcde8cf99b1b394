#include "scene/FluidStage.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "boundaries/BoundaryPressure.h"
#include "core/Log.h"
#include "core/Timers.h"
#include "parallel/Reduce.h"
#include "scene/CaseConstants.h"

namespace mpsDem {

namespace {

/// Share of the fluid, and number of particles where that is more, that may be lost before the run is stopped.
constexpr Real largestLoss = 1e-3;
constexpr Real fewestLost = 2;

} // namespace

FluidStage::FluidStage(ParticleSet& particles, std::vector<Surface> const& walls, FluidSetup const& setup, Ledger& ledger)
    : particles_(particles),
      walls_(linesOf(walls)),
      gravity_(setup.gravity),
      radii_(readRadii(setup.schemes, particles.lattice().spacing)),
      labeller_(BoundaryLabeller::read(setup.schemes.subDictOrEmpty("boundarySchemes"), particles.lattice())),
      neighbours_(radii_, labeller_->needsAllWalls()),
      images_(readPeriodicBox(setup.schemes)),
      fluid_(setup.schemes, readSchemeSet(setup.schemes), particles.lattice(), radii_, setup.density, setup.nu, setup.gravity,
             setup.largestDt, ledger)
{
    PressureSource const source(setup.schemes.subDictOrEmpty("sourceSchemes"), readSchemeSet(setup.schemes), particles.lattice(),
                                radii_.gradient, setup.density);
    pressure_ =
        std::make_unique<PressureEquation>(setup.solution.subDictOrEmpty("solvers").subDictOrEmpty("p"), source,
                                           SurfacePressure::read(setup.schemes.subDictOrEmpty("freeSurfaceSchemes"),
                                                                 setup.schemes.subDictOrEmpty("gradSchemes"), readSchemeSet(setup.schemes)),
                                           particles.lattice(), setup.density, fluid_.gradientConstants(), fluid_.laplacianConstants());
    if (std::vector<TriSurface> const triangles = trianglesOf(walls); !triangles.empty())
    {
        wallGuard_.emplace(triangles, particles.lattice().spacing);
        takenByWalls_ = &ledger.energy("energy/walls");
        givenByWalls_ = &ledger.impulse("impulse/collisionWithWalls");
    }
    Real const infinity = std::numeric_limits<Real>::infinity();
    low_ = Vector::Constant(infinity);
    high_ = Vector::Constant(-infinity);
    for (Vector const& r : particles.r)
    {
        low_ = low_.cwiseMin(r);
        high_ = high_.cwiseMax(r);
    }
    low_ = minOverRanks(low_);
    high_ = maxOverRanks(high_);
    Real const margin = (high_ - low_).norm();
    low_ -= Vector::Constant(margin);
    high_ += Vector::Constant(margin);
    findFloor(walls);
    initialFluid_ = sumOverRanks(static_cast<std::int64_t>(particles.fluid().size()));
    neighbourTimer_ = Timers::add("neighbours", "fluid");
    densityTimer_ = Timers::add("number density", "fluid");
    labelTimer_ = Timers::add("free surface and DBL", "fluid");
    predictTimer_ = Timers::add("predictor", fluid_.viscosity() ? "viscosity" : "fluid");
    assembleTimer_ = Timers::add("pressure: assembly", "pressure");
    solveTimer_ = Timers::add("pressure: solve", "pressure");
    boundaryTimer_ = Timers::add("boundary pressure", "pressure");
    gradientTimer_ = Timers::add("gradient and motion", "fluid");
    collisionTimer_ = fluid_.collision() ? Timers::add("collision", "collision") : -1;
    shiftTimer_ = fluid_.shifting() ? Timers::add("shifting", "shifting") : -1;
}

FluidStage::~FluidStage() = default;

void FluidStage::findFloor(std::vector<Surface> const& walls)
{
    Real const g = gravity_.norm();
    if (!(g > 0)) return;
    Vector const up = -gravity_ / g;
    // Where the box is periodic along gravity, what falls comes back from above.
    if (!images_.contains(0.5 * (low_ + high_) - 1e6 * (high_ - low_).norm() * up)) return;
    Real lowest = std::numeric_limits<Real>::infinity();
    for (Surface const& wall : walls)
        for (Vector const& point : wall.points()) lowest = std::min(lowest, point.dot(up));
    if (!std::isfinite(lowest)) return;
    up_ = up;
    floor_ = lowest - particles_.lattice().spacing;
}

void FluidStage::requireWallsInside(Location const& where) const
{
    for (int i : particles_.boundary())
        require(images_.contains(particles_.r[i]), where, "the initial state has boundary particles outside of the periodic box",
                "run setParticles with this box");
}

void FluidStage::updateNeighbours(Step const& step)
{
    Timers::Scope const timer(Timers::stage(neighbourTimer_));
    checkFinite(particles_.owned(), step); // a grid cannot be built of what is no number
    images_.wrap(particles_);
    if (step.number % sortInterval == 1) sortAndCheck(step);
    images_.rebuild(particles_, radii_.largest());
    neighbours_.update(particles_);
}

void FluidStage::label()
{
    {
        Timers::Scope const timer(Timers::stage(densityTimer_));
        numberDensity(particles_, neighbours_, fluid_.gradientConstants());
    }
    Timers::Scope const timer(Timers::stage(labelTimer_));
    images_.update(particles_.n, particles_.halo());
    images_.update(particles_.F, particles_.halo());
    fluid_.freeSurface().mark(particles_, neighbours_, fluid_.gradientConstants());
    images_.update(particles_.surface, particles_.halo());
    markNearSurface(particles_, neighbours_);
    images_.update(particles_.surface, particles_.halo());
    labeller_->label(particles_, neighbours_, fluid_.gradientConstants());
    images_.update(particles_.wet, particles_.halo());
    images_.update(particles_.surface, particles_.halo()); // a wall that only the surface wets carries its pressure
}

void FluidStage::predict(Step const& step)
{
    Timers::Scope const timer(Timers::stage(predictTimer_));
    fluid_.predict(particles_, neighbours_, images_, step.dt);
    images_.update(particles_.uStar, particles_.halo());
}

SolveReport FluidStage::solvePressure(Step const& step)
{
    {
        Timers::Scope const timer(Timers::stage(assembleTimer_));
        pressure_->assemble(particles_, neighbours_, images_);
    }
    Timers::Scope const timer(Timers::stage(solveTimer_));
    return pressure_->solve(particles_, neighbours_, step);
}

void FluidStage::correct(Step const& step)
{
    {
        Timers::Scope const timer(Timers::stage(boundaryTimer_));
        fluid_.clampPressure(particles_, neighbours_);
        extrapolateBoundaryPressure(particles_, neighbours_, gravity_, fluid_.density(), positivePressure());
        images_.update(particles_.p, particles_.halo());
        images_.update(particles_.mirror, particles_.halo());
    }
    {
        Timers::Scope const timer(Timers::stage(gradientTimer_));
        fluid_.correct(particles_, neighbours_, step.dt);
        checkFinite(particles_.fluid(), step);
    }
    if (collisionTimer_ >= 0)
    {
        Timers::Scope const timer(Timers::stage(collisionTimer_));
        images_.update(particles_.u, particles_.halo());
        fluid_.collide(particles_, neighbours_, images_, step.dt);
    }
    if (shiftTimer_ >= 0)
    {
        Timers::Scope const timer(Timers::stage(shiftTimer_));
        images_.update(fluid_.shifting()->propose(particles_, neighbours_, step.dt), particles_.halo());
        fluid_.shifting()->apply(particles_, neighbours_);
    }
    guardWalls();
    particles_.dropHalo();
}

void FluidStage::guardWalls()
{
    if (!wallGuard_) return;
    Timers::Scope const timer(Timers::stage(boundaryTimer_));
    Real const mass = fluid_.density() * particles_.lattice().particleVolume();
    WallGuard::Exchange const exchange = wallGuard_->apply(particles_, neighbours_);
    *takenByWalls_ += mass * sumOverRanks(exchange.energyTaken);
    *givenByWalls_ += mass * sumOverRanks(exchange.impulseGiven);
}

void FluidStage::checkFinite(Range const& range, Step const& step) const
{
    Real const sum = sumOver(
        range, Real(0), [&](int i) { return particles_.r[i].squaredNorm() + particles_.u[i].squaredNorm() + std::abs(particles_.p[i]); });
    if (std::isfinite(sum)) return;
    char const* const help = "the last checkpoint is whole; a smaller maxCo or maxDeltaT may help";
    for (int i : range)
    {
        if (particles_.r[i].allFinite() && particles_.u[i].allFinite() && std::isfinite(particles_.p[i])) continue;
        std::ostringstream text;
        text << "time " << step.time << " s, step " << step.number << ": position, velocity or pressure of particle " << particles_.id[i]
             << " is not a finite number: r = (" << particles_.r[i].transpose() << ") m, u = (" << particles_.u[i].transpose()
             << ") m/s, p = " << particles_.p[i] << " Pa";
        throw CaseError(ExitCode::NotFinite, text.str(), help);
    }
    throw CaseError(ExitCode::NotFinite, "time " + shortNumber(step.time) + " s: velocities are too large to be summed", help);
}

std::int64_t FluidStage::escaped() const { return sumOverRanks(escaped_); }

std::int64_t FluidStage::putBack() const { return sumOverRanks(wallGuard_ ? wallGuard_->putBack() : 0); }

bool FluidStage::hasEscaped(int i) const
{
    Vector const& r = particles_.r[i];
    if ((r.array() < low_.array()).any() || (r.array() > high_.array()).any() || r.dot(up_) < floor_) return true;
    for (Polyline const& wall : walls_)
    {
        Polyline::Closest const nearest = wall.closest(r);
        if (nearest.distance < -particles_.lattice().spacing && !nearest.atVertex) return true;
    }
    if (!wallGuard_) return false;
    TriangleTree::Nearest const nearest = wallGuard_->nearest(r);
    return nearest.distance < -particles_.lattice().spacing && !nearest.atRim;
}

void FluidStage::sortAndCheck(Step const& step)
{
    particles_.dropHalo();
    int const first = particles_.fluid().first;
    std::span<Vector const> const fluid(particles_.r.data() + first, static_cast<std::size_t>(particles_.fluid().size()));
    order_.clear();
    order_.reserve(fluid.size());
    for (int const k : neighbours_.orderByCells(fluid, particles_.lattice().dimensions))
    {
        if (!hasEscaped(first + k))
        {
            order_.push_back(first + k);
            continue;
        }
        ++escaped_;
        std::ostringstream text;
        text << "time " << step.begin() << " s: particle " << particles_.id[first + k] << " left the domain at ("
             << particles_.r[first + k].transpose() << ") and is taken out; " << escaped_ << " so far";
        warn(text.str(), "escaped", 10);
    }
    particles_.reorderFluid(order_);
    requireFewLost(escaped());
}

void FluidStage::checkOutside(Real time) const
{
    std::int64_t const outside = countOver(particles_.fluid(), [&](int i) { return hasEscaped(i); });
    if (outside == 0) return;
    warn("time " + shortNumber(time) + " s: " + std::to_string(outside) + " particles are outside of the domain", "outside", 10);
    requireFewLost(escaped() + outside);
}

void FluidStage::requireFewLost(std::int64_t lost) const
{
    Real const allowed = std::max(fewestLost, std::floor(largestLoss * static_cast<Real>(initialFluid_)));
    if (static_cast<Real>(lost) <= allowed) return;
    throw CaseError(ExitCode::Solver, std::to_string(lost) + " of " + std::to_string(initialFluid_) + " fluid particles were lost",
                    "a wall has a gap, or the run is unstable (a smaller maxCo or deltaT may help); allowed are " + shortNumber(allowed) +
                        ", a thousandth or two");
}

void FluidStage::save(State& state) const
{
    state.set("fluid/escaped", escaped_);
    state.set("fluid/initial", initialFluid_);
    state.set("fluid/low", low_);
    state.set("fluid/high", high_);
}

void FluidStage::load(State const& state)
{
    if (!state.has("fluid/escaped")) return; // the initial state
    escaped_ = state.integer("fluid/escaped");
    initialFluid_ = state.integer("fluid/initial");
    low_ = state.vector("fluid/low");
    high_ = state.vector("fluid/high");
}

} // namespace mpsDem
