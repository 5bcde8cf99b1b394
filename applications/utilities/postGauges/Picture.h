#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/Dictionary.h"

namespace mpsDem::postGauges {

/// What all pictures have in common; keys of the dictionary as a whole, or of one plot.
struct PictureSettings
{
    std::vector<std::string> formats = {"png", "svg"};
    int fontSize = 13;       ///< [points]
    bool keepScript = false; ///< Leaves the folder <name>.gnuplot with script and data.

    /// Reads `formats`, `fontSize`, `keepScript`; what is missing is taken from `defaults`.
    static PictureSettings read(Dictionary const& dict, PictureSettings const& defaults);
};

/// A picture drawn by gnuplot, which runs as a process of its own, without a screen and without the user's settings.
///
/// The script and its data stand in a new folder beside the result, in which gnuplot runs: it never sees a path or a name that a user
/// chose, so no name can be taken for a command. The finished picture is moved into place by a rename.
class Picture
{
public:
    /// @param folder  Where the result goes; made where missing. @param name  File name without ending.
    Picture(std::filesystem::path folder, std::string name, int width, int height, PictureSettings settings);
    ~Picture();
    Picture(Picture const&) = delete;
    Picture& operator=(Picture const&) = delete;

    /// Commands, the same for each format; run once a format.
    std::ostream& script() { return script_; }

    /// Writes a data file. @return its name for the script, in quotes.
    std::string addData(std::string_view contents);

    /// Runs gnuplot. @return files made, one a format.
    /// @throw CaseError (InputOutput) where gnuplot is missing or fails.
    std::vector<std::filesystem::path> render();

private:
    void writeScript() const;
    void runGnuplot() const;

    std::filesystem::path folder_;
    std::string name_;
    int width_;
    int height_;
    PictureSettings settings_;
    std::filesystem::path work_;
    std::ostringstream script_;
    int files_ = 0;
};

} // namespace mpsDem::postGauges
