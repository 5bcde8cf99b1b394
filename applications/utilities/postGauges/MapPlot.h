#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/Table.h"
#include "postGauges/ColourBar.h"
#include "postGauges/Plot.h"

namespace mpsDem::postGauges {

/// Values on a grid of places, row by row; rows of places have one second coordinate.
struct MapGrid
{
    std::vector<Real> x, y, value;
    std::size_t perRow = 0;

    /// @throw CaseError (BadInput) for rows of different length, and for fewer than two rows or two places in a row.
    static MapGrid read(Table const& table, std::string const& xName, std::string const& yName, std::string const& valueName,
                        Location const& where);
    [[nodiscard]] std::size_t rows() const { return value.size() / perRow; }
};

/// `type map;`: what the function object elevationMap wrote, as colours seen from above.
///
/// | key | meaning | default |
/// |---|---|---|
/// | object | folder in postProcessing/ | |
/// | file | tables <file>_<time>.dat of it | map |
/// | time | [s], the nearest written one | the last |
/// | value | column: etaMax, arrival, eta, timeOfMax | etaMax |
/// | x y | columns of the places | x; z, or y where z does not change |
/// | contours | values of lines drawn over it | () |
/// | range scale label palette | of the colours, as for `particles` | palette viridis |
/// | title xLabel yLabel width maxHeight | | 1200 1200 pixels |
class MapPlot : public Plot
{
public:
    MapPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);
    void draw(PostCase const& postCase) const override;

private:
    [[nodiscard]] std::filesystem::path table(PostCase const& postCase) const;

    std::string object_, file_;
    std::optional<Real> time_;
    std::string value_, x_, y_;
    std::vector<Real> contours_;
    std::optional<std::pair<Real, Real>> range_;
    Real scale_;
    std::string label_, palette_, title_, xLabel_, yLabel_;
    int width_, maxHeight_;
    PictureSettings pictures_;
    Location where_;
};

} // namespace mpsDem::postGauges
