#include "functionObjects/TimeControl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpsDem {

namespace {

/// Share of an interval by which a multiple may be missed and still count as met.
constexpr Real meets = 1e-9;

} // namespace

TimeControl::TimeControl(Dictionary const& dict, std::string const& prefix)
{
    std::string const word = dict.getWordOr(prefix + "Control", "timeStep",
                                            {"timeStep", "runTime", "adjustable", "adjustableRunTime", "writeTime", "none"}, "controls");
    type_ = word == "timeStep"    ? Type::TimeStep
            : word == "runTime"   ? Type::RunTime
            : word == "writeTime" ? Type::WriteTime
            : word == "none"      ? Type::None
                                  : Type::Adjustable;
    interval_ = dict.getInRangeOr(prefix + "Interval", 1, 1e-12, 1e12);
}

bool TimeControl::due(Step const& step) const
{
    switch (type_)
    {
    case Type::None:
        return false;
    case Type::WriteTime:
        return step.write;
    case Type::TimeStep:
        return step.number % std::max<std::int64_t>(1, std::llround(interval_)) == 0;
    default:
        return std::floor(step.time / interval_ + meets) > std::floor(step.begin() / interval_ + meets);
    }
}

Real TimeControl::nextTime(Real t) const
{
    if (type_ != Type::Adjustable) return std::numeric_limits<Real>::infinity();
    return (std::floor(t / interval_ + meets) + 1) * interval_;
}

} // namespace mpsDem
