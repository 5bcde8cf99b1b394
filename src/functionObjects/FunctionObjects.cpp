#include <algorithm>
#include <limits>
#include <sstream>

#include "core/Log.h"
#include "functionObjects/FunctionObject.h"

namespace mpsDem {

namespace {

/// "interfaceHeight gauges write: eta0 = 0.1"; the time stands above in the log.
/// @return Whether there was something to tell.
bool report(std::string const& type, std::string const& name, FunctionObject const& object)
{
    std::ostringstream text;
    object.report(text);
    if (text.str().empty()) return false;
    info() << type << ' ' << name << " write: " << text.str() << '\n';
    return true;
}

} // namespace

FunctionObjects::FunctionObjects(Dictionary const& functions, RunContext const& context)
{
    for (std::string const& name : functions.dictKeys())
    {
        Dictionary const dict = functions.subDict(name);
        std::string const type = dict.get<std::string>("type");
        TimeControl const execute(dict, "execute"), write(dict, "write");
        Real const timeStart = dict.getOr<Real>("timeStart", -std::numeric_limits<Real>::max());
        Real const timeEnd = dict.getOr<Real>("timeEnd", std::numeric_limits<Real>::max());
        bool const enabled = dict.getOr<bool>("enabled", true);
        bool const log = dict.getOr<bool>("log", true);
        dict.ignore("region");
        auto object = functionObjectRegistry().make(type, dict.where("type"), name, dict, context);
        if (enabled) entries_.push_back({name, std::move(object), execute, write, timeStart, timeEnd, type, log});
    }
}

FunctionObjects::~FunctionObjects() = default;

bool FunctionObjects::empty() const { return entries_.empty(); }

void FunctionObjects::execute(Step const& step)
{
    Real const slack = 1e-6 * step.dt;
    bool told = false;
    for (Entry& entry : entries_)
    {
        if (step.time < entry.timeStart - slack || step.time > entry.timeEnd + slack) continue;
        bool const writes = entry.writeControl.due(step);
        if (writes || entry.executeControl.due(step)) entry.object->execute(step);
        if (!writes) continue;
        entry.object->write(step);
        if (entry.log) told = report(entry.type, entry.name, *entry.object) || told;
    }
    if (told) info() << std::endl;
}

Real FunctionObjects::nextTime(Real t) const
{
    Real next = std::numeric_limits<Real>::infinity();
    for (Entry const& entry : entries_)
        next = std::min({next, entry.executeControl.nextTime(t), entry.writeControl.nextTime(t), entry.object->wantedTime(t)});
    return next;
}

void FunctionObjects::save(State& state) const
{
    for (Entry const& entry : entries_) entry.object->save(state);
}

void FunctionObjects::load(State const& state)
{
    for (Entry& entry : entries_) entry.object->load(state);
}

} // namespace mpsDem
