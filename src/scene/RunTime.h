#pragma once

#include <filesystem>
#include <string>

#include "core/Dictionary.h"
#include "core/State.h"
#include "core/Step.h"

namespace mpsDem {

/// Times of a run as system/controlDict asks for them, with OpenFOAM's meanings.
///
/// | key | meaning | default |
/// | startFrom | firstTime, startTime, latestTime: where the state is taken from | latestTime |
/// | startTime | [s] | 0 |
/// | stopAt | endTime; writeNow (state saved), noWriteNow (at once, nothing saved), nextWrite end a running case | endTime |
/// | endTime | [s] | none |
/// | writeControl | timeStep, runTime, adjustable, adjustableRunTime, cpuTime, clockTime, none | adjustableRunTime |
/// | writeInterval | steps or seconds | endTime - startTime |
/// | purgeWrite | checkpoints kept, 0: all | 2 |
/// | maxClockTime | wall-clock seconds after which the run saves its state and stops; 0: none | 0 |
/// | checkpointInterval | wall-clock seconds between states saved beside those at write times; 0: none | 600 |
/// | timePrecision | digits of times in the log and of folder names | 6 |
/// | runTimeModifiable | whether a run takes over what is edited in controlDict | yes |
class RunTime
{
public:
    explicit RunTime(Dictionary const& controlDict);

    [[nodiscard]] std::string const& startFrom() const { return startFrom_; }
    [[nodiscard]] Real startTime() const { return startTime_; }
    [[nodiscard]] Real endTime() const { return endTime_; }
    [[nodiscard]] int purgeWrite() const { return purgeWrite_; }
    [[nodiscard]] Real maxClockTime() const { return maxClockTime_; }
    [[nodiscard]] Real checkpointInterval() const { return checkpointInterval_; }
    [[nodiscard]] Real time() const { return time_; }
    [[nodiscard]] std::int64_t stepNumber() const { return number_; }
    /// Length of the last step before it was cut; `first` before any.
    [[nodiscard]] Real lastDt(Real first) const { return lastDt_ > 0 ? lastDt_ : first; }

    /// True until the end time is reached or a stop was asked for.
    [[nodiscard]] bool running() const;

    /// The next step, not longer than `wanted`, shortened so that write times, times that observers ask for and the end are met exactly.
    /// @param wanted   [s]. @param fixed never shorten (except for the end).
    /// @param observed Next time that a function object wants to meet [s].
    [[nodiscard]] Step next(Real wanted, bool fixed, Real observed);

    /// Ends the step.
    void advance(Step const& step);

    /// Asks the run to end after this step, its state written (signals, stop file, stopAt).
    void stopNow() { stopping_ = true; }
    [[nodiscard]] bool stopping() const { return stopping_; }
    /// True where controlDict asks for the state to be saved and the run to end (stopAt writeNow).
    [[nodiscard]] bool stopAsked() const { return stopAsked_; }

    /// A time in the log's form: timePrecision digits.
    [[nodiscard]] std::string format(Real time) const;

    void save(State& state) const;
    void load(State const& state);

    /// Whether controlDict may be edited while running.
    [[nodiscard]] bool modifiable() const { return modifiable_; }
    /// Takes over what an edited controlDict says: all but startFrom and startTime, which a run has behind it.
    void take(RunTime const& edited);

private:
    enum class WriteControl
    {
        TimeStep,
        RunTime,
        Adjustable,
        CpuTime,
        ClockTime,
        None
    };

    void readEnd(Dictionary const& controlDict);
    void readWriting(Dictionary const& controlDict);
    [[nodiscard]] Real nextWriteTime() const;
    [[nodiscard]] bool writesAt(std::int64_t number, Real time) const;
    [[nodiscard]] Real clock() const;

    std::string startFrom_;
    Real startTime_, endTime_ = 0, writeInterval_ = 0, maxClockTime_ = 0, checkpointInterval_ = 0;
    WriteControl writeControl_ = WriteControl::Adjustable;
    int purgeWrite_, timePrecision_;
    bool stopping_ = false, stopAsked_ = false, stopAtWrite_ = false;
    Real time_ = 0, lastDt_ = 0, lastClockWrite_ = 0;
    std::int64_t number_ = 0;
    bool modifiable_ = true;
};

} // namespace mpsDem
