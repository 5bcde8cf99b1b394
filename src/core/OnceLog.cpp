#include "core/OnceLog.h"

#include <map>
#include <set>

#include "core/Log.h"

namespace mpsDem {

namespace {

std::set<std::string> shown;
std::map<std::string, int> counts; ///< Of warnSeldom(), by key.

} // namespace

void infoOnce(std::string const& text)
{
    if (shown.insert(text).second) info() << text << '\n';
}

void warnOnce(std::string const& text)
{
    if (shown.insert(text).second) warn(text);
}

void warnSeldom(std::string const& text, std::string const& key)
{
    int const count = ++counts[key];
    int decade = 1;
    while (decade <= count / 10) decade *= 10;
    if (count == decade) warn(count == 1 ? text : text + " (" + std::to_string(count) + " such warnings so far)");
}

void tellSeldom(std::ostream& os)
{
    bool any = false;
    for (auto const& [key, count] : counts)
    {
        if (count < 2) continue;
        os << "Warnings in all, " << key << ": " << count << '\n';
        any = true;
    }
    if (any) os << '\n';
}

void forgetShown()
{
    shown.clear();
    counts.clear();
}

} // namespace mpsDem
