#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "functionObjects/SurfaceElevation.h"
#include "io/TableFile.h"
#include "particles/CellGrid.h"

namespace mpsDem {

/// `type runUp;`: how high water has climbed on walls.
///
/// A fluid particle within `reach` of a wall particle stands on the wall: with n the normal of its nearest wall particle w and t the
/// steepest way up in the wall's plane, the upper edge of its wetted patch is r - ((r - r_w) . n - l0/2) n + (l0/2) t. Its height above
/// `zero` is the run-up; along the slope that is height / |t . up|. Parts of the wall flatter than 1:50 have none. Drops, as for
/// interfaceHeight, do not count.
///
/// | key | meaning | unit | default | range |
/// | patches | names of fixed surfaces | - | none | |
/// | reach | distance of particles | spacings | 1.5 | 1 to 4 |
/// | steepest | slope of the walls that count; 90: upright ones too, 180: overhanging ones as well | degrees | 90 | 1 to 180 |
/// | axis | along which places are told apart | - | (0 0 1) | |
/// | spacing | width of a place along the axis; 2-D: one place | m | 2 particle spacings | |
/// | zero, splash, direction | as for interfaceHeight | | | |
/// Table `runUp.dat`: height and distance along the slope of the highest water now and its place along the axis, and the same of the
/// highest so far (heightMax, distanceMax, placeMax, timeOfMax); nan where no water touches. Tables `places_<time>.dat`, one row a place:
/// place, height, distance (now), heightMax, distanceMax, timeOfMax.
class RunUp : public FunctionObject
{
public:
    RunUp(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const& step) override;
    void write(Step const& step) override;
    void report(std::ostream& os) const override { table_.printLast(os); }
    void save(State& state) const override;
    void load(State const& state) override;

private:
    /// Water at one place along the axis.
    struct Reached
    {
        Real height = lowest, distance = lowest, time = lowest;
        static constexpr Real lowest = -1e300; ///< Nothing has come here.
    };

    void readWalls(Dictionary const& dict);
    void readPlaces(Dictionary const& dict);
    void look(Real time);
    /// Takes in a fluid particle that is high enough to matter.
    void take(int fluid, Real time);
    [[nodiscard]] std::size_t placeOf(Vector const& r) const;
    [[nodiscard]] Real coordinate(std::size_t place) const { return firstPlace_ + static_cast<Real>(place) * placeSpacing_; }
    void writePlaces(Real time) const;

    RunContext const& context_;
    std::string block_; ///< Of the saved state.
    std::filesystem::path folder_;
    SurfaceElevationControls controls_;
    Vector up_;
    SurfaceElevation surface_; ///< Knows drops.
    Real reach_;               ///< [m]
    Vector axis_;
    std::vector<int> walls_; ///< Wall particles that water can climb.
    CellGrid grid_;          ///< Of these.
    Real firstPlace_ = 0, placeSpacing_ = 1;
    std::vector<Reached> now_, largest_;
    Real lookedAt_; ///< Time at which the state was taken in [s].
    TableFile table_;
};

} // namespace mpsDem
