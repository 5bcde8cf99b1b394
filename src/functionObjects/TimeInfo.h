#pragma once

#include <chrono>

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type timeInfo;`: steps and wall-clock time. No keys of its own.
///
/// Table `timeInfo.dat`: step (number), deltaT [s], clockTime [s] since this process began to watch, clockTimePerStep [s], the mean since
/// the last line.
class TimeInfo : public FunctionObject
{
public:
    TimeInfo(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override { table_.printLast(os); }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin_ = Clock::now(), last_ = begin_;
    std::int64_t lastStep_ = -1; ///< Step of the last line; -1 before any.
    TableFile table_;
};

} // namespace mpsDem
