#pragma once

#include <vector>

#include "bodies/Load.h"
#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type forces;`: hydrodynamic force and moment on fixed walls and on bodies.
///
/// Walls: \f$\mathbf F=-\sum_i (p_i+\tfrac12\rho\,l_0\,\mathbf g\cdot\mathbf n_i)\,\mathbf n_i\,\Delta A\f$ over wet wall particles, the
/// second term carrying the pressure from the particle to the surface half a spacing in front of it; dA = spacing times thickness
/// (spacing^2 in 3-D). A particle in a corner, whose normal is more than 20 degrees off that of every neighbour on its wall, has no
/// area of its own; in 3-D one with fewer than three neighbours of its direction, as in a row along an edge between two
/// sides. Viscous stress is left out. Bodies: eqs 15-16, as the body felt them in this step.
///
/// | key | meaning | default |
/// | patches | names of fixed surfaces | all, where bodies is absent too |
/// | bodies | names of rigid bodies | none |
/// | CofR | point that moments refer to [m] | (0 0 0) |
/// Tables `force.dat` [N] and `moment.dat` [N m]: total_x .. and, for each name, <name>_x, <name>_y, <name>_z.
class Forces : public FunctionObject
{
public:
    Forces(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override;

    /// On one fixed surface, moment about CofR.
    [[nodiscard]] Load wallLoad(int surface) const;

private:
    void readPatches(Dictionary const& dict);
    void findCorners();
    [[nodiscard]] Load bodyLoad(int body) const;

    RunContext const& context_;
    Vector centre_;
    std::vector<int> patches_, bodies_;
    Field<Real> area_; ///< Of each wall particle of a fixed surface [m2].
    std::vector<TableFile> tables_;
};

} // namespace mpsDem
