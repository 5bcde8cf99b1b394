#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/Ledger.h"
#include "core/Registry.h"
#include "core/State.h"
#include "core/Step.h"
#include "functionObjects/TimeControl.h"
#include "particles/ParticleSet.h"

namespace mpsDem {

/// What a function object may look at. All references outlive the objects.
struct RunContext
{
    ParticleSet const& particles;                          ///< Empty where the case has no fluid.
    std::vector<std::unique_ptr<RigidBody>> const& bodies; ///< May be empty.
    std::vector<std::string> const& wallNames;             ///< Names of the fixed surfaces, in the order of `wallOf`.
    Field<int> const& wallOf;                              ///< For each boundary particle the index of its fixed surface; -1 on a body.
    Ledger const& ledger;
    Vector gravity; ///< [m/s2].
    Real density;   ///< Of the fluid [kg/m3]; 0 without fluid.
    std::filesystem::path caseRoot;
    Real startTime; ///< Time at which this run begins [s]: names the output folder.
};

/// Something that watches the run and writes tables: an entry of `functions` in system/controlDict.
class FunctionObject
{
public:
    virtual ~FunctionObject() = default;
    /// Takes in the state at the end of a step.
    virtual void execute(Step const& step) = 0;
    /// Writes what has been taken in, for step.time.
    virtual void write(Step const& step) = 0;
    /// The next time after t at which a step shall end exactly [s], beside those of its time controls.
    [[nodiscard]] virtual Real wantedTime(Real) const { return std::numeric_limits<Real>::infinity(); }
    /// What was written last, in one line without its end; nothing where the line would not tell more.
    virtual void report(std::ostream&) const {}
    /// State that must survive a restart (most have none).
    virtual void save(State&) const {}
    virtual void load(State const&) {}
};

using FunctionObjectRegistry = Registry<FunctionObject, std::string const&, Dictionary const&, RunContext const&>;

/// Every function object by the names of `type`: those of this library, and what others add before a case is read.
FunctionObjectRegistry& functionObjectRegistry();

/// The `functions` of a case with their time controls.
class FunctionObjects
{
public:
    /// @param functions  The dictionary `functions` of system/controlDict; may be empty.
    FunctionObjects(Dictionary const& functions, RunContext const& context);
    ~FunctionObjects();

    /// True where no object is enabled.
    [[nodiscard]] bool empty() const;
    /// Executes and writes those that are due at the end of this step.
    void execute(Step const& step);
    /// Times at which an object wants a step to end exactly (writeControl adjustableRunTime): the next one after t, or infinity.
    [[nodiscard]] Real nextTime(Real t) const;

    void save(State& state) const;
    void load(State const& state);

private:
    struct Entry
    {
        std::string name;
        std::unique_ptr<FunctionObject> object;
        TimeControl executeControl, writeControl;
        Real timeStart, timeEnd; ///< [s]
        std::string type;
        bool log; ///< A line in the log for each write.
    };
    std::vector<Entry> entries_;
};

} // namespace mpsDem
