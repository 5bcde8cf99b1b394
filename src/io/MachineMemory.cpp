#include "io/MachineMemory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace mpsDem {

namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

/// First number of a file; unknown where there is none ("max").
std::uint64_t numberIn(std::filesystem::path const& file)
{
    std::ifstream in(file);
    std::uint64_t number = 0;
    return in >> number ? number : unknown;
}

std::uint64_t less(std::uint64_t limit, std::uint64_t used)
{
    if (limit == unknown || used == unknown) return unknown;
    return limit > used ? limit - used : 0;
}

std::uint64_t ofTheSystem()
{
    std::ifstream in("/proc/meminfo");
    std::string key, unit;
    std::uint64_t kilobytes = 0;
    while (in >> key >> kilobytes && std::getline(in, unit))
        if (key == "MemAvailable:") return 1024 * kilobytes;
    return unknown;
}

std::uint64_t ofTheProcess()
{
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
    std::uint64_t const pages = numberIn("/proc/self/statm");
    return less(limit.rlim_cur, pages == unknown ? 0 : pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
}

/// What the processes of a control group hold; its page cache does not count, the system gives it back.
std::uint64_t heldBy(std::filesystem::path const& group)
{
    std::ifstream in(group / "memory.stat");
    std::string key;
    std::uint64_t bytes = 0;
    while (in >> key >> bytes)
        if (key == "anon") return bytes;
    return 0;
}

/// Version 2 of control groups: the line "0::/path" of /proc/self/cgroup.
std::uint64_t ofTheControlGroup()
{
    std::ifstream in("/proc/self/cgroup");
    std::string line;
    while (std::getline(in, line))
    {
        if (!line.starts_with("0::/")) continue;
        std::filesystem::path const folder = "/sys/fs/cgroup" + line.substr(3);
        return less(numberIn(folder / "memory.max"), heldBy(folder));
    }
    return unknown;
}

} // namespace

std::uint64_t availableMemory() { return std::min({ofTheSystem(), ofTheProcess(), ofTheControlGroup()}); }

void returnLargeBlocks()
{
#ifdef __GLIBC__
    ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

} // namespace mpsDem
