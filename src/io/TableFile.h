#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "core/Types.h"
#include "io/OutputFile.h"

namespace mpsDem {

/// Time series of a function object: `<case>/postProcessing/<object>/<startTime>/<file>.dat`.
///
/// `#` header lines, the last one "# Time <column> ..."; then a line a call, time first, numbers parted by blanks. Each line is handed to
/// the system at once, so `tail -f` and a killed run lose nothing. A second run from the same start time does not touch the first file:
/// it writes `<file>_<startTime>.dat`, a third one `<file>_<startTime>_2.dat`, and so on.
class TableFile
{
public:
    /// Head and digits of a table.
    struct Options
    {
        std::vector<std::string> header; ///< Lines before the one with the column names, without "# ".
        int precision = 10;              ///< Significant digits.
    };

    /// Touches no disk: the file is made with the first row.
    /// @param startTime  Name of the time folder, as the run writes times.
    /// @param columns    Names without blanks, time not among them; units in brackets, e.g. "eta[m]".
    TableFile(std::filesystem::path const& caseFolder, std::string const& object, std::string const& startTime, std::string const& file,
              std::vector<std::string> columns, Options options);
    TableFile(std::filesystem::path const& caseFolder, std::string const& object, std::string const& startTime, std::string const& file,
              std::vector<std::string> columns);

    /// @param values  As many as there are columns.
    /// @throw CaseError (InputOutput)
    void add(Real time, std::span<Real const> values);

    /// Writes the last row in one line, "eta0 = 0.1, eta1 = 0.2", the first eight columns at most; nothing before the first row.
    void printLast(std::ostream& os) const;

    /// Path of the file in use; of the folder before the first row.
    [[nodiscard]] std::filesystem::path const& path() const { return path_; }

private:
    void open();

    std::filesystem::path path_;
    std::string file_;
    std::string startTime_;
    std::vector<std::string> columns_;
    Options options_;
    std::vector<Real> last_; ///< Row.
    std::unique_ptr<OutputFile> out_;
};

} // namespace mpsDem
