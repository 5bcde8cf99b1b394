#include "scene/Effects.h"

#include <iomanip>
#include <map>

#include "core/Timers.h"

namespace mpsDem {

void Effects::print(std::ostream& os) const
{
    os << "Effects of this scene\n";
    for (Entry const& entry : entries_)
        os << "    " << std::left << std::setw(26) << entry.name << std::setw(5) << (entry.on ? "on" : "off") << entry.why << '\n';
    os << std::endl;
}

std::vector<std::string> Effects::lines() const
{
    std::vector<std::string> all;
    for (Entry const& entry : entries_) all.push_back(entry.name + (entry.on ? " on" : " off"));
    return all;
}

namespace {

void printLine(std::ostream& os, std::string const& name, double seconds, double total, double particleSteps)
{
    os << "    " << std::left << std::setw(40) << name << std::right << std::fixed << std::setprecision(3) << std::setw(12) << seconds
       << std::setprecision(2) << std::setw(10) << 100 * seconds / total << std::setprecision(4) << std::setw(14)
       << (particleSteps > 0 ? 1e6 * seconds / particleSteps : 0) << '\n';
}

} // namespace

void printBill(std::ostream& os, double total, double particleSteps)
{
    if (total <= 0) return;
    auto const flags = os.flags();
    auto const precision = os.precision();
    auto const heading = [&](char const* what) {
        os << "    " << std::left << std::setw(40) << what << std::right << std::setw(12) << "seconds" << std::setw(10) << "share %"
           << std::setw(14) << "us/part.step" << '\n';
    };
    std::map<std::string, double> effects;
    double counted = 0;
    os << "Cost of the time loop\n";
    heading("stage");
    for (Timers::Stage const& stage : Timers::all())
    {
        printLine(os, stage.name, stage.seconds, total, particleSteps);
        effects[stage.effect] += stage.seconds;
        counted += stage.seconds;
    }
    printLine(os, "rest", total - counted, total, particleSteps);
    printLine(os, "total", total, total, particleSteps);
    heading("effect");
    for (auto const& [name, seconds] : effects) printLine(os, name, seconds, total, particleSteps);
    printLine(os, "rest", total - counted, total, particleSteps);
    os.flags(flags);
    os.precision(precision);
}

} // namespace mpsDem
