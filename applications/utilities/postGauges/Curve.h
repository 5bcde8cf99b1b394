#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "postGauges/CurveMath.h"
#include "postGauges/Picture.h"
#include "postGauges/TableSource.h"

namespace mpsDem::postGauges {

/// How a curve looks.
///
/// | key | meaning | default |
/// |---|---|---|
/// | label | text in the legend; "" leaves it out | its name |
/// | style | line dashed points linePoints band | line |
/// | colour | auto, black grey blue orange green red purple skyBlue yellow, or "#rrggbb" | auto; points black, bands grey |
/// | lineWidth | [points at 72 dpi] | 2 |
/// | pointSize | relative | 1 |
struct CurveStyle
{
    std::string label;
    std::string kind = "line";
    std::string colour = "auto";
    Real lineWidth = 2;
    Real pointSize = 1;

    static CurveStyle read(Dictionary const& dict, CurveStyle const& defaults);
};

/// A curve ready to be drawn.
struct Curve
{
    std::string name;
    Points points;
    std::vector<Real> upper; ///< Upper edge of a band, else empty.
    CurveStyle style;
};

/// Columns of a table as a curve: the table's keys (TableSource), those of CurveStyle, and
///
/// | key | meaning | default |
/// |---|---|---|
/// | x y | column: name or number (first 1) | first and second column |
/// | y2 | upper edge of a band | needed for style band |
/// | xScale xOffset yScale yOffset | x -> xScale x + xOffset, the same for y and y2 | 1 0 1 0 |
struct CurveSource
{
    std::string name;
    TableSource table;
    std::string xColumn = "1";
    std::string yColumn = "2";
    std::string upperColumn;
    Real xScale = 1;
    Real xOffset = 0;
    Real yScale = 1;
    Real yOffset = 0;
    CurveStyle style;

    static CurveSource read(std::string const& name, Dictionary const& dict, CurveStyle const& defaults = {});
    [[nodiscard]] Curve load(PostCase const& postCase) const;
};

/// Loads curves in their order. A reference (TableSource::isReference) whose file is not there is left out with a warning.
std::vector<Curve> loadCurves(std::vector<CurveSource> const& sources, PostCase const& postCase);

/// Reads all entries of `curves { name {...} ... }`; none where the key is missing.
std::vector<CurveSource> readCurveSources(Dictionary const& dict, std::string const& key, CurveStyle const& defaults = {});

/// The plot command for all curves, bands first. Nothing finite to draw is an error.
void drawCurves(std::vector<Curve> const& curves, Picture& picture, std::vector<std::string> const& further = {});

/// "#rrggbb" of the n-th automatic colour: the set of Okabe and Ito (2008), which people with defective colour vision tell apart.
std::string automaticColour(std::size_t n);

} // namespace mpsDem::postGauges
