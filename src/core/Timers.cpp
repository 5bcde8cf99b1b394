#include "core/Timers.h"

#include <ctime>

namespace mpsDem {

namespace {

std::vector<Timers::Stage>& stages()
{
    static std::vector<Timers::Stage> all;
    return all;
}

} // namespace

int Timers::add(std::string const& name, std::string const& effect)
{
    stages().push_back({name, effect, 0, 0, 0});
    return static_cast<int>(stages().size()) - 1;
}

Timers::Stage& Timers::stage(int number) { return stages()[static_cast<std::size_t>(number)]; }

std::vector<Timers::Stage> const& Timers::all() { return stages(); }

double Timers::processorTime()
{
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void Timers::clear() { stages().clear(); }

} // namespace mpsDem
