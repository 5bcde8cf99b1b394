#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/Scene.h"
#include "support/Measured.h"
#include "support/TemporaryFolder.h"

namespace mpsDem::test {

/// A case written from strings into a temporary folder, made by setParticles' library and run within the test by mpsDemFoam's loop.
///
/// A new one has gravity (0 -9.81 0), water of 1000 kg/m3 without viscosity, a thickness of 1 m and the standard schemes; spacing,
/// setParticlesDict and control() are for the test to give. The log is muted.
class RunCase
{
public:
    explicit RunCase(Real spacing);
    ~RunCase();

    /// Writes a dictionary, header included; replaces one of the same name.
    RunCase& write(std::string const& file, std::string const& content, std::string const& headerClass = "dictionary");
    RunCase& gravity(Vector const& g);
    /// Makes the case one in 3-D: constant/particleProperties without a thickness.
    RunCase& threeDimensions();
    /// system/controlDict without output: steps of at most dt [s], shorter where the default limits ask for it; `extra` is appended.
    RunCase& control(Real endTime, Real dt, std::string const& extra = "");
    /// The same with every step of length dt.
    RunCase& fixedSteps(Real endTime, Real dt, std::string const& extra = "");

    /// setParticles. @param change  May alter positions, velocities and pressures of the fluid before they are saved.
    RunCase& make(std::function<void(ParticleSet&)> const& change = {});
    /// Takes over dictionaries, initial state and checkpoints of another case.
    RunCase& copyFrom(RunCase const& other);

    using EachStep = std::function<void(Scene const&, Step const&)>;
    /// mpsDemFoam, to the end. @param eachStep  Called after each step.
    void run(EachStep const& eachStep = {});
    /// Reads the case as mpsDemFoam does, and takes no step. Called by run() where needed.
    Scene& start();
    /// One step of a started run.
    Step step();
    /// One try of a step: all stages.
    void stages(Step const& step);

    [[nodiscard]] Scene const& scene() const { return *scene_; }
    [[nodiscard]] ParticleSet const& particles() const { return scene_->particles(); }
    [[nodiscard]] RigidBody const& body(std::size_t k = 0) const { return *scene_->bodies().at(k); }
    [[nodiscard]] std::filesystem::path const& root() const { return folder_.path(); }

private:
    TemporaryFolder folder_;
    Real spacing_;
    std::unique_ptr<Scene> scene_;
};

/// Mean, standard deviation and extremes of a series.
class Series
{
public:
    void add(Real value);
    [[nodiscard]] Real mean() const { return count_ > 0 ? sum_ / static_cast<Real>(count_) : 0; }
    [[nodiscard]] Real deviation() const;
    [[nodiscard]] Real least() const { return least_; }
    [[nodiscard]] Real largest() const { return largest_; }

private:
    long count_ = 0;
    Real sum_ = 0, squares_ = 0, least_ = 1e300, largest_ = -1e300;
};

/// Errors of the pressure of still water of depth H above y = 0, against rho g (H - y), as parts of rho g H; gathered in time.
///
/// fluid: root mean square over fluid particles; wall: over wet wall particles; sensor: Shepard mean of fluid pressure around a point [Pa];
/// kineticEnergy per metre of width [J/m].
class StillWater
{
public:
    StillWater(Real depth, Vector const& sensorAt, Real from) : depth_(depth), sensorAt_(sensorAt), from_(from) {}

    /// Counts the state after a step that ends after `from`.
    void observe(Scene const& scene, Step const& step);

    Series fluid, wall, sensor, kineticEnergy;

    /// (mean of the sensor - exact) / exact.
    [[nodiscard]] Real sensorBias() const;
    /// Standard deviation of the sensor over its exact value.
    [[nodiscard]] Real sensorNoise() const;

private:
    [[nodiscard]] Real exact(Vector const& r) const;

