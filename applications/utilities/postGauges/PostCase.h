#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "postGauges/Picture.h"
#include "postGauges/TimeSelection.h"

namespace mpsDem::postGauges {

/// The case whose output is looked at.
struct PostCase
{
    std::filesystem::path root;
    TimeOptions times;        ///< Of the command line.
    PictureSettings pictures; ///< Defaults of all plots.
    Real spacing = 0;         ///< [m]; 0 where the case does not say.
    int dimensions = 2;
    Vector up = Vector::UnitY(); ///< Unit vector against gravity.

    /// Reads `spacing` and `dimensions` from constant/particleProperties and gravity from constant/g where these exist; keys of the same
    /// names in `dict` win. Reads the keys of PictureSettings too.
    static PostCase read(std::filesystem::path root, TimeOptions times, Dictionary const& dict);

    /// <case>/postProcessing/plots
    [[nodiscard]] std::filesystem::path plots() const { return root / "postProcessing" / "plots"; }

    /// <case>/postProcessing/surface
    [[nodiscard]] std::filesystem::path surfaces() const { return root / "postProcessing" / "surface"; }

    /// @throw CaseError (BadInput) where the spacing is not known.
    [[nodiscard]] Real requireSpacing() const;

    /// A path of the dictionary: relative ones start at the case.
    [[nodiscard]] std::filesystem::path resolve(std::string const& path) const { return root / path; }

    /// Path as messages and logs name it: relative to the case where it lies in it.
    [[nodiscard]] std::string shown(std::filesystem::path const& path) const;
};

/// A table that a dictionary names by a path, relative to a case. A path that leaves the case ("../../resources/slide.dat") is looked for
/// without its leading ".." in the case itself first, then as it stands, then beside the tutorials of this installation or source tree, so
/// that a case can be copied anywhere. Where no file is found: the path as it stands.
std::filesystem::path findTable(std::filesystem::path const& root, std::string const& path);

/// Writes a table into the folder of the plots and says so on the log.
void writeTable(PostCase const& postCase, std::string const& fileName, std::string const& contents);

/// Runs gnuplot and says on the log what was made.
void render(PostCase const& postCase, Picture& picture);

} // namespace mpsDem::postGauges
