#pragma once

#include <string>

#include "core/dictionary/Node.h"

namespace mpsDem::dictionary {

/// True for the element types that `List<type> N(...)` may name.
bool isListType(Token const& token);

/// A number as OpenFOAM prints it: six significant digits at most, without a sign for zero.
std::string numberText(Token const& token);

/// Tokens separated by single blanks; a `List<type>` in OpenFOAM's form of a list: `3(1 2 3)`, `3{0}` or one value a line.
std::string tokensText(Tokens const& tokens);

/// Entries in OpenFOAM's output form. @param depth  Levels of four blanks; a blank line separates entries at level 0.
std::string nodeText(Dictionary::Node const& node, int depth = 0);

/// One entry: `key value;` or `key` and its dictionary.
std::string entryText(Entry const& entry, int depth = 0);

/// Keywords in the order of the file, quoted ones in quotes.
std::vector<std::string> printedKeys(Dictionary::Node const& node);

} // namespace mpsDem::dictionary
