#pragma once

#include <memory>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"
#include "particles/CellGrid.h"
#include "particles/Kernel.h"

namespace mpsDem {

/// `type probes;`: pressure, velocity and number density over time at given places.
///
/// \f[ \phi(\mathbf x) = \frac{\sum_j w(|\mathbf r_j - \mathbf x|)\,\phi_j}{\sum_j w(|\mathbf r_j - \mathbf x|)} \f]
/// (Shepard) with the kernel of eq 3 and r_e = 2.1 spacings, over fluid particles and, for p, wet wall particles.
///
/// | key | meaning | default |
/// | probeLocations | list of points [m] | none |
/// | fields | some of p, U, n | (p U) |
/// | hydrostaticCorrection | each p_j is carried to the probe with the weight of the water between: p_j + rho g.(x - r_j) | off |
/// The correction makes a probe on a wall exact in still water; without it the value is that of the particles' mean place.
/// Tables `p.dat` [Pa, relative to the atmosphere], `U.dat` [m/s], `n.dat` [n/n0], `count.dat`: how many particles each value rests on.
/// Without any the value is nan.
class Probes : public FunctionObject
{
public:
    Probes(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override;

private:
    struct Sample
    {
        Real p = 0, n = 0;
        Vector u = Vector::Zero();
        int count = 0; ///< Fluid particles in reach, and wet wall particles where p is asked for.
    };

    [[nodiscard]] Sample sample(Vector const& location) const;

    RunContext const& context_;
    std::vector<Vector> locations_;
    std::vector<std::string> fields_;
    bool hydrostatic_, needsWalls_ = false;
    Kernel kernel_;
    CellGrid grid_;
    std::vector<TableFile> tables_; ///< One a field, then that of the counts.
};

} // namespace mpsDem
