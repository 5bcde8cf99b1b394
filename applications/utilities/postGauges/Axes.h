#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "core/Dictionary.h"

namespace mpsDem::postGauges {

/// Title, axes, legend and markers of an x-y plot.
///
/// | key | meaning | default |
/// |---|---|---|
/// | title xLabel yLabel | texts; _{} ^{} make sub- and superscripts | as the plot's kind |
/// | xRange yRange | (low high); left out: from the data | |
/// | logScale | (x), (y), (x y) or () | () |
/// | legend | topRight topLeft bottomRight bottomLeft outside none | topRight |
/// | verticalLines horizontalLines | places of dashed lines | () |
/// | grid | light lines | true |
/// | size | (width height) [pixels] | (900 600) |
struct Axes
{
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::optional<std::pair<Real, Real>> xRange;
    std::optional<std::pair<Real, Real>> yRange;
    bool logX = false;
    bool logY = false;
    std::string legend = "topRight";
    std::vector<Real> verticalLines;
    std::vector<Real> horizontalLines;
    bool grid = true;
    int width = 900;
    int height = 600;

    /// Reads the keys of the table; what is missing is taken from `defaults`.
    static Axes read(Dictionary const& dict, Axes const& defaults);

    /// gnuplot's settings; each call sets all of them, so that panels do not inherit from each other.
    void write(std::ostream& script) const;
};

/// Reads (low high) with low < high; nothing where the key is missing.
std::optional<std::pair<Real, Real>> readRange(Dictionary const& dict, std::string const& key);

/// Frame, tics and fonts common to all plots.
void writeStyle(std::ostream& script);

} // namespace mpsDem::postGauges
