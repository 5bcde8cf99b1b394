#include "functionObjects/ClosedVoids.h"

#include <array>
#include <limits>
#include <sstream>

#include "core/Errors.h"
#include "core/Log.h"
#include "functionObjects/Observed.h"

namespace mpsDem {

namespace {

constexpr Real warnParticles = 20; ///< Default of warnVolume.
constexpr int warnLimit = 10;      ///< Lines of each kind in the log.

VoidSearch::Controls readControls(Dictionary const& dict, RunContext const& context)
{
    requireFluid(context, dict);
    VoidSearch::Controls controls = VoidSearch::Controls::defaults(context.particles.lattice().dimensions);
    controls.reach = dict.getInRangeOr("reach", controls.reach, 0.75, 3);
    controls.smallest = dict.getInRangeOr("smallest", controls.smallest, 0, 1e6);
    int const resolution = dict.getOr<int>("resolution", controls.resolution);
    require(resolution >= 2 && resolution <= 8, dict.where("resolution"), "resolution is " + std::to_string(resolution),
            "2 to 8 cells on a spacing");
    controls.resolution = resolution;
    if (!dict.found("openAt")) return controls;
    controls.openAt = dict.get<Vector>("openAt");
    require(controls.openAt->allFinite(), dict.where("openAt"), "openAt is no point", "three finite numbers [m]");
    return controls;
}

std::vector<std::string> columns()
{
    std::vector<std::string> names{"voids", "volume", "largest"};
    addVectorColumns(names, "largest_");
    return names;
}

} // namespace

ClosedVoids::ClosedVoids(std::string const& name, Dictionary const& dict, RunContext const& context)
    : name_(name),
      particles_(context.particles),
      search_(readControls(dict, context)),
      warnVolume_(dict.getInRangeOr("warnVolume", warnParticles * context.particles.lattice().particleVolume(), 0, 1e300)),
      table_(makeTable(context, name, "closedVoids", columns(),
                       {"Empty pockets closed in by fluid: number, volume of all and of the largest [m3], centre of the largest [m]"}))
{}

void ClosedVoids::write(Step const& step)
{
    std::vector<VoidSearch::Void> const& voids = search_.find(particles_);
    Real const none = std::numeric_limits<Real>::quiet_NaN();
    std::array<Real, 6> row{static_cast<Real>(voids.size()), 0, 0, none, none, none};
    for (VoidSearch::Void const& one : voids) row[1] += one.volume;
    VoidSearch::Void const* largest = voids.empty() ? nullptr : &voids.front();
    if (largest)
    {
        row[2] = largest->volume;
        for (int d = 0; d < 3; ++d) row[3 + d] = largest->centre[d];
    }
    table_.add(step.time, row);
    tell(step.time, largest);
}

void ClosedVoids::tell(Real time, VoidSearch::Void const* largest)
{
    Real const volume = largest ? largest->volume : 0;
    bool const appeared = !warned_ && volume > warnVolume_;
    bool const gone = warned_ && volume <= 0.5 * warnVolume_;
    if (!appeared && !gone) return;
    warned_ = appeared;
    std::ostringstream line;
    line << name_ << ": at " << time << " s ";
    if (appeared)
        line << "the fluid has closed in a void of " << volume << " m3 (" << volume / particles_.lattice().particleVolume()
             << " particles) at " << text(largest->centre) << "; there is no air in the model, so nothing but the flow fills it";
    else
        line << "no void larger than " << 0.5 * warnVolume_ << " m3 is left";
    warn(line.str(), name_ + (appeared ? " closed" : " gone"), warnLimit);
}

} // namespace mpsDem
