#include "io/OutputFile.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "core/Errors.h"
#include "io/WriteFault.h"

namespace mpsDem {

namespace {

namespace fs = std::filesystem;

constexpr char const* advice = "check free space, quota, file size limit and permissions of that place; what was saved before is intact";

[[noreturn]] void refuse(fs::path const& path, std::string const& operation, int reason)
{
    throw CaseError(ExitCode::InputOutput, Location{path.string(), 0, {}},
                    "cannot " + operation + ": " + std::error_code(reason, std::generic_category()).message(), advice);
}

/// Runs a call of the system again while a signal interrupts it; a fault set for tests comes first.
template <class Call>
auto guarded(Call call) -> decltype(call())
{
    if (writeFaultDue()) return -1;
    decltype(call()) result;
    do result = call();
    while (result < 0 && errno == EINTR);
    return result;
}

} // namespace

OutputFile::OutputFile(fs::path path, Mode mode) : path_(std::move(path))
{
    int const flags = O_WRONLY | O_CREAT | O_CLOEXEC | (mode == Mode::New ? O_EXCL : O_TRUNC);
    descriptor_ = guarded([&] { return ::open(path_.c_str(), flags, 0666); });
    if (descriptor_ < 0) refuse(path_, "open for writing", errno);
}

OutputFile::~OutputFile()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::fail(char const* operation) const
{
    int const reason = errno;
    refuse(path_, std::string(operation) + " after " + std::to_string(bytes_) + " bytes", reason);
}

void OutputFile::write(std::string_view bytes)
{
    expect(descriptor_ >= 0, "OutputFile: write after close");
    while (!bytes.empty())
    {
        ssize_t const written = guarded([&] { return ::write(descriptor_, bytes.data(), bytes.size()); });
        if (written < 0) fail("write");
        bytes_ += static_cast<std::uint64_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void OutputFile::sync()
{
    if (guarded([&] { return ::fsync(descriptor_); }) < 0) fail("force onto the device");
}

void OutputFile::close()
{
    if (descriptor_ < 0) return;
    bool const fault = writeFaultDue();
    int const reason = errno;
    int const result = ::close(descriptor_); // never repeated: the descriptor is gone even after an error
    descriptor_ = -1;
    if (fault) errno = reason;
    if (fault || (result < 0 && errno != EINTR)) fail("close");
}

void atomicWrite(fs::path const& path, std::string_view contents, Durability durability)
{
    std::error_code ignored;
    auto const kind = fs::status(path, ignored).type();
    if (kind != fs::file_type::not_found && kind != fs::file_type::regular) refuse(path, "replace what is no regular file", EINVAL);
    makeFolder(parentFolder(path));
    fs::path const part = withSuffix(path, ".part");
    try
    {
        OutputFile file(part);
        file.write(contents);
        if (durability == Durability::Power) file.sync();
        file.close();
        moveFile(part, path);
    }
    catch (CaseError const&)
    {
        fs::remove(part, ignored);
        throw;
    }
    if (durability == Durability::Power) syncFolder(parentFolder(path));
}

std::string readBytes(fs::path const& path)
{
    std::error_code error;
    std::uintmax_t const size = fs::file_size(path, error);
    if (error) refuse(path, "open for reading", error.value());
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "open for reading", errno);
    std::string bytes(size, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (file.gcount() != static_cast<std::streamsize>(size)) refuse(path, "read", EIO);
    return bytes;
}

void makeFolder(fs::path const& folder)
{
    std::error_code error;
    if (fs::is_directory(folder, error)) return;
    if (writeFaultDue()) refuse(folder, "make the folder", errno);
    fs::create_directories(folder, error);
    if (error) refuse(folder, "make the folder", error.value());
}

void moveFile(fs::path const& from, fs::path const& to)
{
    if (guarded([&] { return ::rename(from.c_str(), to.c_str()); }) < 0) refuse(to, "rename " + from.string() + " to this", errno);
}

void syncFolder(fs::path const& folder)
{
    int const descriptor = guarded([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
    if (descriptor < 0) refuse(folder, "open the folder", errno);
    int const result = guarded([&] { return ::fsync(descriptor); });
    int const reason = errno;
    ::close(descriptor);
    if (result < 0 && reason != EINVAL) refuse(folder, "force onto the device", reason); // EINVAL: this file system has no fsync of folders
}

void removeTree(fs::path const& path)
{
    if (writeFaultDue()) refuse(path, "remove", errno);
    std::error_code error;
    fs::remove_all(path, error);
    if (error) refuse(path, "remove", error.value());
}

fs::path parentFolder(fs::path const& path)
{
    fs::path const full = path.has_filename() ? path : path.parent_path();
    fs::path const parent = full.parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

fs::path withSuffix(fs::path const& path, std::string const& suffix)
{
    fs::path full = path.has_filename() ? path : path.parent_path();
    full += suffix;
    return full;
}

} // namespace mpsDem
