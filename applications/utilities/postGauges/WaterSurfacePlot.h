#pragma once

#include <string>
#include <vector>

#include "postGauges/SpacePlot.h"

namespace mpsDem::postGauges {

/// `type waterSurface;`: the surface of the water, reconstructed from the particles (io/WaterSurface.h), as a picture with light and shade
/// and as postProcessing/surface/<name>.vtp.series for ParaView, with normals and the arrays elevation [m], U, p.
///
/// | key | meaning | default |
/// |---|---|---|
/// | field | elevation (along -g, less `zero`; plain blue at walls, bodies and cuts), none (water blue), or a field as for `particles`, interpolated | elevation |
/// | zero | level that counts as elevation 0 [m] | 0 |
/// | opacity | of a thin layer of water, 0.05 to 1 | 0.75 |
/// | absorption | of light in water [1/m]; larger hides more of what lies behind | 1 over the height of the scene |
/// | resolution | cells of the grid on a spacing, 1 to 6 | 2 |
/// | smoothing | rounds of smoothing, 0 to 200 | 20 |
/// | drops | particles that leave no surface as small spheres | true |
/// | writeSurface | the files for ParaView | true |
/// and the keys of SpacePlot.
class WaterSurfacePlot : public SpacePlot
{
public:
    WaterSurfacePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);

protected:
    void drawFluid(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const override;
    [[nodiscard]] std::vector<Real> colouredValues(ParticleFrame const& frame, Scene const& scene) const override;

private:
    [[nodiscard]] WaterSurfaceControls controlsFor(Scene const& scene) const;
    /// Values of the fluid's particles, without those of walls.
    [[nodiscard]] std::vector<Real> fluidValues(ParticleFrame const& frame, std::string const& field, Scene const& scene) const;
    /// By elevation on the free surface, plain where the water ends at a wall, a body or a cut.
    [[nodiscard]] std::vector<Colour> elevationColours(ParticleFrame const& frame, Scene const& scene, SurfaceMesh const& mesh) const;
    void drawDrops(ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const;
    void write(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene, SurfaceMesh const& mesh) const;

    Real zero_, opacity_;
    Real absorption_; ///< 0: from the scene.
    Real resolution_;
    int smoothing_;
    bool drops_, writeSurface_;
};

} // namespace mpsDem::postGauges
