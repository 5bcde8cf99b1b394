#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Numbers by column, read from a text file.
struct Table
{
    std::string file;                       ///< Where it was read, for messages.
    std::vector<std::string> names;         ///< One a column.
    std::vector<std::vector<Real>> columns; ///< All of the same length.

    [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    [[nodiscard]] bool has(std::string const& name) const;

    /// @throw CaseError (BadInput) with the known names and the nearest one.
    [[nodiscard]] std::vector<Real> const& column(std::string const& name) const;
};

/// Reads a table: numbers parted by blanks or by commas, one row a line; lines that begin with `#` and empty lines are passed over.
///
/// Names come from the last `#` line before the first row, or from a first line that is no numbers ("t, eta" or "t eta"), where it has as
/// many words as a row; otherwise columns are called "column1", "column2", ... Line ends of any system and a byte order mark are fine.
/// @throw CaseError (InputOutput) where the file cannot be read, (BadInput) with file:line for a word that is no number or a row of
///        another length.
Table readTable(std::filesystem::path const& path);

} // namespace mpsDem
