#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mpsDem {

/// A file being written, every call of the system checked.
///
/// All functions of this header throw CaseError (InputOutput) that names the path, the operation and the system's reason. The process must
/// ignore SIGXFSZ, or the kernel ends it at a file size limit before an error can be reported.
class OutputFile
{
public:
    enum class Mode
    {
        Replace,
        New
    }; ///< New: refuse a file that exists.

    explicit OutputFile(std::filesystem::path path, Mode mode = Mode::Replace);
    ~OutputFile(); ///< Closes without a check what was not closed.
    OutputFile(OutputFile const&) = delete;
    OutputFile& operator=(OutputFile const&) = delete;

    /// Hands all bytes to the system; nothing stays in a buffer of this process.
    void write(std::string_view bytes);

    /// Forces the content onto the device (fsync).
    void sync();

    /// Closes; a second call does nothing.
    void close();

    [[nodiscard]] std::filesystem::path const& path() const { return path_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; } ///< Written so far.

private:
    [[noreturn]] void fail(char const* operation) const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
};

/// Whether the content of a replaced file must survive a loss of power (fsync) or only the death of the process.
enum class Durability
{
    Process,
    Power
};

/// Writes `path` so that a reader sees the old content or the new one, never a part: temporary file `<path>.part`, then a rename.
/// Missing folders are made. Refuses to replace what is no regular file.
void atomicWrite(std::filesystem::path const& path, std::string_view contents, Durability durability = Durability::Power);

/// Whole content of a file.
std::string readBytes(std::filesystem::path const& path);

/// Makes a folder and those above it; one that exists is fine.
void makeFolder(std::filesystem::path const& folder);

/// Renames a file or folder within one file system.
void moveFile(std::filesystem::path const& from, std::filesystem::path const& to);

/// Forces the names in a folder onto the device.
void syncFolder(std::filesystem::path const& folder);

/// Removes a file or a folder with all it holds; none there is fine.
void removeTree(std::filesystem::path const& path);

/// Folder that holds `path`: "." for a bare name; a trailing slash does not count.
std::filesystem::path parentFolder(std::filesystem::path const& path);

/// `path` with `suffix` appended to its last name ("a/b.vtp" -> "a/b.vtp.part").
std::filesystem::path withSuffix(std::filesystem::path const& path, std::string const& suffix);

} // namespace mpsDem
