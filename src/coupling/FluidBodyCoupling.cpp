#include "coupling/FluidBodyCoupling.h"

#include <algorithm>
#include <sstream>

#include <Eigen/Eigenvalues>

#include "core/Log.h"

namespace mpsDem {

namespace {

/// Largest ratio of added mass to mass at which weak coupling is silent, and at which it is allowed.
constexpr Real quietRatio = 0.5;
constexpr Real largestRatio = 0.8;
/// Steps between two looks at the added mass of a weakly coupled body: it grows where a body comes near a wall, too.
constexpr std::int64_t checkInterval = 50;
/// Warnings of added mass, over all bodies.
constexpr int mostWarnings = 10;

void readContactFace(Dictionary const& dict, Lattice const& lattice, PressureIntegrationControls& controls)
{
    using Face = PressureIntegrationControls::ContactFace;
    std::string const face = dict.getWordOr("contactFace", "dry", {"dry", "pore", "vented"}, "contact faces");
    controls.contactFace = face == "pore" ? Face::Pore : face == "vented" ? Face::Vented : Face::Dry;
    controls.faceReach = dict.getInRangeOr("faceReach", face == "pore" ? 2.1 : 1.5, 0.5, 20) * lattice.spacing;
}

} // namespace

FluidBodyCoupling::Controls FluidBodyCoupling::readControls(Dictionary const& dict, Lattice const& lattice, bool positiveOnly)
{
    std::string const type = dict.getWordOr("type", "auto", {"weak", "strong", "lagged", "auto"}, "couplings");
    Controls controls;
    controls.where = dict.where("type");
    controls.mode = type == "strong" ? Mode::Strong : type == "lagged" ? Mode::Lagged : Mode::Weak;
    controls.automatic = type == "auto";
    controls.addedMassInterval = static_cast<int>(dict.getInRangeOr("addedMassInterval", 10, 1, 1000));
    controls.integration.wetRadius = 1.5 * lattice.spacing;
    controls.integration.radius = 2.1 * lattice.spacing;
    controls.integration.positiveOnly = positiveOnly;
    readContactFace(dict, lattice, controls.integration);
    return controls;
}

FluidBodyCoupling::FluidBodyCoupling(RigidBody& body, int number, Surface const& outline, ParticleSet const& particles,
                                     Controls const& controls, Vector const& gravity, Real density)
    : body_(body),
      controls_(controls),
      mode_(controls.mode),
      gravity_(gravity),
      density_(density),
      surface_(outline, particles.lattice(), number)
{
    Tensor const toBody = body.rotation().transpose();
    for (int i : particles.boundary())
    {
        if (particles.body[i] != number) continue;
        particle_.push_back(i);
        local_.push_back(toBody * (particles.r[i] - body.centre()));
        localNormal_.push_back(toBody * particles.normal[i]);
    }
    for (int k : {0, 1, 2, 3, 4, 5})
        if (body.freeProjection().col(k).norm() > 0) direction_.push_back(k);
    response_.resize(direction_.size());
}

char const* FluidBodyCoupling::modeName() const
{
    if (mode_ == Mode::Strong) return "strong";
    if (mode_ == Mode::Lagged) return "lagged";
    return controls_.automatic && checkedWet_ == 0 && !direction_.empty() ? "auto: by the added mass, not known yet" : "weak";
}

void FluidBodyCoupling::moveParticles(ParticleSet& particles)
{
    for (std::size_t k = 0; k < particle_.size(); ++k)
    {
        int const i = particle_[k];
        particles.r[i] = body_.toSpace(local_[k]);
        particles.u[i] = body_.velocityAt(particles.r[i]);
        particles.normal[i] = body_.rotation() * localNormal_[k];
        particles.wallAcceleration[i] = body_.accelerationAt(particles.r[i]);
    }
    surface_.place(body_.rotation(), body_.centre());
}

Vector6 FluidBodyCoupling::assumedAcceleration() const
{
    Vector6 a = Vector6::Zero();
    if (mode_ == Mode::Weak) return a;
    a << body_.acceleration(), body_.angularAcceleration();
    return a;
}

void FluidBodyCoupling::predictParticles(ParticleSet& particles, Real dt) const
{
    Vector6 const a = assumedAcceleration();
    for (int const i : particle_)
    {
        Vector const arm = particles.r[i] - body_.centre();
        particles.uStar[i] = particles.u[i] + dt * (a.head<3>() + Vector(a.tail<3>()).cross(arm));
    }
}

void FluidBodyCoupling::findAddedMass(ParticleSet const& particles, NeighbourList const& neighbours, PressureResponse const& response)
{
    PressureIntegrationControls linear = controls_.integration;
    linear.positiveOnly = false;
    addedMass_.setZero();
    unitAcceleration_.assign(particles.wallAcceleration.size(), Vector::Zero());
    for (std::size_t k = 0; k < direction_.size(); ++k)
    {
        Vector6 const unit = Vector6::Unit(direction_[k]);
        auto const accelerationAt = [&](Vector const& r) -> Vector {
            return unit.head<3>() + Vector(unit.tail<3>()).cross(r - body_.centre());
        };
        for (int const i : particle_) unitAcceleration_[i] = accelerationAt(particles.r[i]);
        response(unitAcceleration_, response_[k]);
        surface_.interpolate(particles, neighbours.grid(), response_[k], Vector::Zero(), density_, accelerationAt, linear);
        Load const load = surface_.integrate(body_.centre());
        addedMass_.col(direction_[k]) << -load.force, -load.moment;
    }
}

Real FluidBodyCoupling::addedMassRatio() const
{
    Matrix6 const projection = body_.freeProjection();
    Matrix6 const added = projection * (addedMass_ + addedMass_.transpose()) * projection / 2;
    return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6>(added, body_.massMatrix(), Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

Load FluidBodyCoupling::integrate(ParticleSet const& particles, NeighbourList const& neighbours)
{
    surface_.interpolate(
        particles, neighbours.grid(), particles.p, gravity_, density_, [&](Vector const& r) { return body_.accelerationAt(r); },
        controls_.integration);
    return surface_.integrate(body_.centre());
}

bool FluidBodyCoupling::weakIsToBeChecked(Step const& step)
{
    auto const wet = std::count(surface_.wet().begin(), surface_.wet().end(), 1);
    if (wet == 0 || direction_.empty() || body_.locked()) return false;
    return wet > 2 * checkedWet_ || step.number % checkInterval == 0;
}

void FluidBodyCoupling::decide(Real ratio, std::string const& text)
{
    if (ratio > quietRatio)
    {
        mode_ = Mode::Strong;
        info() << text << "so type auto is strong from now on" << std::endl;
    }
    else if (checkedWet_ == 0)
        info() << text << "so type auto is weak, up to a ratio of " << quietRatio << std::endl;
}

void FluidBodyCoupling::checkWeak(Step const& step)
{
    Real const ratio = addedMassRatio();
    std::ostringstream text;
    text << "coupling of body \"" << body_.name() << "\": the added mass is " << ratio << " of its mass (time " << step.begin() << " s), ";
    if (controls_.automatic)
        decide(ratio, text.str());
    else if (ratio > largestRatio && step.number == 1)
    {
        text << "and weak coupling is unstable from 1 at any time step";
        throw CaseError(ExitCode::BadInput, controls_.where, text.str(), "type strong or auto; weak up to a ratio of 0.8");
    }
    Real const limit = ratio > largestRatio ? largestRatio : ratio > quietRatio ? quietRatio : 0;
    if (mode_ == Mode::Weak && limit > warnedOf_)
    {
        text << "and weak coupling is unstable from 1 at any time step; type strong or auto is safe";
        warn(text.str(), "added mass of weakly coupled bodies", mostWarnings);
        warnedOf_ = limit;
    }
    checkedWet_ = std::count(surface_.wet().begin(), surface_.wet().end(), 1);
}

void FluidBodyCoupling::load(ParticleSet const& particles, NeighbourList const& neighbours, Step const& step,
                             PressureResponse const& response)
{
    assumed_ = assumedAcceleration();
    bool renew =
        mode_ == Mode::Strong || (mode_ == Mode::Lagged && step.number % controls_.addedMassInterval == 1 % controls_.addedMassInterval);
    if (mode_ == Mode::Weak)
    {
        body_.setAddedMass(Matrix6::Zero(), Vector6::Zero());
        body_.fluid = integrate(particles, neighbours);
        if (!weakIsToBeChecked(step)) return;
        findAddedMass(particles, neighbours, response);
        checkWeak(step);
        renew = false; // found just now where the mode has become strong
    }
    if (mode_ != Mode::Weak && !body_.still(step.begin()))
    {
        if (renew || addedMass_.isZero()) findAddedMass(particles, neighbours, response);
        body_.setAddedMass(addedMass_, assumed_);
    }
    else
        body_.setAddedMass(Matrix6::Zero(), Vector6::Zero());
    body_.fluid = integrate(particles, neighbours);
}

void FluidBodyCoupling::correct(ParticleSet& particles)
{
    if (mode_ != Mode::Strong || response_.empty() || response_.front().size() != particles.p.size()) return;
    Vector6 difference;
    difference << body_.acceleration(), body_.angularAcceleration();
    difference -= assumed_;
    for (std::size_t k = 0; k < direction_.size(); ++k)
        for (int i : particles.owned()) particles.p[i] += difference[direction_[k]] * response_[k][i];
    Vector6 const load = addedMass_ * difference;
    body_.fluid.force -= load.head<3>();
    body_.fluid.moment -= load.tail<3>();
}

void FluidBodyCoupling::save(State& state) const
{
    std::string const prefix = "coupling/" + body_.name() + "/";
    state.set(prefix + "local", std::span<Vector const>(local_));
    state.set(prefix + "localNormal", std::span<Vector const>(localNormal_));
    state.set(prefix + "addedMass", std::span<Real const>(addedMass_.data(), 36));
    state.set(prefix + "checkedWet", checkedWet_);
    state.set(prefix + "strong", std::int64_t(mode_ == Mode::Strong));
}

void FluidBodyCoupling::load(State const& state)
{
    std::string const prefix = "coupling/" + body_.name() + "/";
    local_ = state.vectors(prefix + "local");
    localNormal_ = state.vectors(prefix + "localNormal");
    addedMass_ = Eigen::Map<Matrix6 const>(state.reals(prefix + "addedMass").data());
    checkedWet_ = state.integer(prefix + "checkedWet");
    if (controls_.automatic && state.integer(prefix + "strong") != 0) mode_ = Mode::Strong;
}

} // namespace mpsDem
