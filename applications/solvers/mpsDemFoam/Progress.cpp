#include "mpsDemFoam/Progress.h"

#include <cstdio>

#include <unistd.h>

namespace mpsDem {

Progress::Progress(double startTime, double endTime)
    : startTime_(startTime),
      endTime_(endTime),
      terminal_(isatty(STDERR_FILENO) == 1),
      logBeside_(isatty(STDOUT_FILENO) == 1),
      begin_(Clock::now()),
      last_(begin_)
{}

void Progress::show(double time)
{
    if (!terminal_) return;
    Clock::time_point const now = Clock::now();
    if (std::chrono::duration<double>(now - last_).count() < 0.5) return;
    last_ = now;
    double const done = (time - startTime_) / (endTime_ - startTime_);
    double const spent = std::chrono::duration<double>(now - begin_).count();
    double const left = done > 0 ? spent * (1 - done) / done : 0;
    std::fprintf(stderr, "%s  t = %.4g s  %5.1f %%  %d:%02d left%s", logBeside_ ? "" : "\r", time, 100 * done, static_cast<int>(left) / 60,
                 static_cast<int>(left) % 60, logBeside_ ? "\n" : "   ");
}

void Progress::end()
{
    if (terminal_ && !logBeside_) std::fprintf(stderr, "\r%60s\r", "");
}

} // namespace mpsDem
