#include "core/OnceLog.h"

#include <set>

#include "core/Log.h"

namespace mpsDem {

namespace {

std::set<std::string> shown;

} // namespace

void infoOnce(std::string const& text)
{
    if (shown.insert(text).second) info() << text << '\n';
}

void warnOnce(std::string const& text)
{
    if (shown.insert(text).second) warn(text);
}

void forgetShown() { shown.clear(); }

} // namespace mpsDem
