#include "postGauges/ParticlesSpacePlot.h"

#include <algorithm>

#include "postGauges/ParticleColours.h"

namespace mpsDem::postGauges {

namespace {

constexpr Colour wallGrey = {0.62F, 0.62F, 0.62F};
constexpr Colour ghostGrey = {0.85F, 0.85F, 0.85F};

} // namespace

ParticlesSpacePlot::ParticlesSpacePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures)
    : SpacePlot(name, dict, pictures, "p"),
      show_(readKinds(dict, {"fluid"})),
      colourWalls_(dict.getOr("colourWalls", false)),
      size_(dict.getInRangeOr("discSize", 1, 0.1, 5))
{}

bool ParticlesSpacePlot::shows(ParticleFrame const& frame, std::size_t i) const
{
    auto const kind = static_cast<ParticleKind>(frame.type[i]);
    char const* const word = kind == ParticleKind::Fluid ? "fluid" : kind == ParticleKind::Ghost ? "ghost" : "wall";
    return std::find(show_.begin(), show_.end(), word) != show_.end() && !isCutAway(frame.data.position[i]);
}

bool ParticlesSpacePlot::hasColour(int type) const
{
    return type == static_cast<int>(ParticleKind::Fluid) || colourWalls_ || field() == "type";
}

std::vector<Real> ParticlesSpacePlot::colouredValues(ParticleFrame const& frame, Scene const&) const
{
    auto const all = frame.field(field(), where());
    std::vector<Real> values;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (shows(frame, i) && hasColour(frame.type[i])) values.push_back(scale() * all[i]);
    return values;
}

void ParticlesSpacePlot::drawFluid(PostCase const&, ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const
{
    auto const values = coloured() ? frame.field(field(), where()) : std::vector<Real>(frame.type.size(), 0.0);
    auto const categories = categorical() ? particleCategories(field()) : std::vector<ParticleCategory>();
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        if (!shows(frame, i)) continue;
        Colour colour = frame.type[i] == static_cast<int>(ParticleKind::Ghost) ? ghostGrey : wallGrey;
        if (hasColour(frame.type[i])) colour = coloured() ? scene.bar.colour(scale() * values[i]) : rgb("#4a8fc7");
        for (ParticleCategory const& category : categories)
            if (hasColour(frame.type[i]) && category.value == static_cast<int>(values[i])) colour = rgb(category.colour);
        image.addSphere(frame.data.position[i], 0.5 * size_ * scene.spacing, colour);
    }
}

} // namespace mpsDem::postGauges
