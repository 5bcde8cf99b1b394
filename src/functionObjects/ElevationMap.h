#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "functionObjects/SurfaceElevation.h"

namespace mpsDem {

/// `type elevationMap;`: where and when a wave was how high, over a level grid of places.
///
/// | key | meaning | unit | default |
/// | from, to | opposite corners of the grid; their height does not matter | m | none |
/// | spacing | distance of places along either side | m | 2 particle spacings |
/// | threshold | elevation at which the wave has arrived | m | 1 particle spacing |
/// | direction | of elevation | - | against gravity |
/// and the keys of SurfaceElevationControls.
/// `execute` takes in the state: largest elevation, its time, and the first time at which the elevation is `threshold` or more.
/// Tables `map_<time>.dat`: x y z of the place, eta (now), etaMax [m], timeOfMax, arrival [s]; nan where there was no fluid or no wave; an
/// empty line after each row of places.
class ElevationMap : public FunctionObject
{
public:
    ElevationMap(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const& step) override;
    void write(Step const& step) override;
    void report(std::ostream& os) const override { os << written_; }
    void save(State& state) const override;
    void load(State const& state) override;

private:
    void readGrid(Dictionary const& dict, Vector const& up);
    void look(Real time);

    std::string block_; ///< Of the saved state.
    std::filesystem::path folder_;
    SurfaceElevationControls controls_;
    SurfaceElevation surface_;
    Real threshold_;
    Real particleSpacing_;
    int perRow_ = 0;
    std::vector<Vector> places_; ///< Row by row.
    std::vector<Real> now_, largest_, timeOfLargest_, arrival_;
    Real lookedAt_; ///< Time at which the state was taken in [s].
    std::string written_;
};

} // namespace mpsDem
