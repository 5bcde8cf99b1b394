#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "postGauges/Axes.h"
#include "postGauges/Plot.h"

namespace mpsDem::postGauges {

/// One run of a study of accuracy and cost.
struct StudyRun
{
    std::string scheme;
    Real spacing = 0; ///< [m]
    Real error = 0;   ///< NaN where the run gave none.
    Real spread = 0;  ///< Half-width of the error bar.
    Real seconds = 0; ///< Computing time [s].
    bool failed = false;
};

/// Reads lines `scheme spacing error spread seconds failed` (blanks or commas), in any order of columns: the last `#` line before the rows,
/// or a first line without numbers, names them. `failed` is 0 or 1; `-` or nan stands for a number that does not exist.
/// @throw CaseError with file:line.
std::vector<StudyRun> readStudy(std::filesystem::path const& path);

/// `type convergence;`: error over cost, log-log, one line a scheme, failed runs as crosses on the upper edge (at their error where they have one).
///
/// | key | meaning | default |
/// |---|---|---|
/// | file | table of the study, relative to the case | |
/// | abscissa | seconds or spacing | seconds |
/// | labels | { scheme "text"; } | the scheme's name |
/// | showSpacing | writes the spacing beside each point | true |
/// and the keys of Axes.
class ConvergencePlot : public Plot
{
public:
    ConvergencePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);
    void draw(PostCase const& postCase) const override;

private:
    /// Data of one scheme: finished runs and failed ones.
    struct Rows
    {
        std::string done;
        std::string failed;
    };

    [[nodiscard]] Axes axesFor(std::vector<StudyRun> const& runs, Location const& where) const;
    [[nodiscard]] Rows rowsOf(std::vector<StudyRun> runs, Axes const& axes) const;
    [[nodiscard]] Real abscissa(StudyRun const& run) const { return bySeconds_ ? run.seconds : run.spacing; }

    Axes axes_;
    std::string file_;
    bool bySeconds_;
    bool showSpacing_;
    std::map<std::string, std::string> labels_;
    PictureSettings pictures_;
};

} // namespace mpsDem::postGauges
