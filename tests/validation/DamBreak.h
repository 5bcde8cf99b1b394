#pragma once

#include <string>

#include "support/Curve.h"
#include "support/RunCase.h"

namespace mpsDem::test {

/// A column of water in the left corner of a dry tank.
struct Column
{
    Real width = 0.6, height = 0.3, tank = 1.61; ///< [m]
    Real spacing = 0.01;                         ///< [m]
    Real offsetX = 0, offsetY = 0;               ///< Of the lattice [spacings].
    Real courant = 0.25;                         ///< maxCo and maxPressureCo.
};

/// Writes the dictionaries for water without viscosity and the standard schemes, and makes the particles.
inline void makeColumn(RunCase& run, Column const& column, Real endTime)
{
    auto const number = [](Real value) { return std::to_string(value); };
    run.write("constant/transportProperties", "nu 0; rho 997;");
    run.write("system/setParticlesDict", "geometry { tank { type searchableBox; min (0 0 0); max (" + number(column.tank) +
                                             " 0.9 0); open (top); } }\nregions ( boxToParticle { box (0 0 0) (" + number(column.width) +
                                             " " + number(column.height) + " 0); } );\nlattice { offset (" + number(column.offsetX) + " " +
                                             number(column.offsetY) + " 0); }");
    run.control(endTime, 2e-3, "maxCo " + number(column.courant) + "; maxPressureCo " + number(column.courant) + ";").make();
}

} // namespace mpsDem::test
