#include <algorithm>

#include "core/Log.h"
#include "core/Timers.h"
#include "scene/Scene.h"

namespace mpsDem {

namespace {

bool sameEntries(Dictionary const& a, Dictionary const& b);

bool sameEntry(Dictionary const& a, Dictionary const& b, std::string const& key)
{
    if (a.found(key) != b.found(key) || a.isDict(key) != b.isDict(key)) return false;
    if (!a.found(key)) return true;
    return a.isDict(key) ? sameEntries(a.subDict(key), b.subDict(key)) : a.entryTokens(key) == b.entryTokens(key);
}

/// Keywords whose entries differ, or that only one of the two has, in the order of `b`.
std::vector<std::string> changedKeys(Dictionary const& a, Dictionary const& b)
{
    std::vector<std::string> changed;
    std::vector<std::string> keys = b.keys();
    for (std::string const& key : a.keys())
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    for (std::string const& key : keys)
        if (!key.starts_with('"') && !sameEntry(a, b, key)) changed.push_back(key); // a pattern is no key to ask for
    return changed;
}

bool sameEntries(Dictionary const& a, Dictionary const& b) { return changedKeys(a, b).empty(); }

std::string listed(std::vector<std::string> const& items)
{
    std::string text;
    for (std::string const& item : items) text += (text.empty() ? "" : ", ") + item;
    return text;
}

/// "maxCo = 0.2", "redoSteps", "writeInterval = default".
std::string told(Dictionary const& dict, std::string const& key)
{
    if (!dict.found(key)) return key + " = default";
    return dict.isDict(key) ? key : key + " = " + dict.entryText(key);
}

/// Entries that only a start reads; deltaT where it is the length of the first step alone.
bool countsAtStart(std::string const& key, bool adjustable)
{
    for (char const* known :
         {"functions", "startFrom", "startTime", "application", "timeFormat", "writeFormat", "writePrecision", "writeCompression"})
        if (key == known) return true;
    return adjustable && key == "deltaT";
}

void tell(Dictionary const& before, Dictionary const& now, bool adjustable)
{
    std::vector<std::string> taken, later;
    for (std::string const& key : changedKeys(before, now))
        if (countsAtStart(key, adjustable))
            later.push_back(key);
        else
            taken.push_back(told(now, key));
    info() << "Re-read system/controlDict: " << (taken.empty() ? "nothing to take over" : listed(taken)) << '\n';
    if (!later.empty()) info() << "    changed, but read at a start only: " << listed(later) << '\n';
    info() << std::endl;
}

} // namespace

void Scene::takeOver(Dictionary const& control)
{
    RunTime const time(control);
    TimeStep const timeStep(control, dicts_.lattice);
    SchemeSet const set = readSchemeSet(dicts_.schemes.value_or(Dictionary()));
    StepGuard const guard(control, set, timeStep.adjustable(), gravity_, fluid_ ? fluid_->fluid().density() : 0);
    if (observers_)
        static_cast<void>(FunctionObjects(control.subDictOrEmpty("functions"), *context_)); // could they be made? They write nothing yet
    else
        control.ignore("functions");
    control.requireAllRead(); // before anything is compared: that asks for all there is

    time_->take(time);
    *timeStep_ = timeStep;
    guard_->take(guard);
    if (!guard_->redoes())
        stepStart_.reset();
    else if (!stepStart_)
        stepStart_ = std::make_unique<StepStart>();
    if (guard_->active() && guardTimer_ < 0) guardTimer_ = Timers::add("watch over steps", "redo of steps");
    tell(dicts_.control, control, timeStep.adjustable());
    dicts_.control = control;
}

} // namespace mpsDem
