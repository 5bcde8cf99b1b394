#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Registry.h"
#include "postGauges/PostCase.h"

namespace mpsDem::postGauges {

/// One entry of `plots`: reads its keys when it is made, files when it is drawn.
class Plot
{
public:
    explicit Plot(std::string name) : name_(std::move(name)) {}
    virtual ~Plot() = default;
    Plot(Plot const&) = delete;
    Plot& operator=(Plot const&) = delete;

    /// Makes the pictures and tables. @throw CaseError
    virtual void draw(PostCase const& postCase) const = 0;

    [[nodiscard]] std::string const& name() const { return name_; }

private:
    std::string name_;
};

/// Arguments: name, its dictionary, the defaults of all pictures.
using PlotRegistry = Registry<Plot, std::string const&, Dictionary const&, PictureSettings const&>;

/// curves, gauges, profiles, particles, convergence, map, waterSurface.
PlotRegistry plotRegistry();

/// Everything in `plots` of system/postGaugesDict, in its order. Refuses what nobody knows.
std::vector<std::unique_ptr<Plot>> readPlots(Dictionary const& dict, PictureSettings const& defaults);

/// Draws all plots. One that fails does not keep the others from being drawn: its message is a warning, and the end is an error that names
/// all that failed. A plot alone fails with its own message.
/// @throw CaseError (InputOutput; where all failures have one code: that)
void drawPlots(std::vector<std::unique_ptr<Plot>> const& plots, PostCase const& postCase);

} // namespace mpsDem::postGauges
