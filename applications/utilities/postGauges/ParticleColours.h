#pragma once

#include <array>
#include <string>
#include <vector>

namespace mpsDem::postGauges {

/// Names of the colour maps.
std::vector<std::string> paletteNames();

/// gnuplot's `set palette` command for one of them. viridis, plasma and cividis change evenly to the eye; coolWarm has a neutral middle,
/// for values of both signs; water goes from deep blue to foam.
std::string paletteCommand(std::string const& name);

/// Colour at a share of one of them, 0 (first) to 1 (last; beyond: the ends): red, green, blue from 0 to 1.
std::array<float, 3> paletteColour(std::string const& name, double share);

/// Red, green, blue from 0 to 1 of "#rrggbb".
std::array<float, 3> rgb(std::string const& colour);

/// Text at the colour bar for a known field ("p [Pa]"), else the field's name.
std::string fieldLabel(std::string const& field);

/// Values, words and colours of the fields `type` and `surface`.
struct ParticleCategory
{
    int value;
    std::string label;
    std::string colour;
};
std::vector<ParticleCategory> particleCategories(std::string const& field);

} // namespace mpsDem::postGauges
