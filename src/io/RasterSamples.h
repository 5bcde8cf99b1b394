#pragma once

#include <string>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Heights of a raster on a grid, rows from north to south; NaN where there is none.
struct RasterSamples
{
    std::vector<Real> east, south; ///< Of each column and row, from the middle of the north-western cell [cells].
    Field<Real> height;            ///< In units of the file.
    Field<int> line;               ///< Of the file, of each height.

    [[nodiscard]] int columns() const { return static_cast<int>(east.size()); }
    [[nodiscard]] int rows() const { return static_cast<int>(south.size()); }
    [[nodiscard]] std::size_t index(int row, int column) const
    {
        return static_cast<std::size_t>(row) * east.size() + static_cast<std::size_t>(column);
    }
    [[nodiscard]] Real at(int row, int column) const { return height[index(row, column)]; }
};

/// What messages about heights need to know of the file.
struct RasterSource
{
    std::string file;
    Real missing; ///< NODATA_value.
    Real extent;  ///< Of the longer side, in units of the file.
};

/// Refuses heights that no ground has, before anything is built of them. With m the middle of all heights and R the difference between those
/// that a tenth lies below and above, a height further from m than 10 R is
/// - refused where it is further than twice the raster's extent, or a number that stands for "none" in many files (-9999, -32768 ...);
/// - warned of otherwise, where R is not 0.
/// @throw CaseError BadInput with the line, row and column of the first such height and their number.
void checkHeights(RasterSamples const& samples, RasterSource const& source);

/// A warning with number and place where heights are missing (NODATA) all around which there are some.
void warnOfHoles(RasterSamples const& samples, std::string const& file);

/// A warning where a row begins within a line of a file of several lines: a header with ncols and nrows exchanged announces as many heights, and
/// all would be read, into a terrain that is none.
void warnOfRowsWithinLines(RasterSamples const& samples, std::string const& file);

/// The samples and a ring of heights along the outer sides of the outermost cells, in a line with the two last ones of each row and column;
/// as high as the last one where that before it is missing.
/// @param columns, rows  Of cells of the file.
RasterSamples continued(RasterSamples const& samples, int columns, int rows);

} // namespace mpsDem
