#pragma once

#include <string>
#include <vector>

#include "postGauges/SpacePlot.h"

namespace mpsDem::postGauges {

/// `type particles; view space;`: particles of a 3-D case as spheres with light and shade.
///
/// | key | meaning | default |
/// |---|---|---|
/// | field | as for the flat pictures; of type and surface the colours are named beside the picture | p |
/// | show | of fluid, wall, ghost | (fluid) |
/// | colourWalls | walls in the colours of the field, else grey | false |
/// | discSize | diameter of a sphere in spacings, 0.1 to 5 | 1 |
/// and the keys of SpacePlot.
class ParticlesSpacePlot : public SpacePlot
{
public:
    ParticlesSpacePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);

protected:
    void drawFluid(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const override;
    [[nodiscard]] std::vector<Real> colouredValues(ParticleFrame const& frame, Scene const& scene) const override;

private:
    [[nodiscard]] bool shows(ParticleFrame const& frame, std::size_t i) const;
    [[nodiscard]] bool hasColour(int type) const;

    std::vector<std::string> show_;
    bool colourWalls_;
    Real size_;
};

} // namespace mpsDem::postGauges
