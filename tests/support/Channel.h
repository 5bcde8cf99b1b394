#pragma once

#include <string>

#include "support/RunCase.h"

namespace mpsDem::test {

/// Writes a periodic channel 1 m high and 0.5 m long between two plates, full of a fluid of 0.1 m2/s that a body force drives: Reynolds
/// number 10 with the mean speed. @param viscosity  What `viscositySchemes` says beside `walls noSlip`.
inline void writeChannel(RunCase& run, std::string const& viscosity = {})
{
    run.gravity(Vector(1.2, 0, 0));
    run.write("constant/transportProperties", "nu 0.1; rho 1000;");
    run.write("system/setParticlesDict", "geometry { below { type searchablePlate; origin (0 0 0); span (0.5 0 0); }\n"
                                         " above { type searchablePlate; origin (0.5 1 0); span (-0.5 0 0); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.5 1 0); } );\nhydrostatic { active no; }");
    run.write("system/mpsSchemes", "freeSurfaceSchemes { type none; } cyclic { min (0 0 0); max (0.5 0 0); }\n"
                                   "viscositySchemes { walls noSlip; " +
                                       viscosity + "}");
}

} // namespace mpsDem::test
