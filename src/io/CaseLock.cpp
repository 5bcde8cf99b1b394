#include "io/CaseLock.h"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/Errors.h"
#include "core/Log.h"

namespace mpsDem {

namespace {

std::string reason(int code) { return std::error_code(code, std::generic_category()).message(); }

/// First line of the lock file, or empty.
std::string holder(int descriptor)
{
    std::array<char, 256> text{};
    ssize_t const bytes = ::pread(descriptor, text.data(), text.size(), 0);
    std::string const all(text.data(), bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
    return all.substr(0, all.find('\n'));
}

std::string ownName()
{
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '?';
    return std::to_string(::getpid()) + " on " + host.data() + "\n";
}

} // namespace

CaseLock::CaseLock(std::filesystem::path const& caseFolder)
{
    std::filesystem::path const path = caseFolder / ".mpsDem.lock";
    Location const where{path.string(), 0, {}};
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw CaseError(ExitCode::InputOutput, where, "cannot open the lock of the case: " + reason(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
    {
        int const code = errno;
        if (code == EWOULDBLOCK)
        {
            std::string const process = holder(descriptor_);
            ::close(descriptor_);
            throw CaseError(ExitCode::Locked, where, "the case is in use by process " + (process.empty() ? "(unknown)" : process),
                            "wait for its end or stop it; the lock file itself need not be removed");
        }
        warn(path.string() + " cannot be locked (" + reason(code) + "): nothing keeps a second run out of this case");
    }
    std::string const name = ownName();
    bool const written = ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, name.data(), name.size(), 0) == std::ssize(name);
    if (!written)
    {
        int const code = errno;
        ::close(descriptor_);
        throw CaseError(ExitCode::InputOutput, where, "cannot write the lock of the case: " + reason(code));
    }
}

CaseLock::~CaseLock() { ::close(descriptor_); }

} // namespace mpsDem
