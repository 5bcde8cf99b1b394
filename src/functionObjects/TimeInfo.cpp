#include "functionObjects/TimeInfo.h"

#include <algorithm>
#include <array>

#include "functionObjects/Observed.h"

namespace mpsDem {

TimeInfo::TimeInfo(std::string const& name, Dictionary const&, RunContext const& context)
    : table_(makeTable(context, name, "timeInfo", {"step", "deltaT", "clockTime", "clockTimePerStep"},
                       {"deltaT [s], wall-clock time [s] since the start of this process and a step"}))
{}

void TimeInfo::write(Step const& step)
{
    Clock::time_point const now = Clock::now();
    auto const seconds = [now](Clock::time_point since) { return std::chrono::duration<Real>(now - since).count(); };
    std::int64_t const steps = lastStep_ < 0 ? 1 : std::max<std::int64_t>(1, step.number - lastStep_);
    std::array<Real, 4> const row{static_cast<Real>(step.number), step.dt, seconds(begin_), seconds(last_) / static_cast<Real>(steps)};
    table_.add(step.time, row);
    last_ = now;
    lastStep_ = step.number;
}

} // namespace mpsDem
