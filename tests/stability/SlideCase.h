#pragma once

#include <cmath>
#include <string>

#include "support/RunCase.h"

namespace mpsDem::test {

/// A slope of 45 degrees down to x = 1 m, a floor to x = 2.2 m, and a wedge of 0.5 m with the long side on the slope, 2036 kg/m3.
struct SlideCase
{
    Real top;           ///< Height of its upper side [m].
    Real water;         ///< Depth [m].
    Real gap = 0;       ///< Between its long side and the slope [m].
    Real speed = 0;     ///< Down the slope [m/s].
    std::string stop{}; ///< Entry of `stoppers` in contactProperties; the plane of `stopAt` is added.
    Real stopAt = 0.05; ///< Height of the lower edge at the stop [m].
};

/// Writes geometry, water, slide, contact and strong coupling.
inline void writeSlide(RunCase& run, SlideCase const& slide)
{
    std::string const depth = std::to_string(slide.water);
    run.write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.6 1.6 0) (1 0 0) (2.2 0 0) (2.2 1.6 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.6 0 0) (2.2 " +
                                             depth + " 0); } );\nhydrostatic { surface " + depth + "; }");
    Real const off = slide.gap / std::sqrt(2.0), v = slide.speed / std::sqrt(2.0);
    auto const point = [&](Real x, Real y) { return "(" + std::to_string(x + off) + " " + std::to_string(y + off) + " 0)"; };
    run.write("constant/rigidBodyProperties", "bodies { slide { shape { type polygon; points (" + point(1 - slide.top, slide.top) +
                                                  point(1.5 - slide.top, slide.top - 0.5) + point(1.5 - slide.top, slide.top) +
                                                  "); } density 2036; velocity (" + std::to_string(v) + " " + std::to_string(-v) +
                                                  " 0); } }");
    std::string const foot = slide.stop.empty()
                                 ? ""
                                 : "stoppers { foot { " + slide.stop + " body slide; point (" + std::to_string(1 - slide.stopAt) + " " +
                                       std::to_string(slide.stopAt) + " 0); normal (-0.70710678 0.70710678 0); } }";
    run.write("constant/contactProperties", "mu 0.0105; " + foot);
    run.write("system/mpsSolution", "coupling { type strong; }");
}

} // namespace mpsDem::test
