#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/Types.h"
#include "io/StateFile.h"

namespace mpsDem {

/// What a run says about itself beside its state. Texts are single lines.
struct CheckpointInfo
{
    Real time = 0;         ///< [s]
    std::int64_t step = 0; ///< Steps done since the start of the first run.
    std::string codeVersion;
    std::string inputHash;            ///< Of the dictionaries that the state was made with, see scene/InputFingerprint.h.
    std::vector<std::string> effects; ///< Which effects were present, a line each.
    std::int64_t sequence = 0;        ///< Set by the writer: 1 + the largest in the folder. The newest checkpoint is the one written last.
};

/// Text file MANIFEST: one fact a line, the last line the CRC-32C of all lines before it.
struct Manifest
{
    CheckpointInfo info;
    StateFileSummary file;

    /// @throw std::logic_error for a text of several lines.
    [[nodiscard]] std::string text() const;

    /// @param where  Path for messages.
    /// @throw CaseError (InputOutput) for text that is damaged to any degree or of another format version.
    static Manifest parse(std::string const& text, std::filesystem::path const& where);
};

} // namespace mpsDem
