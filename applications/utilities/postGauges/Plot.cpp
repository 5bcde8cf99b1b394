#include "postGauges/Plot.h"

#include "postGauges/ConvergencePlot.h"
#include "postGauges/CurvesPlot.h"
#include "postGauges/GaugesPlot.h"
#include "postGauges/ParticlesPlot.h"
#include "postGauges/ProfilesPlot.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

template <class Kind>
std::unique_ptr<Plot> make(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
{
    return std::make_unique<Kind>(name, dict, pictures);
}

} // namespace

PlotRegistry plotRegistry()
{
    PlotRegistry registry("plot type", "plot types");
    registry.add("curves", make<CurvesPlot>);
    registry.add("gauges", make<GaugesPlot>);
    registry.add("profiles", make<ProfilesPlot>);
    registry.add("particles", make<ParticlesPlot>);
    registry.add("convergence", make<ConvergencePlot>);
    return registry;
}

std::vector<std::unique_ptr<Plot>> readPlots(Dictionary const& dict, PictureSettings const& defaults)
{
    PlotRegistry const registry = plotRegistry();
    Dictionary const entries = dict.subDict("plots");
    std::vector<std::unique_ptr<Plot>> plots;
    for (std::string const& name : entries.keys())
    {
        require(entries.isDict(name), entries.where(name), "plots." + name + " must be a dictionary", name + " { type curves; ... }");
        require(isFileName(name), entries.where(name), "\"" + name + "\" cannot be the name of a picture file",
                "letters, digits and _ - + . = ,");
        Dictionary const plot = entries.subDict(name);
        plots.push_back(
            registry.make(plot.get<std::string>("type"), plot.where("type"), name, plot, PictureSettings::read(plot, defaults)));
    }
    require(!plots.empty(), dict.where("plots"), "plots is empty", "plots { <name> { type curves; ... } }");
    dict.requireAllRead();
    return plots;
}

} // namespace mpsDem::postGauges
