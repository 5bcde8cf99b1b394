#include "scene/Effects.h"

#include <algorithm>
#include <iomanip>
#include <map>

#include "core/Timers.h"

namespace mpsDem {

void Effects::print(std::ostream& os) const
{
    std::size_t width = 0;
    for (Entry const& entry : entries_) width = std::max(width, entry.name.size());
    os << "Effects of this scene\n";
    for (Entry const& entry : entries_)
        os << "    " << std::left << std::setw(static_cast<int>(width) + 2) << entry.name << std::setw(5) << (entry.on ? "on" : "off")
           << entry.why << '\n';
    os << std::endl;
}

std::vector<std::string> Effects::lines() const
{
    std::vector<std::string> all;
    for (Entry const& entry : entries_) all.push_back(entry.name + (entry.on ? " on" : " off"));
    return all;
}

namespace {

class Bill
{
public:
    Bill(std::ostream& os, Cost const& total, double particleSteps) : os_(os), total_(total), particleSteps_(particleSteps) {}

    void heading(char const* what) const
    {
        os_ << "    " << std::left << std::setw(40) << what << std::right << std::setw(12) << "clock s" << std::setw(14) << "processor s"
            << std::setw(10) << "share %" << std::setw(14) << "us/part.step" << '\n';
    }

    void line(std::string const& name, Cost const& cost) const
    {
        os_ << "    " << std::left << std::setw(40) << name << std::right << std::fixed << std::setprecision(3) << std::setw(12)
            << cost.clock << std::setw(14) << cost.processor << std::setprecision(2) << std::setw(10)
            << 100 * cost.processor / total_.processor << std::setprecision(4) << std::setw(14)
            << (particleSteps_ > 0 ? 1e6 * cost.processor / particleSteps_ : 0) << '\n';
    }

private:
    std::ostream& os_;
    Cost total_;
    double particleSteps_;
};

} // namespace

void printBill(std::ostream& os, Cost const& total, double particleSteps)
{
    if (total.clock <= 0 || total.processor <= 0) return;
    auto const flags = os.flags();
    auto const precision = os.precision();
    Bill const bill(os, total, particleSteps);
    std::map<std::string, Cost> effects;
    Cost rest = total;
    os << "Cost of the time loop (share and us/part.step of the processor's time; the clock goes on where others have the processor)\n";
    bill.heading("stage");
    for (Timers::Stage const& stage : Timers::all())
    {
        bill.line(stage.name, {stage.seconds, stage.processorSeconds});
        effects[stage.effect].clock += stage.seconds;
        effects[stage.effect].processor += stage.processorSeconds;
        rest.clock -= stage.seconds;
        rest.processor -= stage.processorSeconds;
    }
    bill.line("rest", rest);
    bill.line("total", total);
    bill.heading("effect");
    for (auto const& [name, cost] : effects) bill.line(name, cost);
    bill.line("rest", rest);
    os.flags(flags);
    os.precision(precision);
}

} // namespace mpsDem
