#pragma once

#include <string>
#include <vector>

#include "core/dictionary/Node.h"

namespace mpsDem::dictionary {

/// An entry of the node that nobody asked for and whose keyword looks like a misspelt `key`, or null: one edit in a keyword of three
/// characters or more, or one edit in four characters.
Entry const* misspelt(Dictionary::Node const& node, std::string const& key);

/// Refuses a missing entry: at the line of the entry that looks like a misspelling of it, else at the dictionary's with what is allowed.
/// @param what  "entry" or "dictionary". @param allowed  For example "rho <number>;".
[[noreturn]] void refuseMissing(Dictionary::Node const& node, std::string const& key, std::string const& what, std::string const& allowed);

} // namespace mpsDem::dictionary
