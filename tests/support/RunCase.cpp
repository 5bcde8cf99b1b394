#include "support/RunCase.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "core/Log.h"
#include "particles/Kernel.h"
#include "scene/InitialFiles.h"
#include "scene/InitialState.h"

namespace mpsDem::test {

namespace {

constexpr Real g = 9.81;

std::string text(Real value)
{
    std::ostringstream out;
    out.precision(17);
    out << value;
    return out.str();
}

std::string controlText(Real endTime, Real dt, std::string const& extra)
{
    return "endTime " + text(endTime) + "; deltaT " + text(dt) + "; writeControl none; checkpointInterval 0; " + extra;
}

} // namespace

RunCase::RunCase(Real spacing) : spacing_(spacing)
{
    muteLog(true);
    gravity(Vector(0, -g, 0));
    write("constant/particleProperties", "spacing " + text(spacing) + "; thickness 1;");
    write("constant/transportProperties", "nu 0; rho 1000;");
}

RunCase::~RunCase() { muteLog(false); }

RunCase& RunCase::write(std::string const& file, std::string const& content, std::string const& headerClass)
{
    std::filesystem::create_directories((root() / file).parent_path());
    std::ofstream out(root() / file);
    out << "FoamFile { version 2.0; format ascii; class " << headerClass << "; object o; }\n" << content << '\n';
    return *this;
}

RunCase& RunCase::threeDimensions() { return write("constant/particleProperties", "dimensions 3; spacing " + text(spacing_) + ";"); }

RunCase& RunCase::gravity(Vector const& value)
{
    return write("constant/g", "value (" + text(value.x()) + " " + text(value.y()) + " 0);", "uniformDimensionedVectorField");
}

RunCase& RunCase::control(Real endTime, Real dt, std::string const& extra)
{
    return write("system/controlDict", controlText(endTime, dt, "maxDeltaT " + text(dt) + "; " + extra));
}

RunCase& RunCase::fixedSteps(Real endTime, Real dt, std::string const& extra)
{
    return write("system/controlDict", controlText(endTime, dt, "adjustTimeStep no; " + extra));
}

RunCase& RunCase::make(std::function<void(ParticleSet&)> const& change)
{
    CaseFolder const folder(root());
    SceneDefinition const definition = readSceneDefinition(folder, "system/setParticlesDict");
    InitialScene scene = makeInitialScene(definition);
    if (change) change(scene.particles);
    writeInitialFiles(folder, definition, scene, "", inputFingerprint(folder, "system/setParticlesDict"));
    return *this;
}

RunCase& RunCase::copyFrom(RunCase const& other)
{
    std::filesystem::copy(other.root(), root(),
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    return *this;
}

Scene& RunCase::start()
{
    if (!scene_) scene_ = std::make_unique<Scene>(CaseFolder(root()), Scene::Options{});
    return *scene_;
}

void RunCase::stages(Step const& step)
{
    scene_->moveBoundaries();
    scene_->updateNeighbours(step);
    scene_->label();
    scene_->predict(step);
    scene_->solvePressure(step);
    scene_->loadBodies(step);
    scene_->advanceBodies(step);
    scene_->correctFluid(step);
}

Step RunCase::step()
{
    Step const now = scene_->takeStep([this](Step const& step) { stages(step); });
    scene_->observe(now);
    scene_->writeIfDue(now);
    return now;
}

void RunCase::run(EachStep const& eachStep)
{
    start();
    while (scene_->time().running())
    {
        Step const now = step();
        if (eachStep) eachStep(*scene_, now);
    }
}

void Series::add(Real value)
{
    ++count_;
    sum_ += value;
    squares_ += value * value;
    least_ = std::min(least_, value);
    largest_ = std::max(largest_, value);
}

Real Series::deviation() const
{
    return count_ > 0 ? std::sqrt(std::max(Real(0), squares_ / static_cast<Real>(count_) - mean() * mean())) : 0;
}

Real StillWater::exact(Vector const& r) const { return density_ * g * std::max(Real(0), depth_ - r.y()); }

void StillWater::observe(Scene const& scene, Step const& step)
{
    if (step.time <= from_) return;
    ParticleSet const& particles = scene.particles();
    density_ = scene.fluid()->fluid().density();
    Real const scale = density_ * g * depth_;
    Kernel const w{2.1 * particles.lattice().spacing};
    Real inFluid = 0, inWall = 0, weight = 0, weighted = 0;
    int wet = 0;
    for (int const i : particles.fluid())
    {
        Real const error = particles.p[i] - exact(particles.r[i]);
        inFluid += error * error;
        Real const weightOf = w((particles.r[i] - sensorAt_).norm());
        weight += weightOf;
        weighted += weightOf * particles.p[i];
    }
    for (int const i : particles.wall())
    {
        if (!particles.wet[i]) continue;
        Real const error = particles.p[i] - exact(particles.r[i]);
        inWall += error * error;
        ++wet;
    }
    fluid.add(std::sqrt(inFluid / particles.fluid().size()) / scale);
    wall.add(std::sqrt(inWall / std::max(1, wet)) / scale);
    sensor.add(weighted / weight);
    kineticEnergy.add(test::kineticEnergy(scene) / particles.lattice().thickness);
}

Real StillWater::sensorBias() const { return sensor.mean() / exact(sensorAt_) - 1; }

Real StillWater::sensorNoise() const { return sensor.deviation() / exact(sensorAt_); }

Real kineticEnergy(Scene const& scene)
{
    ParticleSet const& particles = scene.particles();
    Real sum = 0;
    for (int const i : particles.fluid()) sum += particles.u[i].squaredNorm();
    return 0.5 * sum * scene.fluid()->fluid().density() * particles.lattice().particleVolume();
}

Real potentialEnergy(Scene const& scene)
{
    ParticleSet const& particles = scene.particles();
    Real sum = 0;
    for (int const i : particles.fluid()) sum += particles.r[i].y();
    return g * sum * scene.fluid()->fluid().density() * particles.lattice().particleVolume();
}

void Watch::observe(Scene const& scene, Step const& step)
{
    Real energy = kineticEnergy(scene) + potentialEnergy(scene);
    for (auto const& body : scene.bodies()) energy += body->kineticEnergy() + body->mass() * g * body->centre().y();
    ContactModel const* const contacts = scene.solids() ? scene.solids()->contacts() : nullptr;
    if (contacts)
    {
        energy += contacts->elasticEnergy();
        Real const overlap = contacts->maxOverlap() / scene.particles().lattice().spacing;
        deepest = std::max(deepest, overlap);
        if (contacts->contactCount() > 0) overlaps_.push_back(overlap);
    }
    if (start == 0) start = energy;
    lowest_ = std::min(lowest_, energy);
    rise = std::max(rise, energy - lowest_);
    if (step.dt < 0.5 * lastDt_ && scene.guard().redone() == redone_) ++cuts;
    redone_ = scene.guard().redone();
    lastDt_ = step.dt;
    ++steps_;
    if (!scene.fluid()) return;
    observeFluid(scene);
    observeMomentum(scene);
}

void Watch::observeFluid(Scene const& scene)
{
    constexpr int window = 25;
    ParticleSet const& particles = scene.particles();
    for (int const i : particles.fluid())
    {
        fastest = std::max(fastest, particles.u[i].norm());
        if (particles.surface[i] == SurfaceLabel::Interior) deviations_.push_back(std::abs(particles.n[i] - 1));
    }
    particleSteps_ += particles.fluid().size();
    limited_ = scene.fluid()->fluid().limited();
    if (steps_ % window != 0) return;
    worstDensity_ = std::max(worstDensity_, percentile(std::move(deviations_), 0.99));
    deviations_.clear();
}

Vector momentumBalance(Scene const& scene)
{
    ParticleSet const& particles = scene.particles();
    Vector sum = Vector::Zero();
    for (int const i : particles.fluid()) sum += particles.u[i];
    sum *= scene.fluid()->fluid().density() * particles.lattice().particleVolume();
    for (auto const& body : scene.bodies()) sum += body->momentum();
    for (auto const& [name, impulse] : scene.ledger().impulses()) sum -= impulse;
    return sum;
}

void Watch::observeMomentum(Scene const& scene)
{
    auto const& impulses = scene.ledger().impulses();
    if (!impulses.contains("impulse/walls")) return;
    ParticleSet const& particles = scene.particles();
    Real const mass = scene.fluid()->fluid().density() * particles.lattice().particleVolume();
    Vector const balance = momentumBalance(scene);
    if (steps_ == 1) balance_ = balance;
    residual = residual.cwiseMax((balance - balance_).cwiseAbs() / (mass * particles.fluid().size() * g));
}

Real Watch::overlap() const { return percentile(overlaps_, 0.99); }

Real Watch::limited() const { return particleSteps_ > 0 ? static_cast<Real>(limited_) / static_cast<Real>(particleSteps_) : 0; }

Real percentile(std::vector<Real> samples, Real q)
{
    if (samples.empty()) return 0;
    auto const nth = samples.begin() + static_cast<std::ptrdiff_t>(q * static_cast<Real>(samples.size() - 1));
    std::nth_element(samples.begin(), nth, samples.end());
    return *nth;
}

void expectInBand(std::string const& name, RunCase const& run, Watch const& watch, Band const& band, Place const& place)
{
    expectBelow(name + ": rise of energy above its lowest, of that at the start", watch.rise / watch.start, band.energy, place);
    expectBelow(name + ": largest speed over sqrt(2 g H)", watch.fastest / std::sqrt(2 * g * band.height), 3, place);
    expectBelow(name + ": density deviation, p99", watch.densityDeviation(), band.density, place);
    if (run.scene().solids()) expectBelow(name + ": overlap, p99 [spacings]", watch.overlap(), band.overlap, place);
    expectBelow(name + ": steps cut to less than half", watch.cuts, 0, place);
    expectBelow(name + ": steps taken again, share", watch.redone(), band.redone, place);
    expectBelow(name + ": limited displacements, share", watch.limited(), band.limited, place);
    expectBelow(name + ": particles lost", static_cast<Real>(run.scene().fluid()->escaped()), 0, place);
    expectMomentum(name, watch, band.momentum, place);
}

void Jump::add(Vector const& value)
{
    if (begun_)
    {
        squares_ += (value - last_).squaredNorm();
        ++count_;
    }
    begun_ = true;
    last_ = value;
}

Real Jump::value() const { return count_ > 0 ? std::sqrt(squares_ / static_cast<Real>(count_)) : 0; }

void expectMomentum(std::string const& name, Watch const& watch, Real bound, Place const& place)
{
    EXPECT_GT(watch.residual.norm(), 0) << "no momentumBudget in controlDict";
    expectBelow(name + ": momentum residual over weight x 1 s", watch.residual.norm(), bound, place);
}

} // namespace mpsDem::test
