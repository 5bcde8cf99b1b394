#include "io/Checkpoint.h"

#include <algorithm>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

namespace fs = std::filesystem;

constexpr char const* stateName = "state.0";
constexpr char const* manifestName = "MANIFEST";
constexpr char const* partSuffix = ".part"; ///< Being written or being removed.
constexpr char const* oldSuffix = ".old";   ///< Being replaced by one of the same name; still valid.

/// Both files in a new folder, forced onto the device.
void writeFolder(fs::path const& folder, State const& state, CheckpointInfo const& info)
{
    removeTree(folder);
    makeFolder(folder);
    Manifest manifest;
    manifest.info = info;
    manifest.file = writeStateFile(folder / stateName, state);
    OutputFile file(folder / manifestName);
    file.write(manifest.text());
    file.sync();
    file.close();
    syncFolder(folder);
}

/// Runs `write`; where it fails, removes `part` as far as possible, which also makes room on a full disk.
template <class Write>
void cleanlyWrite(fs::path const& part, Write write)
{
    try
    {
        write();
    }
    catch (CaseError const&)
    {
        std::error_code ignored;
        fs::remove_all(part, ignored);
        throw;
    }
}

/// Removes an older checkpoint. Failing to do so harms nothing that was saved: a warning.
void discard(fs::path const& checkpoint)
{
    fs::path const part = withSuffix(checkpoint, partSuffix);
    try
    {
        removeTree(part);
        moveFile(checkpoint, part); // half removed it must not look like a checkpoint
        removeTree(part);
    }
    catch (CaseError const& error)
    {
        warn(std::string("an old checkpoint stays: ") + error.what());
    }
}

/// Puts `part` in the place of `target`. The one replaced stays valid under another name until the new one is in place.
void install(fs::path const& part, fs::path const& target)
{
    fs::path const old = withSuffix(target, oldSuffix);
    bool const replaces = fs::exists(target);
    if (replaces)
    {
        if (fs::exists(old)) discard(old);
        moveFile(target, old);
    }
    try
    {
        moveFile(part, target);
    }
    catch (CaseError const&)
    {
        std::error_code ignored;
        if (replaces) fs::rename(old, target, ignored);
        throw;
    }
    syncFolder(parentFolder(target));
    if (replaces) discard(old);
}

Manifest readManifest(fs::path const& checkpoint)
{
    fs::path const path = checkpoint / manifestName;
    return Manifest::parse(readBytes(path), path);
}

/// Entry of a folder whose manifest is valid and whose block file has the right size.
CheckpointEntry lookAt(fs::path const& path)
{
    Manifest const manifest = readManifest(path);
    std::error_code error;
    auto const bytes = fs::file_size(path / stateName, error);
    if (error || bytes != manifest.file.bytes)
        throw CaseError(ExitCode::InputOutput, Location{(path / stateName).string(), 0, {}},
                        "saved state is missing or has the wrong size");
    return {path, manifest.info};
}

/// Removes what a killed run left half-written or half-removed.
void removeUnfinished(fs::path const& folder)
{
    std::vector<fs::path> unfinished;
    std::error_code error;
    fs::directory_iterator it(folder, error);
    for (; !error && it != fs::directory_iterator(); it.increment(error))
    {
        if (it->path().extension() == partSuffix) unfinished.push_back(it->path());
    }
    for (fs::path const& path : unfinished) fs::remove_all(path, error);
}

/// Removes all but the newest ones; never fewer than two stay.
void prune(fs::path const& folder, int keep)
{
    removeUnfinished(folder);
    if (keep <= 0) return;
    auto const entries = listCheckpoints(folder);
    for (std::size_t i = static_cast<std::size_t>(std::max(keep, 2)); i < entries.size(); ++i) discard(entries[i].path);
}

void warnDamaged(fs::path const& path, CaseError const& error)
{
    warn("checkpoint " + path.string() + " is not used: " + error.what(), "damaged checkpoint " + path.string(), 1);
}

} // namespace

fs::path writeCheckpoint(fs::path const& folder, std::string const& name, State const& state, CheckpointInfo info, int keep)
{
    bool const plain = !name.empty() && name.front() != '.' && name.find('/') == std::string::npos;
    expect(plain, "writeCheckpoint: the name is no plain file name");
    auto const entries = listCheckpoints(folder);
    info.sequence = entries.empty() ? 1 : entries.front().info.sequence + 1;
    fs::path const target = folder / name;
    fs::path const part = withSuffix(target, partSuffix);
    cleanlyWrite(part, [&] {
        bool const isNew = !fs::exists(folder);
        makeFolder(folder);
        if (isNew) syncFolder(parentFolder(folder));
        writeFolder(part, state, info);
        install(part, target);
    });
    prune(folder, keep);
    return target;
}

Checkpoint readCheckpoint(fs::path const& path)
{
    Manifest const manifest = readManifest(path);
    return {readStateFile(path / stateName, manifest.file), manifest.info};
}

std::vector<CheckpointEntry> listCheckpoints(fs::path const& folder)
{
    std::vector<CheckpointEntry> entries;
    std::error_code error;
    fs::directory_iterator it(folder, error);
    for (; !error && it != fs::directory_iterator(); it.increment(error))
    {
        fs::path const& path = it->path();
        std::error_code ignored;
        if (path.extension() == partSuffix || !it->is_directory(ignored)) continue;
        try
        {
            entries.push_back(lookAt(path));
        }
        catch (CaseError const& damage)
        {
            warnDamaged(path, damage);
        }
    }
    if (error && error != std::errc::no_such_file_or_directory)
        throw CaseError(ExitCode::InputOutput, Location{folder.string(), 0, {}}, "cannot read the folder: " + error.message());
    auto const writtenLater = [](CheckpointEntry const& a, CheckpointEntry const& b) {
        return a.info.sequence != b.info.sequence ? a.info.sequence > b.info.sequence : a.path > b.path;
    };
    std::sort(entries.begin(), entries.end(), writtenLater);
    return entries;
}

std::optional<fs::path> findLatest(fs::path const& folder)
{
    for (CheckpointEntry const& entry : listCheckpoints(folder))
    {
        try
        {
            readCheckpoint(entry.path);
            return entry.path;
        }
        catch (CaseError const& damage)
        {
            warnDamaged(entry.path, damage);
        }
    }
    return std::nullopt;
}

void writeInitialState(fs::path const& timeFolder, State const& state, CheckpointInfo const& info)
{
    fs::path const part = withSuffix(timeFolder, partSuffix);
    cleanlyWrite(part, [&] {
        writeFolder(part, state, info);
        makeFolder(timeFolder);
        moveFile(part / stateName, timeFolder / stateName);
        moveFile(part / manifestName, timeFolder / manifestName);
        syncFolder(timeFolder);
        removeTree(part);
    });
}

} // namespace mpsDem
