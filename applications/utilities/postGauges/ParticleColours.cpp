#include "postGauges/ParticleColours.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

/// Evenly spaced support points of each map.
std::map<std::string, std::vector<std::string>> const& palettes()
{
    static std::map<std::string, std::vector<std::string>> const maps = {
        {"viridis", {"#440154", "#472c7a", "#3b518b", "#2c718e", "#21908d", "#27ad81", "#5cc863", "#aadc32", "#fde725"}},
        {"plasma", {"#0d0887", "#47039f", "#7301a8", "#9c179e", "#bd3786", "#d8576b", "#ed7953", "#fa9e3b", "#fdc926", "#f0f921"}},
        {"cividis", {"#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838"}},
        {"coolWarm", {"#3b4cc0", "#6788ee", "#9abbff", "#c9d7f0", "#dddddd", "#f2cbb7", "#f7a889", "#e26952", "#b40426"}},
        {"water", {"#08306b", "#0d4d8f", "#1b6cb0", "#3a8cc4", "#64aad5", "#93c6e3", "#bedcee", "#e3f1f8"}},
        {"grey", {"#202020", "#f0f0f0"}}};
    return maps;
}

} // namespace

std::vector<std::string> paletteNames()
{
    std::vector<std::string> names;
    for (auto const& [name, colours] : palettes()) names.push_back(name);
    return names;
}

std::string paletteCommand(std::string const& name)
{
    std::string command = "set palette defined (";
    int place = 0;
    for (std::string const& colour : palettes().at(name))
        command += (place > 0 ? ", " : "") + std::to_string(place) + " '" + colour + "'", ++place;
    return command + ")\n";
}

std::array<float, 3> rgb(std::string const& colour)
{
    std::array<float, 3> values{};
    for (std::size_t c = 0; c < 3; ++c) values[c] = static_cast<float>(std::stoi(colour.substr(1 + 2 * c, 2), nullptr, 16)) / 255.0F;
    return values;
}

std::array<float, 3> paletteColour(std::string const& name, double share)
{
    auto const& colours = palettes().at(name);
    double const place = std::clamp(share, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
    auto const first = std::min(static_cast<std::size_t>(place), colours.size() - 2);
    auto const a = rgb(colours[first]), b = rgb(colours[first + 1]);
    auto const part = static_cast<float>(place - static_cast<double>(first));
    return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

std::string fieldLabel(std::string const& field)
{
    static std::map<std::string, std::string> const labels = {
        {"p", "p [Pa]"},     {"magU", "|U| [m/s]"}, {"Ux", "U_x [m/s]"},           {"Uy", "U_y [m/s]"},
        {"Uz", "U_z [m/s]"}, {"n", "n / n_0 [-]"},  {"elevation", "elevation [m]"}};
    auto const found = labels.find(field);
    return found == labels.end() ? plain(field) : found->second;
}

std::vector<ParticleCategory> particleCategories(std::string const& field)
{
    if (field == "type")
        return {{3, "ghost rows behind", "#c4c4c4"},
                {0, "fluid", "#9ecae9"},
                {2, "boundary, dry: ghost", "#222222"},
                {1, "boundary, wet: has pressure", "#d55e00"}};
    return {{0, "interior", "#9ecae9"}, {2, "near the surface", "#009e73"}, {1, "free surface", "#d55e00"}};
}

} // namespace mpsDem::postGauges
