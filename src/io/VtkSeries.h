#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/VtkFile.h"

namespace mpsDem {

/// One line of a `.vtp.series` file.
struct SeriesEntry
{
    Real time = 0;              ///< [s]
    std::filesystem::path file; ///< As a path that can be opened.
};

/// Files of one object over time, as ParaView opens them in one go: `<case>/VTK/<name>/<name>_000000.vtp`, ... and
/// `<case>/VTK/<name>.vtp.series`.
///
/// Each file appears by a rename, then the series file does: a reader never meets a part, nor an entry without its file.
class VtkSeries
{
public:
    /// Touches no disk.
    /// @param name  Used as a folder and file name, so without '/' and quotes.
    VtkSeries(std::filesystem::path const& caseFolder, std::string name, VtkPrecision precision = VtkPrecision::Single);

    /// Begins or continues the series at `time` [s]: later entries and their files are removed, numbers go on after the last kept one.
    /// Done by the first write with its own time where it was not called; to be called at a restart before the first step.
    /// @throw CaseError (InputOutput)
    void startAt(Real time);

    /// Writes the next file; one of the same time as the last entry (to 1e-9 relative) takes its place.
    /// @throw CaseError (InputOutput)
    void write(Real time, PointCloud const& cloud);
    /// The same for cells, in another series.
    void write(Real time, SurfaceCells const& surface);

    /// `<case>/VTK/<name>.vtp.series`, what ParaView opens.
    [[nodiscard]] std::filesystem::path seriesFile() const;

private:
    std::filesystem::path nextFile(Real time);
    void append(Real time, std::filesystem::path const& file);
    void writeSeries() const;

    std::filesystem::path folder_; ///< `<case>/VTK`
    std::string name_;
    VtkPrecision precision_;
    bool started_ = false;
    std::vector<SeriesEntry> entries_;
};

/// Writes a `.vtp.series` file; the files of its entries lie in its folder or below.
/// @throw CaseError (InputOutput)
void writeSeries(std::filesystem::path const& path, std::vector<SeriesEntry> const& entries);

/// Entries of a `.vtp.series` file in its order.
/// @throw CaseError (InputOutput) where it cannot be read or is no series file.
std::vector<SeriesEntry> readSeries(std::filesystem::path const& path);

} // namespace mpsDem
