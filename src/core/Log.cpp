#include "core/Log.h"

#include <iostream>
#include <map>

#include <sys/stat.h>
#include <unistd.h>

namespace mpsDem {

namespace {

struct NullBuffer : std::streambuf
{
    int overflow(int c) override { return c; }
};

bool muted = false;
int warnings = 0;
std::map<std::string, int> warningsByKey;

/// Whether standard output and standard error end in one file or terminal.
bool sameDestination()
{
    struct stat out
    {
    }, error{};
    if (::fstat(STDOUT_FILENO, &out) != 0 || ::fstat(STDERR_FILENO, &error) != 0) return false;
    return out.st_dev == error.st_dev && out.st_ino == error.st_ino;
}

void printWarning(std::ostream& os, std::string const& text, bool last)
{
    os << "--> FOAM Warning : " << text << '\n';
    if (last) os << "    (further warnings of this kind are not shown)\n";
}

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
    bool const last = limit > 0 && count == limit;
    printWarning(info(), text, last);
    if (muted || sameDestination()) return;
    std::cout << std::flush;
    if (::isatty(STDERR_FILENO) == 1) std::cerr << "\r\033[K"; // over a line of progress
    printWarning(std::cerr, text, last);
}

int warningCount() { return warnings; }

void muteLog(bool mute) { muted = mute; }

} // namespace mpsDem
