#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/WaterSurface.h"
#include "postGauges/Camera.h"
#include "postGauges/ColourBar.h"
#include "postGauges/Particles.h"
#include "postGauges/Plot.h"
#include "postGauges/SpaceAxes.h"
#include "postGauges/SpaceImage.h"

namespace mpsDem::postGauges {

/// A picture of space in 3-D, with light and shade, one a time (<name>_t<time>) or all on a sheet; what it shows of the fluid its
/// descendants say. Walls are the surface that wall particles make, of which only what faces the camera is drawn, so that one looks into a
/// tank from any side.
///
/// | key | meaning | default |
/// |---|---|---|
/// | times | [s], the nearest written ones are taken | all |
/// | field | of the colours | as the kind |
/// | range scale label palette | of the colours, as for `particles` | palette viridis |
/// | camera | { }, see CameraControls | |
/// | region | ((x y z) (x y z)) [m], only what lies in it is drawn, water is cut at its sides | all |
/// | clip | { point normal }: what lies beyond is cut away | none |
/// | walls | drawn | true |
/// | bodies | names of bodies drawn | all in VTK/ |
/// | axes | box with numbers | true |
/// | title width maxHeight contactSheet columns frames series | as for `particles` | |
class SpacePlot : public Plot
{
public:
    void draw(PostCase const& postCase) const override;

protected:
    SpacePlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures, std::string const& field);

    /// What holds for all pictures of one call.
    struct Scene
    {
        Real spacing = 0; ///< [m]
        Vector up = Vector::UnitY();
        SpaceBox box;
        ColourBar bar;
        std::vector<std::string> bodies;
        SurfaceMesh walls; ///< Of what never moves, seen from the fluid.
        int decimals = 2;  ///< Of times in file names.
    };

    /// Draws the fluid of one time.
    virtual void drawFluid(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene, SpaceImage& image) const = 0;
    /// Values from which the range of the colours is taken.
    [[nodiscard]] virtual std::vector<Real> colouredValues(ParticleFrame const& frame, Scene const& scene) const = 0;
    [[nodiscard]] std::string const& field() const { return field_; }
    [[nodiscard]] Real scale() const { return scale_; }
    [[nodiscard]] bool coloured() const { return field_ != "none"; }
    /// Planes of `clip` and of the sides of `region`.
    [[nodiscard]] std::vector<CutPlane> const& cuts() const { return cuts_; }
    [[nodiscard]] Location const& where() const { return where_; }
    /// Whether the place lies beyond one of the cuts, by more than `margin` [m].
    [[nodiscard]] bool isCutAway(Vector const& r, Real margin = 0) const;
    [[nodiscard]] bool categorical() const { return field_ == "type" || field_ == "surface"; }

private:
    void readView(Dictionary const& dict);
    /// Particles of the region and, so that its water is cut and does not end there, of a rim around it.
    [[nodiscard]] ParticleFrame frameOf(Series const& series, std::size_t i, Scene const& scene) const;
    [[nodiscard]] Scene sceneOf(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen) const;
    void findWalls(Series const& series, Scene& scene) const;
    void growBox(PostCase const& postCase, ParticleFrame const& frame, Scene& scene) const;
    void drawSheet(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen, Scene const& scene,
                   std::string const& fileName) const;
    void drawBodies(PostCase const& postCase, Real time, Scene const& scene, SpaceImage& image) const;
    /// Items of the plot command that make the colour bar or the legend.
    [[nodiscard]] std::string explanation() const;
    void writePanel(std::ostream& script, SheetLayout const& sheet, std::size_t panel, std::size_t panels, Scene const& scene,
                    Real time) const;

    std::vector<Real> times_;
    std::string field_;
    std::optional<std::pair<Real, Real>> range_;
    Real scale_ = 1;
    std::string label_, palette_;
    bool fromZero_ = false;
    CameraControls camera_;
    std::optional<SpaceBox> region_;
    std::vector<CutPlane> cuts_;
    bool walls_ = true, axes_ = true;
    std::optional<std::vector<std::string>> bodies_;
    std::string title_;
    int width_ = 1200, maxHeight_ = 1600;
    bool contactSheet_ = false, frames_ = false;
    int columns_ = 0;
    std::string series_;
    PictureSettings pictures_;
    Location where_;
};

} // namespace mpsDem::postGauges
