#pragma once

#include <chrono>
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

namespace mpsDem {

/// Everything that a case's dictionaries name, and nothing else. A dictionary that is absent means an effect that is absent.
class Scene
{
public:
    struct Options
    {
        bool functionObjects = true;
    };

    /// Reads the case and the state that the run starts from (the newest valid checkpoint or the initial state).
    Scene(CaseFolder const& caseFolder, Options const& options);
    ~Scene();

    [[nodiscard]] RunTime& time() { return *time_; }

    /// The next step, its length from the state of fluid and bodies.
    [[nodiscard]] Step nextStep();

    // The stages of a step; each does nothing where its effect is absent.
    void moveBoundaries();
    void updateNeighbours(Step const& step);
    void label();
    void predict(Step const& step);
    void solvePressure(Step const& step);
    void loadBodies(Step const& step);
    void advanceBodies(Step const& step);
    void correctFluid(Step const& step);
    void observe(Step const& step);

    /// Fields for ParaView and a checkpoint, where the step asks for them.
    void writeIfDue(Step const& step);
    /// Fields of the very start.
    void writeStart();
    /// Fields of the very end, and a checkpoint.
    void writeEnd();
    /// Fields now.
    void writeFields();
    /// Asks for a checkpoint, or for one and the end of the run, at the next step at which a restarted run goes on with the same bytes.
    void askCheckpoint() { checkpointAsked_ = true; }
    void askStop() { checkpointAsked_ = stopAsked_ = true; }
    /// Writes a checkpoint that was asked for, or that is due by the clock, if this is such a step.
    void serveCheckpoint();

    /// Lines of the log for a step.
    void logStep(Step const& step, double executionTime, double clockTime) const;
    /// The bill, escaped particles, limited accelerations.
    void logEnd(double loopSeconds) const;

    [[nodiscard]] bool hasFluid() const { return fluid_ != nullptr; }
    [[nodiscard]] ParticleSet const& particles() const { return particles_; }
    [[nodiscard]] std::vector<std::unique_ptr<RigidBody>> const& bodies() const { return bodies_; }
    [[nodiscard]] FluidStage const* fluid() const { return fluid_.get(); }
    [[nodiscard]] SolidStage const* solids() const { return solids_.get(); }
    [[nodiscard]] Ledger const& ledger() const { return ledger_; }
    [[nodiscard]] State state() const;

private:
    void readStart(State const& start);
    void buildFluid();
    void buildSolids();
    void listEffects();
    void checkDictionaries() const;
    void accumulateImpulse(Step const& step);
    void writeCheckpointNow();

    CaseFolder case_;
    SceneDictionaries dicts_;
    Vector gravity_ = Vector::Zero();
    std::unique_ptr<RunTime> time_;
    std::unique_ptr<TimeStep> timeStep_;
    Ledger ledger_;
    ParticleSet particles_;
    std::vector<Polyline> surfaces_;
    std::vector<std::string> surfaceNames_;
    Field<int> wallOf_;
    std::vector<std::unique_ptr<RigidBody>> bodies_;
    std::vector<Polyline> outlines_;
    std::vector<Real> discRadii_; ///< 0 for bodies that are no discs [m].
    std::unique_ptr<FluidStage> fluid_;
    std::unique_ptr<SolidStage> solids_;
    std::vector<WettedSurface> fixedSurfaces_; ///< Only where a momentum budget asks for the impulse of the walls.
    std::unique_ptr<RunContext> context_;
    std::unique_ptr<FunctionObjects> observers_;
    std::unique_ptr<Output> output_;
    Effects effects_;
    SolveReport lastSolve_;
    mutable Real cumulativeError_ = 0; ///< Of the log.
    bool solved_ = false;
    double particleSteps_ = 0;
    int checkpointTimer_ = -1, observerTimer_ = -1;
    bool checkpointAsked_ = false, stopAsked_ = false;
    std::int64_t lastCheckpoint_ = -1; ///< Step of the last checkpoint of this run.
    std::chrono::steady_clock::time_point lastCheckpointClock_;
};

} // namespace mpsDem
