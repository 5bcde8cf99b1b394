#include "postGauges/Plot.h"

#include <algorithm>

#include "core/Log.h"
#include "postGauges/ConvergencePlot.h"
#include "postGauges/CurvesPlot.h"
#include "postGauges/GaugesPlot.h"
#include "postGauges/MapPlot.h"
#include "postGauges/ParticlesPlot.h"
#include "postGauges/ParticlesSpacePlot.h"
#include "postGauges/ProfilesPlot.h"
#include "postGauges/Text.h"
#include "postGauges/WaterSurfacePlot.h"

namespace mpsDem::postGauges {

namespace {

template <class Kind>
std::unique_ptr<Plot> make(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
{
    return std::make_unique<Kind>(name, dict, pictures);
}

/// Flat or in space, as `view` says.
std::unique_ptr<Plot> makeParticles(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
{
    bool const flat = dict.getWordOr("view", "slice", {"slice", "space"}, "views") == "slice";
    return flat ? make<ParticlesPlot>(name, dict, pictures) : make<ParticlesSpacePlot>(name, dict, pictures);
}

} // namespace

PlotRegistry plotRegistry()
{
    PlotRegistry registry("plot type", "plot types");
    registry.add("curves", make<CurvesPlot>);
    registry.add("gauges", make<GaugesPlot>);
    registry.add("profiles", make<ProfilesPlot>);
    registry.add("particles", makeParticles);
    registry.add("map", make<MapPlot>);
    registry.add("waterSurface", make<WaterSurfacePlot>);
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

void drawPlots(std::vector<std::unique_ptr<Plot>> const& plots, PostCase const& postCase)
{
    std::vector<ExitCode> codes;
    std::string failed;
    for (auto const& plot : plots)
    {
        info() << plot->name() << '\n' << std::flush;
        try
        {
            plot->draw(postCase);
        }
        catch (CaseError const& error)
        {
            if (plots.size() == 1) throw;
            warn(plot->name() + " is not drawn: " + error.what());
            codes.push_back(error.code());
            failed += (failed.empty() ? "" : ", ") + plot->name();
        }
    }
    if (codes.empty()) return;
    bool const same = std::all_of(codes.begin(), codes.end(), [&](ExitCode code) { return code == codes.front(); });
    throw CaseError(same ? codes.front() : ExitCode::InputOutput,
                    std::to_string(codes.size()) + " of " + std::to_string(plots.size()) + " plots are not drawn: " + failed,
                    "the warnings above say why");
}

} // namespace mpsDem::postGauges
