#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "scene/CaseConstants.h"
#include "scene/Effects.h"
#include "scene/FluidStage.h"
#include "scene/Output.h"
#include "scene/RunTime.h"
#include "scene/SavedGeometry.h"
#include "scene/SceneDictionaries.h"
#include "scene/SolidStage.h"
#include "scene/StepGuard.h"
#include "scene/StepStart.h"

namespace mpsDem {

/// Everything that a case's dictionaries name, and nothing else. A dictionary that is absent means an effect that is absent.
class Scene
{
public:
    /// What the command line asks for.
    struct Options
    {
        bool functionObjects = true;
        State const* initial = nullptr; ///< To be started from instead of what the case has saved.
    };

    /// Reads the case and the state that the run starts from (the newest valid checkpoint or the initial state).
    Scene(CaseFolder const& caseFolder, Options const& options);
    ~Scene();

    [[nodiscard]] RunTime& time() { return *time_; }

    /// Takes the next step, its length from the state of fluid and bodies. Where it goes wrong it is undone and taken again with half its
    /// length (StepGuard). @param stages  All stages of a step, in their order. @return the step that was taken in the end
    Step takeStep(std::function<void(Step const&)> const& stages);

    // The stages of a step; each does nothing where its effect is absent.
    /// Particles of bodies take their place and motion.
    void moveBoundaries();
    /// Order in space, periodic images, neighbours at r^m.
    void updateNeighbours(Step const& step);
    /// Number density, free surface, DBL (Fig 2).
    void label();
    /// u* of fluid and boundary: eq 2 without grad p.
    void predict(Step const& step);
    /// p^{m+1} by eq 8. @throw CaseError Solver or NotFinite
    void solvePressure(Step const& step);
    /// Force and moment of the pressure on each body (eqs 15-16), added mass where the coupling is strong.
    void loadBodies(Step const& step);
    /// Contacts (eqs 11-12) and motion (eqs 13-14) in sub-steps; the pressure is corrected for the acceleration found.
    void advanceBodies(Step const& step);
    /// u^{m+1}, r^{m+1} by eq 4; collision, shifting. @throw CaseError NotFinite
    void correctFluid(Step const& step);
    /// After a step: time goes on, function objects.
    void observe(Step const& step);

    /// Takes over an edited controlDict between two steps and tells in the log what has changed: times, writing, length and redo of steps.
    /// `functions`, startFrom and startTime count at the next start. @throw CaseError as at a start; nothing has changed then.
    void takeOver(Dictionary const& control);

    /// Fields for ParaView and a checkpoint, where the step asks for them or is the last.
    /// @throw CaseError Solver after that where the water has gained too much energy (StepGuard).
    void writeIfDue(Step const& step);
    /// Fields of the very start.
    void writeStart();
    /// Fields of the very end, and a checkpoint.
    void writeEnd();
    /// Fields now.
    void writeFields();
    /// Asks for a checkpoint, or for one and the end of the run, at the next step at which a restarted run goes on with the same bytes, and
    /// tells it in the log. @param who  What asked, e.g. "signal 12 (SIGUSR2)". A second request changes nothing.
    void askCheckpoint(std::string const& who);
    void askStop(std::string const& who);
    /// Writes a checkpoint that was asked for, or that is due by the clock, if this is such a step.
    void serveCheckpoint();

    /// Line of the log for a run that was stopped: where it stands and which state it has saved.
    void logStop() const;
    /// Lines of the log for a step.
    void logStep(Step const& step, double executionTime, double clockTime) const;
    /// The bill, escaped particles, limited accelerations.
    void logEnd(Cost const& loop) const;

    [[nodiscard]] bool hasFluid() const { return fluid_ != nullptr; }
    [[nodiscard]] ParticleSet const& particles() const { return particles_; }
    [[nodiscard]] std::vector<std::unique_ptr<RigidBody>> const& bodies() const { return bodies_; }
    [[nodiscard]] FluidStage const* fluid() const { return fluid_.get(); }
    [[nodiscard]] SolidStage const* solids() const { return solids_.get(); }
    [[nodiscard]] StepGuard const& guard() const { return *guard_; }
    [[nodiscard]] Ledger const& ledger() const { return ledger_; }
    [[nodiscard]] State state() const;

private:
    [[nodiscard]] Step nextStep();
    /// The present step with another length at most [s].
    [[nodiscard]] Step stepOf(Real wanted);
    [[nodiscard]] bool succeeds(Step const& step, std::function<void(Step const&)> const& stages);
    /// Wall particles that fluid passed in this step: it was in front of one and is beside or behind it now.
    [[nodiscard]] int particlesThroughWalls() const;
    void rememberStart();
    void undo();
    void readStart(State const& start);
    void checkStart(State const& start);
    void buildFluid();
    [[nodiscard]] std::unique_ptr<ContactModel> makeContacts(std::vector<RigidBody*> const& bodies) const;
    void buildSolids();
    void buildGuard();
    void listEffects();
    void listFluidEffects();
    void listSchemes();
    void listBodyEffects();
    void checkDictionaries() const;
    void accumulateImpulse(Step const& step);
    void writeCheckpointNow();
    /// Whether a restart after the present step goes on with the same bytes.
    [[nodiscard]] bool atSeam() const;
    /// The state that this run began with was the end already.
    [[nodiscard]] bool nothingRun() const { return time_->stepNumber() == startStep_ && startStep_ > 0; }
    void logRequest(std::string const& who, std::string const& what) const;

    CaseFolder case_;
    SceneDictionaries dicts_;
    Vector gravity_ = Vector::Zero();
    std::unique_ptr<RunTime> time_;
    std::unique_ptr<TimeStep> timeStep_;
    Ledger ledger_;
    ParticleSet particles_;
    std::vector<Surface> surfaces_;
    std::vector<std::string> surfaceNames_;
    Field<int> wallOf_;
    std::optional<Real> rowsMadeFor_; ///< Largest effective radius over the spacing that setParticles knew of.
    std::vector<std::unique_ptr<RigidBody>> bodies_;
    std::vector<Surface> outlines_;
    std::vector<Real> discRadii_; ///< 0 for bodies that are no discs [m].
    std::unique_ptr<FluidStage> fluid_;
    std::unique_ptr<SolidStage> solids_;
    std::vector<WettedSurface> fixedSurfaces_;                  ///< Only where a momentum budget asks for the impulse of the walls.
    Vector *wallImpulse_ = nullptr, *gravityImpulse_ = nullptr; ///< Of the water, in the ledger; as fixedSurfaces_.
    std::unique_ptr<StepGuard> guard_;
    std::unique_ptr<StepStart> stepStart_; ///< Null where no step is taken again.
    std::unique_ptr<RunContext> context_;
    std::unique_ptr<FunctionObjects> observers_;
    std::unique_ptr<Output> output_;
    Effects effects_;
    SolveReport lastSolve_;
    mutable Real cumulativeError_ = 0; ///< Of the log.
    bool solved_ = false;
    double particleSteps_ = 0;
    int checkpointTimer_ = -1, observerTimer_ = -1, guardTimer_ = -1, impulseTimer_ = -1;
    bool checkpointAsked_ = false, checkpointDue_ = false, stopAsked_ = false; ///< By a user, by the clock, by a user.
    std::int64_t startStep_ = 0;                                               ///< Step from which this run goes on.
    std::int64_t lastCheckpoint_ = -1;                                         ///< Step of the last checkpoint of this run.
    std::chrono::steady_clock::time_point lastCheckpointClock_;
};

} // namespace mpsDem
