#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/State.h"
#include "io/Manifest.h"

namespace mpsDem {

/// Saved states of a run: folders `<folder>/<name>/` with the block file `state.0` and the text `MANIFEST`.
///
/// A checkpoint is written to `<name>.part/`, forced onto the device, renamed and only then visible: whatever happens while one is
/// written, the ones before it stay loadable. Each single flipped bit, each truncation and each file of another checkpoint is found.
struct Checkpoint
{
    State state;
    CheckpointInfo info;
};

/// A checkpoint on disk whose manifest is valid; its blocks have not been read.
struct CheckpointEntry
{
    std::filesystem::path path;
    CheckpointInfo info;
};

/// Writes one checkpoint, replaces one of the same name, then removes the oldest ones.
/// @param folder  `<case>/checkpoint`; made where missing.
/// @param name    Folder of this checkpoint, the step as a rule.
/// @param keep    How many to keep in all; 0 (or less): every one; 1 counts as 2, so that one damaged is never the last.
/// @return        Path of the checkpoint.
/// @throw CaseError (InputOutput); earlier checkpoints are untouched then.
std::filesystem::path writeCheckpoint(std::filesystem::path const& folder, std::string const& name, State const& state, CheckpointInfo info,
                                      int keep = 2);

/// Loads `<path>/state.0` and `<path>/MANIFEST`: a checkpoint or an initial state.
/// @throw CaseError (InputOutput) where anything is missing or damaged.
Checkpoint readCheckpoint(std::filesystem::path const& path);

/// Checkpoints with a valid manifest and a block file of the right size, the one written last first.
/// Others are named in a warning, once.
std::vector<CheckpointEntry> listCheckpoints(std::filesystem::path const& folder);

/// The checkpoint written last whose manifest and blocks are all valid. Damaged ones are named in a warning and passed over.
std::optional<std::filesystem::path> findLatest(std::filesystem::path const& folder);

/// Writes the initial state into a time folder (`<case>/0`); other files there stay.
/// Written in `<timeFolder>.part/` and moved in; an end in between leaves the old state or a mixture that is refused, never a silent one.
/// @throw CaseError (InputOutput)
void writeInitialState(std::filesystem::path const& timeFolder, State const& state, CheckpointInfo const& info);

} // namespace mpsDem
