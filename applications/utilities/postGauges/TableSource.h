#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "io/Table.h"
#include "postGauges/PostCase.h"

namespace mpsDem::postGauges {

/// Where a table comes from.
///
/// | key | meaning | default |
/// |---|---|---|
/// | object | folder in postProcessing/ | none: `file` is a path |
/// | file | table of the object ("eta.dat"), or a path, relative to the case | the only table of the object |
/// | case | another case, relative to this one | this one |
/// | startTime | all: the tables of all start times joined, a later start replacing what earlier ones wrote from there on; latest; or a time | all |
struct TableSource
{
    std::string object;
    std::string file;
    std::string caseFolder;
    std::string startTime = "all";
    Location where;

    /// Whether it is a file that the run does not make: no table of an object and none in a folder postProcessing.
    [[nodiscard]] bool isReference() const;
    /// The file of a source without object (findTable).
    [[nodiscard]] std::filesystem::path path(PostCase const& postCase) const;

    static TableSource read(Dictionary const& dict);

    /// @throw CaseError where a folder, file or time is missing; the message names those that exist.
    [[nodiscard]] Table load(PostCase const& postCase) const;
};

/// Value of an entry as one word, be it a word, a string or a number ("Time", "eta[m]", 2).
std::string wordOrNumber(Dictionary const& dict, std::string const& key);

/// The column of that name; also without a unit in brackets ("eta" finds "eta[m]"), or by its number, first 1.
/// @throw CaseError (BadInput) naming the columns that exist.
std::vector<Real> const& columnOf(Table const& table, std::string const& name, Location const& where);

/// One table of several in the order of their starts: rows of a table from the first time of the next one on are left out.
/// @throw CaseError (BadInput) where columns differ.
Table joinTables(std::vector<Table> const& tables);

/// The newest of the files that repeated runs from one start time leave: <stem>.dat, <stem>_<start>.dat, <stem>_<start>_2.dat, ...
/// Empty where there is none.
std::filesystem::path newestRun(std::filesystem::path const& startFolder, std::string const& file);

} // namespace mpsDem::postGauges
