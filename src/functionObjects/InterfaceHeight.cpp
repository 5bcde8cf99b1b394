#include "functionObjects/InterfaceHeight.h"

#include <limits>

#include "core/Errors.h"
#include "functionObjects/Observed.h"

namespace mpsDem {

namespace {

std::vector<Vector> readLocations(Dictionary const& dict, RunContext const& context)
{
    requireFluid(context, dict);
    auto locations = placesOf(context, dict, "locations", dict.get<std::vector<Vector>>("locations"));
    require(!locations.empty(), dict.where("locations"), "locations is an empty list", "at least one point (x y z)");
    warnOfPlacesOutside(context, dict, "locations", locations, readUp(context, dict));
    return locations;
}

TableFile heightTable(std::string const& name, Dictionary const& dict, RunContext const& context, std::vector<Vector> const& locations)
{
    std::vector<std::string> header{"Elevation of the free surface along " + text(readUp(context, dict)) + " [m]",
                                    SurfaceElevationControls::read(dict).str(), "nan: no fluid in the column"};
    std::vector<std::string> columns;
    for (std::size_t k = 0; k < locations.size(); ++k)
    {
        columns.push_back("eta" + std::to_string(k));
        header.push_back(columns.back() + " at " + text(locations[k]));
    }
    return makeTable(context, name, "height", columns, header);
}

} // namespace

InterfaceHeight::InterfaceHeight(std::string const& name, Dictionary const& dict, RunContext const& context)
    : locations_(readLocations(dict, context)),
      surface_(context.particles, SurfaceElevationControls::read(dict), readUp(context, dict)),
      table_(heightTable(name, dict, context, locations_))
{}

void InterfaceHeight::write(Step const& step)
{
    surface_.update();
    std::vector<Real> values;
    for (Vector const& location : locations_)
        values.push_back(surface_.elevation(location).value_or(std::numeric_limits<Real>::quiet_NaN()));
    table_.add(step.time, values);
}

} // namespace mpsDem
