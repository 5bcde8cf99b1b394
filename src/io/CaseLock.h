#pragma once

#include <filesystem>

namespace mpsDem {

/// Keeps a second run out of a case: exclusive flock on `<case>/.mpsDem.lock`, which holds the process id and the host's name.
///
/// The kernel gives the lock back when the process ends, however it ends. The destructor removes the file; one that a killed process leaves
/// means nothing by itself.
/// Where the file system knows no locks there is a warning and no protection.
class CaseLock
{
public:
    /// @throw CaseError (Locked) naming the process that holds the case, or (InputOutput) where the file cannot be written.
    explicit CaseLock(std::filesystem::path const& caseFolder);
    ~CaseLock();
    CaseLock(CaseLock const&) = delete;
    CaseLock& operator=(CaseLock const&) = delete;

private:
    void remove() const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    bool locked_ = true; ///< False where the file system knows no locks.
};

} // namespace mpsDem
