#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/PointCloud.h"
#include "io/VtkSeries.h"
#include "postGauges/PostCase.h"

namespace mpsDem::postGauges {

/// Values of the array `type` of particle files.
enum class ParticleKind : int
{
    Fluid = 0,
    Wall = 1,    ///< Takes part in the pressure equation.
    DryWall = 2, ///< Wall row labelled ghost by dynamic boundary labelling.
    Ghost = 3    ///< Rows behind the wall.
};

/// Particles of one time.
struct ParticleFrame
{
    Real time = 0; ///< [s]
    std::string file;
    PointCloudData data;
    std::vector<int> type;

    [[nodiscard]] std::vector<Vector> fluid() const;
    [[nodiscard]] std::vector<Vector> solid() const;

    /// Values of a field: an array of the file, `magX` for the magnitude of a vector X, `Xx`, `Xy`, `Xz` for its components.
    /// @throw CaseError (BadInput) naming the fields that exist.
    [[nodiscard]] std::vector<Real> field(std::string const& name, Location const& where) const;
};

/// Reads `show`: a list of fluid, wall, ghost. @throw CaseError (BadInput) for another word.
std::vector<std::string> readKinds(Dictionary const& dict, std::vector<std::string> const& standard);

/// Files of one object over time, <case>/VTK/<name>.vtp.series.
class Series
{
public:
    /// @throw CaseError (InputOutput) naming the series that exist.
    Series(PostCase const& postCase, std::string const& name, Location const& where);

    [[nodiscard]] std::vector<Real> times() const;
    [[nodiscard]] std::filesystem::path const& file(std::size_t i) const { return entries_[i].file; }

    /// @throw CaseError where the file cannot be read or has no array `type`.
    [[nodiscard]] ParticleFrame frame(std::size_t i) const;

private:
    std::vector<SeriesEntry> entries_;
};

/// Names of all series in <case>/VTK, sorted.
std::vector<std::string> seriesNames(PostCase const& postCase);

/// Closed outlines of a body at a time, as point chains.
std::vector<std::vector<Vector>> bodyOutlines(PostCase const& postCase, std::string const& body, Real time, Location const& where);

/// Rows "x y" of outlines, each closed and followed by an empty line, for `with filledcurves closed`.
std::string outlineRows(std::vector<std::vector<Vector>> const& outlines);

} // namespace mpsDem::postGauges
