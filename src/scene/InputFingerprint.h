#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/CaseConstants.h"

namespace mpsDem {

/// What dictionaries of a case say, in one line: "system/controlDict 1a2b3c4d; constant/g -".
/// Each number is the CRC-32C of the dictionary with macros and includes expanded, so comments and blanks do not count; "-" is an absent file.
/// @param files  Relative to the case, or absolute.
[[nodiscard]] std::string fingerprintOf(CaseFolder const& caseFolder, std::vector<std::filesystem::path> const& files);

/// Dictionaries that mpsDemFoam reads.
[[nodiscard]] std::vector<std::filesystem::path> const& runInput();

/// Files of a fingerprint that say something else today, came or are gone. Empty for a text that is no fingerprint.
[[nodiscard]] std::vector<std::string> changedSince(CaseFolder const& caseFolder, std::string const& fingerprint);

/// Tells in the log which input has changed since a state was saved; nothing where none has.
/// @param remedy  What a user may want to do about it, or empty.
void logChangedInput(CaseFolder const& caseFolder, std::string const& fingerprint, std::string const& remedy);

} // namespace mpsDem
