#include "io/CaseLock.h"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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

/// Takes the lock. @return False, with a warning, where the file system knows none. @throw CaseError (Locked), the file closed.
bool lock(int descriptor, Location const& where)
{
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
    int const code = errno;
    if (code == EWOULDBLOCK)
    {
        std::string const process = holder(descriptor);
        ::close(descriptor);
        throw CaseError(ExitCode::Locked, where, "the case is in use by process " + (process.empty() ? "(unknown)" : process),
                        "wait for its end or stop it; the lock file itself need not be removed");
    }
    warn(where.file + " cannot be locked (" + reason(code) + "): nothing keeps a second run out of this case");
    return false;
}

/// Whether the open file still is the one at the path.
bool isFile(int descriptor, std::filesystem::path const& path)
{
    struct stat own
    {
    }, there{};
    return ::fstat(descriptor, &own) == 0 && ::stat(path.c_str(), &there) == 0 && own.st_dev == there.st_dev && own.st_ino == there.st_ino;
}

} // namespace

CaseLock::CaseLock(std::filesystem::path const& caseFolder) : path_(caseFolder / ".mpsDem.lock")
{
    Location const where{path_.string(), 0, {}};
    while (true)
    {
        descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0) throw CaseError(ExitCode::InputOutput, where, "cannot open the lock of the case: " + reason(errno));
        locked_ = lock(descriptor_, where);
        // Between open and flock the one that held the file may have removed it: then this lock keeps nobody out.
        if (!locked_ || isFile(descriptor_, path_)) break;
        ::close(descriptor_);
    }
    std::string const name = ownName();
    bool const written = ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, name.data(), name.size(), 0) == std::ssize(name);
    if (written) return;
    int const code = errno;
    remove();
    throw CaseError(ExitCode::InputOutput, where, "cannot write the lock of the case: " + reason(code));
}

CaseLock::~CaseLock() { remove(); }

void CaseLock::remove() const
{
    if (locked_) ::unlink(path_.c_str());
    ::close(descriptor_);
}

} // namespace mpsDem
