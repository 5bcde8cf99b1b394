#include "scene/Scene.h"

#include "core/Log.h"
#include "core/Timers.h"
#include "io/Checkpoint.h"
#include "scene/BodyReader.h"
#include "scene/EntryText.h"
#include "scene/InputFingerprint.h"
#include "scene/StartChecks.h"

namespace mpsDem {

namespace {

/// The state that a run starts from: `latestTime` the newest valid checkpoint, else (and for startTime and firstTime) the initial one.
State findStart(CaseFolder const& caseFolder, RunTime const& time, Lattice const& lattice)
{
    if (time.startFrom() == "latestTime")
    {
        if (auto const latest = findLatest(caseFolder.root() / "checkpoint"))
        {
            info() << "Reading state from checkpoint/" << latest->filename().string() << '\n' << std::endl;
            Checkpoint saved = readCheckpoint(*latest);
            logChangedInput(caseFolder, saved.info.inputHash, "");
            return std::move(saved.state);
        }
    }
    std::filesystem::path const folder = caseFolder.root() / timeName(time.startTime());
    if (!std::filesystem::exists(folder / "MANIFEST"))
        throw CaseError(ExitCode::BadInput, Location{timeName(time.startTime()), 0, {}}, "the case has no initial state",
                        "run setParticles first");
    info() << "Reading state from " << folder.filename().string() << "/\n" << std::endl;
    Checkpoint initial = readCheckpoint(folder);
    requireSameWalls(caseFolder, initial.info.inputHash, initial.state, lattice);
    logChangedInput(caseFolder, initial.info.inputHash, "run setParticles again where the particles depend on it");
    return std::move(initial.state);
}

/// True where one of the function objects is of the type.
bool asksFor(Dictionary const& functions, std::string const& type)
{
    for (std::string const& name : functions.dictKeys())
        if (functions.subDict(name).getOr<std::string>("type", "") == type) return true;
    return false;
}

} // namespace

Scene::Scene(CaseFolder const& caseFolder, Options const& options)
    : case_(caseFolder),
      dicts_(caseFolder),
      gravity_(readGravity(caseFolder, dicts_.lattice.dimensions)),
      time_(std::make_unique<RunTime>(dicts_.control)),
      timeStep_(std::make_unique<TimeStep>(dicts_.control, dicts_.lattice)),
      particles_(dicts_.lattice)
{
    State const saved = options.initial ? State() : findStart(case_, *time_, dicts_.lattice);
    State const& start = options.initial ? *options.initial : saved;
    readStart(start);
    checkStart(start);
    if (dicts_.transport) buildFluid();
    if (!bodies_.empty()) buildSolids();
    if (fluid_ && fluid_->periodic()) fluid_->requireWallsInside(dicts_.schemes->where("cyclic"));
    buildGuard();
    output_ = std::make_unique<Output>(case_, particles_, bodies_, outlines_);

    Real const density = fluid_ ? fluid_->fluid().density() : 0;
    context_.reset(new RunContext{particles_, bodies_, surfaceNames_, wallOf_, ledger_, gravity_, density, case_.root(), time_->time()});
    Dictionary const functions = dicts_.control.subDictOrEmpty("functions");
    if (options.functionObjects)
        observers_ = std::make_unique<FunctionObjects>(functions, *context_);
    else
        dicts_.control.ignore("functions");
    observerTimer_ = observers_ && !observers_->empty() ? Timers::add("function objects", "function objects") : -1;
    checkpointTimer_ = Timers::add("checkpoints", "output");
    checkDictionaries();

    if (start.has("time/lastDt"))
    {
        if (fluid_) fluid_->load(start);
        if (solids_) solids_->load(start);
        ledger_.load(start);
        guard_->load(start);
        if (observers_) observers_->load(start);
    }
    output_->startAt(time_->time());
    lastCheckpointClock_ = std::chrono::steady_clock::now();
    listEffects();
}

Scene::~Scene() = default;

void Scene::readStart(State const& start)
{
    requireSameLattice(start, dicts_.lattice);
    time_->load(start);
    startStep_ = time_->stepNumber();
    particles_.load(start);
    surfaces_ = loadSurfaces(start);
    for (Surface const& surface : surfaces_) surfaceNames_.push_back(surface.name());
    wallOf_ = loadWallOf(start, static_cast<std::size_t>(particles_.boundary().size()), surfaces_.size());
    if (dicts_.bodies) bodies_ = readBodies(*dicts_.bodies, start, {dicts_.lattice, case_.root()});
    for (auto const& body : bodies_) SolidStage::requireFinite(*body);
    for (auto const& body : bodies_)
    {
        BodyOutline const outline = loadOutline(start, body->name());
        outlines_.push_back(outline.outline);
        discRadii_.push_back(outline.radius);
    }
}

void Scene::checkStart(State const& start)
{
    auto const pointer = [](std::optional<Dictionary> const& dict) { return dict ? &*dict : nullptr; };
    requireSameScene(pointer(dicts_.transport), pointer(dicts_.bodies), start, {dicts_.lattice, case_.root()});
    requireDeepWalls(pointer(dicts_.schemes), start, dicts_.lattice);
    rowsMadeFor_ = loadKernelRadius(start);
}

void Scene::buildFluid()
{
    require(particles_.fluid().size() > 0, dicts_.transport->where(), "the case has constant/transportProperties but no fluid particles",
            "remove the file where there is no fluid, or run setParticles with a region");
    Dictionary const& transport = *dicts_.transport;
    static_cast<void>(transport.getWordOr("transportModel", "Newtonian", {"Newtonian"}, "transport models"));
    FluidSetup setup;
    setup.schemes = dicts_.schemes.value_or(Dictionary());
    setup.solution = dicts_.solution.value_or(Dictionary());
    setup.density = readFluidDensity(transport);
    setup.nu = transport.found("nu") ? transport.getDimensioned("nu", {0, 2, -1, 0, 0, 0, 0}) : 0;
    require(setup.nu >= 0, transport.where("nu"), "nu is negative", "a viscosity of 0 m2/s or more");
    setup.gravity = gravity_;
    setup.largestDt = timeStep_->largest();
    fluid_ = std::make_unique<FluidStage>(particles_, surfaces_, setup, ledger_);
    if (!asksFor(dicts_.control.subDictOrEmpty("functions"), "momentumBudget")) return;
    for (Surface const& surface : surfaces_) fixedSurfaces_.emplace_back(surface, dicts_.lattice, -1);
    impulseTimer_ = Timers::add("impulse of fixed walls (momentumBudget)", "function objects");
    wallImpulse_ = &ledger_.impulse("impulse/walls");
    gravityImpulse_ = &ledger_.impulse("impulse/gravityOnFluid");
}

std::unique_ptr<ContactModel> Scene::makeContacts(std::vector<RigidBody*> const& bodies) const
{
    Real const spacing = dicts_.lattice.spacing;
    Dictionary const stoppers = dicts_.contact->subDictOrEmpty("stoppers");
    for (std::string const& name : stoppers.dictKeys())
        for (char const* key : {"point", "normal"})
            if (stoppers.subDict(name).found(key)) static_cast<void>(readPoint(stoppers.subDict(name), key, dicts_.lattice.dimensions));
    std::vector<ContactShape> shapes;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        shapes.push_back(discRadii_[k] > 0     ? ContactShape::disc(discRadii_[k])
                         : outlines_[k].flat() ? ContactShape::polygon(outlines_[k].line())
                                               : ContactShape::mesh(outlines_[k].triangles()));
    if (dicts_.lattice.dimensions == 3)
        return std::make_unique<ContactModel>(*dicts_.contact, spacing, trianglesOf(surfaces_), bodies, shapes);
    return std::make_unique<ContactModel>(*dicts_.contact, spacing, dicts_.lattice.thickness, linesOf(surfaces_), bodies, shapes);
}

void Scene::buildSolids()
{
    std::unique_ptr<ContactModel> contacts;
    std::vector<RigidBody*> pointers;
    for (auto const& body : bodies_) pointers.push_back(body.get());
    if (dicts_.contact) contacts = makeContacts(pointers);
    std::vector<FluidBodyCoupling> couplings;
    if (fluid_)
    {
        // Images of a body's particles carry no acceleration, its surface points see no images, and contact knows no period.
        require(!fluid_->periodic(), dicts_.schemes ? dicts_.schemes->where("cyclic") : Location{},
                "periodic borders in a case with fluid and rigid bodies",
                "walls or open water in all directions, or no constant/rigidBodyProperties");
        Dictionary const solution = dicts_.solution.value_or(Dictionary());
        auto const controls =
            FluidBodyCoupling::readControls(solution.subDictOrEmpty("coupling"), dicts_.lattice, fluid_->positivePressure());
        for (std::size_t k = 0; k < bodies_.size(); ++k)
            couplings.emplace_back(*bodies_[k], static_cast<int>(k), outlines_[k], particles_, controls, gravity_,
                                   fluid_->fluid().density());
    }
    solids_ = std::make_unique<SolidStage>(bodies_, std::move(contacts), std::move(couplings), gravity_, ledger_);
}

void Scene::buildGuard()
{
    SchemeSet const set = readSchemeSet(dicts_.schemes.value_or(Dictionary()));
    guard_ = std::make_unique<StepGuard>(dicts_.control, set, timeStep_->adjustable(), gravity_, fluid_ ? fluid_->fluid().density() : 0);
    if (guard_->redoes()) stepStart_ = std::make_unique<StepStart>();
    if (guard_->active()) guardTimer_ = Timers::add("watch over steps", "redo of steps");
}

void Scene::checkDictionaries() const
{
    dicts_.control.requireAllRead();
    if (dicts_.transport) dicts_.transport->requireAllRead();
    if (dicts_.contact && solids_) dicts_.contact->requireAllRead();
    if (dicts_.schemes && fluid_) dicts_.schemes->requireAllRead();
    if (!dicts_.solution || !fluid_) return;
    if (!solids_) dicts_.solution->ignore("coupling");
    dicts_.solution->requireAllRead();
}

} // namespace mpsDem
