#pragma once

#include "functionObjects/FunctionObject.h"
#include "functionObjects/VoidSearch.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type closedVoids;`: empty pockets that the fluid closes in (VoidSearch). There is no air in the model: such a pocket is a vacuum
/// at atmospheric pressure, where a real one would hold air and push back.
///
/// | key        | meaning                                                      | unit             | default         | range     |
/// | warnVolume | the log tells when the largest void grows beyond this, and   | m3               | 20 particles    | >= 0      |
/// |            | when it is below half of this again                          |                  |                 |           |
/// | openAt     | point in open air of a closed box                            | m                | none            |           |
/// | smallest   | smaller voids do not count                                   | particle volumes | 1.5             | 0 to 1e6  |
/// | reach      | what lies as near to a particle is no air                    | spacings         | 0.9; in 3-D 1   | 0.75 to 3 |
/// | resolution | cells of the grid on a spacing                               | -                | 4; in 3-D 2     | 2 to 8    |
/// Table `closedVoids.dat`: number, total volume, volume of the largest [m3] and its centre [m], nan where there is none.
class ClosedVoids : public FunctionObject
{
public:
    ClosedVoids(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;

private:
    void tell(Real time, VoidSearch::Void const* largest);

    std::string name_;
    ParticleSet const& particles_;
    VoidSearch search_;
    Real warnVolume_; ///< [m3]
    bool warned_ = false;
    TableFile table_;
};

} // namespace mpsDem
