#include "core/Log.h"

#include <iostream>
#include <map>

namespace mpsDem {

namespace {

struct NullBuffer : std::streambuf
{
    int overflow(int c) override { return c; }
};

bool muted = false;
int warnings = 0;
std::map<std::string, int> warningsByKey;

} // namespace

std::ostream& info()
{
    static NullBuffer nowhere;
    static std::ostream silent(&nowhere);
    return muted ? silent : std::cout;
}

void warn(std::string const& text, std::string const& key, int limit)
{
    ++warnings;
    int const count = ++warningsByKey[key.empty() ? text : key];
    if (limit > 0 && count > limit) return;
    info() << "--> FOAM Warning : " << text << '\n';
    if (limit > 0 && count == limit) info() << "    (further warnings of this kind are not shown)\n";
}

int warningCount() { return warnings; }

void muteLog(bool mute) { muted = mute; }

} // namespace mpsDem
