#pragma once

#include <chrono>

namespace mpsDem {

/// Percentage and time left on standard error, where that is a terminal; nothing elsewhere.
class Progress
{
public:
    Progress(double startTime, double endTime);
    /// At most twice a second.
    void show(double time);
    void end();

private:
    using Clock = std::chrono::steady_clock;
    double startTime_, endTime_;
    bool terminal_, logBeside_; ///< Standard error is one; standard output too: then each report has a line of its own.
    Clock::time_point begin_, last_;
};

} // namespace mpsDem
