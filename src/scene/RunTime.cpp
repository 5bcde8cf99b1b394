#include "scene/RunTime.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>

namespace mpsDem {

namespace {

/// Share of a step by which a time may be missed and still count as met.
constexpr Real meets = 1e-6;
constexpr Real never = std::numeric_limits<Real>::infinity();

} // namespace

RunTime::RunTime(Dictionary const& dict)
    : startFrom_(dict.getWordOr("startFrom", "latestTime", {"firstTime", "startTime", "latestTime"}, "start times")),
      startTime_(dict.getInRangeOr("startTime", 0, -1e12, 1e12))
{
    readEnd(dict);
    readWriting(dict);
    purgeWrite_ = static_cast<int>(dict.getInRangeOr("purgeWrite", 2, 0, 1e6));
    maxClockTime_ = dict.getInRangeOr("maxClockTime", 0, 0, 1e12);
    checkpointInterval_ = dict.getInRangeOr("checkpointInterval", 600, 0, 1e12);
    timePrecision_ = static_cast<int>(dict.getInRangeOr("timePrecision", 6, 1, 15));
    time_ = startTime_;
    static_cast<void>(dict.getWordOr("timeFormat", "general", {"general"}, "time formats"));
    static_cast<void>(dict.getWordOr("writeFormat", "binary", {"binary", "ascii"}, "write formats"));
    modifiable_ = dict.getOr<bool>("runTimeModifiable", true);
    for (char const* key : {"application", "writePrecision", "writeCompression"}) dict.ignore(key);
    lastClockWrite_ = clock();
}

void RunTime::readEnd(Dictionary const& dict)
{
    endTime_ = dict.getInRange("endTime", -1e12, 1e12);
    require(endTime_ >= startTime_, dict.where("endTime"), "endTime lies before startTime", "endTime >= startTime");
    std::string const stop = dict.getWordOr("stopAt", "endTime", {"endTime", "writeNow", "noWriteNow", "nextWrite"}, "stop times");
    stopAsked_ = stop == "writeNow";
    stopping_ = stop == "noWriteNow";
    stopAtWrite_ = stop == "nextWrite";
}

void RunTime::readWriting(Dictionary const& dict)
{
    std::string const control =
        dict.getWordOr("writeControl", "adjustableRunTime",
                       {"timeStep", "runTime", "adjustable", "adjustableRunTime", "cpuTime", "clockTime", "none"}, "write controls");
    writeInterval_ = dict.getInRangeOr("writeInterval", std::max(endTime_ - startTime_, Real(1e-12)), 1e-12, 1e12);
    writeControl_ = control == "timeStep"    ? WriteControl::TimeStep
                    : control == "runTime"   ? WriteControl::RunTime
                    : control == "cpuTime"   ? WriteControl::CpuTime
                    : control == "clockTime" ? WriteControl::ClockTime
                    : control == "none"      ? WriteControl::None
                                             : WriteControl::Adjustable;
}

void RunTime::take(RunTime const& edited)
{
    bool const otherClock = writeControl_ != edited.writeControl_;
    endTime_ = edited.endTime_;
    stopAsked_ = edited.stopAsked_;
    stopping_ = stopping_ || edited.stopping_;
    stopAtWrite_ = edited.stopAtWrite_;
    writeControl_ = edited.writeControl_;
    writeInterval_ = edited.writeInterval_;
    purgeWrite_ = edited.purgeWrite_;
    maxClockTime_ = edited.maxClockTime_;
    checkpointInterval_ = edited.checkpointInterval_;
    timePrecision_ = edited.timePrecision_;
    modifiable_ = edited.modifiable_;
    if (otherClock) lastClockWrite_ = clock();
}

Real RunTime::clock() const
{
    if (writeControl_ == WriteControl::CpuTime) return static_cast<Real>(std::clock()) / CLOCKS_PER_SEC;
    return std::chrono::duration<Real>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool RunTime::running() const { return !stopping_ && time_ < endTime_ - 1e-10 * std::max(Real(1), std::abs(endTime_)); }

Real RunTime::nextWriteTime() const
{
    bool const byTime = writeControl_ == WriteControl::Adjustable || writeControl_ == WriteControl::RunTime;
    if (!byTime) return never;
    Real const done = std::floor((time_ - startTime_) / writeInterval_ + meets);
    return startTime_ + (done + 1) * writeInterval_;
}

Step RunTime::next(Real wanted, bool fixed, Real observed)
{
    lastDt_ = wanted;
    Real target = observed;
    if (writeControl_ == WriteControl::Adjustable) target = std::min(target, nextWriteTime());
    // The end counts where it comes first: a run that ends at a write time and is continued later takes the steps of an unbroken one.
    bool const ends = endTime_ < target - meets * wanted;
    if (ends) target = endTime_;
    Real dt = wanted;
    if (!fixed)
    {
        // Equal steps up to the target, as OpenFOAM does it.
        Real const steps = std::max(Real(1), std::ceil((target - time_) / wanted - meets));
        dt = (target - time_) / steps;
    }
    else if (endTime_ - time_ < (1 - meets) * wanted)
        dt = endTime_ - time_;
    Step step{number_ + 1, time_ + dt, dt, false};
    // A target that is met is met to the last bit: times do not drift.
    bool const meetsTarget = std::abs(step.time - target) < meets * dt && !(fixed && ends);
    if (meetsTarget) step.time = target;
    step.write = writesAt(step.number, step.time);
    return step;
}

bool RunTime::writesAt(std::int64_t number, Real time) const
{
    switch (writeControl_)
    {
    case WriteControl::None:
        return false;
    case WriteControl::TimeStep:
        return number % std::max<std::int64_t>(1, std::llround(writeInterval_)) == 0;
    case WriteControl::Adjustable:
    case WriteControl::RunTime:
        return time >= nextWriteTime() - meets * lastDt_;
    default:
        return clock() - lastClockWrite_ >= writeInterval_;
    }
}

void RunTime::advance(Step const& step)
{
    time_ = step.time;
    number_ = step.number;
    if (!step.write) return;
    lastClockWrite_ = clock();
    stopping_ = stopping_ || stopAtWrite_;
}

std::string RunTime::format(Real time) const
{
    std::ostringstream text;
    text.precision(timePrecision_);
    text << (std::abs(time) < 1e-14 ? 0.0 : time);
    return text.str();
}

void RunTime::save(State& state) const
{
    state.set("time/value", time_);
    state.set("time/step", number_);
    state.set("time/lastDt", lastDt_);
}

void RunTime::load(State const& state)
{
    time_ = state.real("time/value");
    number_ = state.integer("time/step");
    lastDt_ = state.has("time/lastDt") ? state.real("time/lastDt") : 0;
}

} // namespace mpsDem
