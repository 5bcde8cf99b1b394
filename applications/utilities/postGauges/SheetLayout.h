#pragma once

#include <utility>
#include <vector>

#include "core/Types.h"

namespace mpsDem::postGauges {

/// Part of a picture in shares of its width and height, from the lower left corner.
struct Box
{
    Real left = 0;
    Real right = 1;
    Real bottom = 0;
    Real top = 1;
};

/// Window in space that a panel shows [m].
struct Window
{
    Real xLow = 0;
    Real xHigh = 1;
    Real yLow = 0;
    Real yHigh = 1;
};

/// Where the panels and the colour bar of a sheet lie. Panels have the proportions of the window, so that discs are round.
struct SheetLayout
{
    int width = 0;           ///< Of the picture [pixels].
    int height = 0;          ///< [pixels]
    Real scale = 0;          ///< Pixels a metre.
    std::vector<Box> panels; ///< Row by row, from the upper left.
    Box bar;                 ///< Colour bar.
    int columns = 1;
    int rows = 1;
};

/// Lays out `count` panels.
/// @param columns    0: chosen so that the sheet is about as wide as high.
/// @param width      Of the picture [pixels]; made smaller where it would be higher than `mostHeight`.
/// @param fontSize   [points]; margins grow with it.
/// @param titleRoom  Above the panels, for a title of the sheet [pixels at 13 points].
/// @param sideText   Room for the words beside the colour bar or for a legend in its place [pixels at 13 points].
SheetLayout layOut(int count, int columns, Window const& window, int width, int mostHeight, int fontSize, Real sideText,
                   Real titleRoom = 0);

/// Rounds a range outwards to numbers that read well: (0.3 9788) -> (0 10000).
std::pair<Real, Real> niceRange(Real low, Real high);

/// Numbers that read well, some `about` of them, from low to high.
std::vector<Real> niceTics(Real low, Real high, int about);

/// How many numbers have room above each other [pixels] [points], 10 at most.
int ticsAbove(Real pixels, int fontSize);

/// Value below which the share `part` (0 to 1) of all values lies. @pre Not empty.
Real percentile(std::vector<Real> values, Real part);

} // namespace mpsDem::postGauges
