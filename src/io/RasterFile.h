#pragma once

#include <filesystem>
#include <string>

#include "core/TriSurface.h"
#include "core/Types.h"

namespace mpsDem {

/// How a raster of heights becomes a surface.
struct RasterOptions
{
    enum class Up
    {
        Y, ///< As in 2-D: x east, y up, z south.
        Z  ///< x east, y north, z up.
    };

    Up up = Up::Z;
    Vector origin = Vector::Zero(); ///< East, north and height in the file that become (0 0 0): near the scene, so that no digits are lost.
    Real scale = 1;                 ///< Metres per unit of the file, of heights as of lengths.
    int every = 1;                  ///< Takes every n-th sample along rows and columns.
};

/// Reads a raster of heights in ESRI's ASCII grid format as a surface with the fluid above it.
///
/// `ncols nrows xllcorner|xllcenter yllcorner|yllcenter cellsize [NODATA_value]` in any order and in small or capital letters, then nrows rows of
/// ncols heights, the northernmost first. Each height is that of the middle of its cell; four of them are joined by two triangles along the
/// diagonal with the smaller difference of heights. Where one is missing (NODATA) one triangle remains, where more are, a hole, which a warning
/// counts and places. The surface covers its cells: beyond the middles of the outermost ones it goes on to their sides, in a line with the two
/// last heights.
/// @throw CaseError InputOutput where the file cannot be read; BadInput with the line for an entry that is unknown, missing, given twice or out
///        of range, a height that is no number or far off all others (checkHeights()), too few or too many of them, and a raster without a
///        triangle.
TriSurface readRaster(std::filesystem::path const& file, std::string const& name, RasterOptions const& options = {});

} // namespace mpsDem