    Real depth_;
    Vector sensorAt_;
    Real from_;
    Real density_ = 0;
};

/// Kinetic energy of the fluid [J].
Real kineticEnergy(Scene const& scene);
/// Energy of the fluid against gravity (0 -9.81 0), zero at y = 0 [J].
Real potentialEnergy(Scene const& scene);

/// Momentum of water and bodies less the impulses so far: constant where nothing is lost [N s]. Impulses are counted for momentumBudget only.
Vector momentumBalance(Scene const& scene);

/// What must stay in bounds however violent a flow is; each figure over all steps that were observed.
///
/// Energy: kinetic, potential above y = 0, of fluid and bodies, and that in the springs of contacts.
class Watch
{
public:
    void observe(Scene const& scene, Step const& step);

    Real start = 0;   ///< Energy after the first step [J].
    Real fastest = 0; ///< Largest speed of a fluid particle [m/s].
    Real rise = 0;    ///< Largest rise of the energy above its lowest value before [J].
    Real deepest = 0; ///< Largest overlap of a contact at the end of a step [spacings].
    /// Largest |P - J - (P - J at first)| by component, over weight of water x 1 s, as momentumBudget; 0 where the case has none.
    Vector residual = Vector::Zero();
    int cuts = 0; ///< Steps shorter than half of the one before that no redo has cut.

    /// 99th percentile of |n - n0|/n0 of particles inside the fluid, worst of all windows of 25 steps.
    [[nodiscard]] Real densityDeviation() const { return worstDensity_; }
    /// 99th percentile in time of the largest overlap, steps without contact not counted [spacings].
    [[nodiscard]] Real overlap() const;
    /// Share of particle-steps at which the pressure displacement was limited.
    [[nodiscard]] Real limited() const;
    /// Share of steps that were taken again.
    [[nodiscard]] Real redone() const { return steps_ > 0 ? static_cast<Real>(redone_) / steps_ : 0; }

private:
    void observeFluid(Scene const& scene);
    void observeMomentum(Scene const& scene);

    Real lowest_ = 1e300, lastDt_ = 0, worstDensity_ = 0;
    int steps_ = 0;
    std::int64_t particleSteps_ = 0, limited_ = 0, redone_ = 0;
    Vector balance_ = Vector::Zero();
    std::vector<Real> deviations_; ///< Of this window of steps.
    std::vector<Real> overlaps_;
};

/// Value below which a share q of the samples lies; 0 where there is none.
Real percentile(std::vector<Real> samples, Real q);

/// Bounds of a case that must stay in band to its end.
struct Band
{
    Real height;          ///< H of the speed sqrt(2 g H) [m].
    Real energy = 0.005;  ///< Rise of the energy above its lowest value before, as a share of that at the start.
    Real density = 0.3;   ///< 99th percentile of the density deviation: at a deficit of 0.3 a particle is on the surface.
    Real overlap = 0.01;  ///< 99th percentile of the overlap [spacings].
    Real limited = 1e-3;  ///< Share of limited displacements.
    Real redone = 0.01;   ///< Share of steps that were taken again.
    Real momentum = 0.02; ///< Change without an impulse from outside, over the weight of the water during 1 s.
};

/// What momentumBudget needs is kept where this is in controlDict.
inline std::string const budgetEntry = "functions { momentum { type momentumBudget; writeControl none; } }";

/// Expects energy, speed, density, overlap, limited displacements and momentum in the band, no step cut and no particle lost.
/// The case has `budgetEntry` in its controlDict.
void expectInBand(std::string const& name, RunCase const& run, Watch const& watch, Band const& band, Place const& place = Place::current());
/// Expects that momentum of water and bodies changes by the impulses from outside, to this share of the weight of the water in 1 s.
void expectMomentum(std::string const& name, Watch const& watch, Real bound = Band{}.momentum, Place const& place = Place::current());

/// A step-to-step measure of noise: root mean square of the change of a vector.
class Jump
{
public:
    void add(Vector const& value);
    [[nodiscard]] Real value() const;

private:
    bool begun_ = false;
    Vector last_ = Vector::Zero();
    Real squares_ = 0;
    long count_ = 0;
};

} // namespace mpsDem::test
