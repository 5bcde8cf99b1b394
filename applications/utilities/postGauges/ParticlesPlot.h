#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "postGauges/ColourBar.h"
#include "postGauges/Particles.h"
#include "postGauges/Plot.h"
#include "postGauges/SheetLayout.h"
#include "postGauges/Slice.h"

namespace mpsDem::postGauges {

/// `type particles;`: flat pictures of the particles, in 3-D of those in a slice, one a time (<name>_t<time>) or all in one (<name>, `contactSheet`).
///
/// | key | meaning | default |
/// |---|---|---|
/// | times | [s], the nearest written ones are taken | all |
/// | field | p, magU, Ux, Uy, type, n, surface, or another array | p |
/// | range | (low high) of the colours; left out: from all pictures' values but the outermost 0.2 %, with coolWarm even about 0 | |
/// | window | ((xMin yMin 0) (xMax yMax 0)) [m] | all that is shown at the first time |
/// | slice | what is shown of a 3-D case, see Slice | the middle, seen along -z |
/// | show | of fluid, wall, ghost | (fluid wall), with field type all |
/// | colourWalls | walls in the colours of the field, else grey | false |
/// | bodies | names of bodies whose outline is drawn | all in VTK/ |
/// | bodyStyle | outline, filled or none | outline |
/// | palette | viridis plasma cividis coolWarm grey | viridis |
/// | label scale | text at the colour bar; factor on the values | the field's; 1 |
/// | discSize | diameter of a disc in spacings, 0.1 to 5 | 1.42, no gaps in a square lattice; for type and surface 1 |
/// | title | text before the time; above a sheet | "" |
/// | width maxHeight | of the picture [pixels] | 1200 1600 |
/// | contactSheet | all times in one picture | false |
/// | frames | one picture a time with names <name>_0000, <name>_0001 ..., for a film | false |
/// | columns | of the sheet; 0: chosen | 0 |
/// | series | particle files in VTK/ | particles |
/// and those of PictureSettings; `formats` is (png) here unless the plot itself says otherwise.
class ParticlesPlot : public Plot
{
public:
    ParticlesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);
    void draw(PostCase const& postCase) const override;

private:
    /// What holds for all pictures of one call.
    struct Scene
    {
        Slice slice;
        Window window;
        ColourBar bar;
        Real spacing = 0;
        std::vector<std::string> bodies;
        int decimals = 2; ///< Of times in file names.
    };

    void readLook(Dictionary const& dict);
    void readView(Dictionary const& dict);
    [[nodiscard]] bool categorical() const { return field_ == "type" || field_ == "surface"; }
    [[nodiscard]] bool shows(ParticleFrame const& frame, std::size_t i) const;
    [[nodiscard]] bool coloured(int type) const;
    [[nodiscard]] Scene sceneOf(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen) const;
    [[nodiscard]] Window windowOf(ParticleFrame const& frame, Scene const& scene) const;
    void setRange(Series const& series, std::vector<std::size_t> const& chosen, Scene& scene) const;
    void drawSheet(PostCase const& postCase, Series const& series, std::vector<std::size_t> const& chosen, Scene const& scene,
                   std::string const& fileName) const;
    void writeColours(std::ostream& script, SheetLayout const& sheet, Scene const& scene) const;
    void writePanel(std::ostream& script, SheetLayout const& sheet, std::size_t panel, std::size_t panels, Scene const& scene,
                    Real time) const;
    [[nodiscard]] std::vector<std::string> items(PostCase const& postCase, ParticleFrame const& frame, Scene const& scene,
                                                 SheetLayout const& sheet, bool legend, Picture& picture) const;
    [[nodiscard]] std::vector<std::string> colouredItems(ParticleFrame const& frame, Scene const& scene, SheetLayout const& sheet,
                                                         bool legend, Picture& picture) const;

    std::vector<Real> times_;
    std::string field_;
    std::optional<std::pair<Real, Real>> range_;
    std::optional<Window> window_;
    Slice slice_;
    bool showFluid_ = false;
    bool showWall_ = false;
    bool showGhost_ = false;
    bool colourWalls_ = false;
    std::optional<std::vector<std::string>> bodies_;
    std::string bodyStyle_;
    std::string palette_;
    std::string label_;
    Real scale_ = 1;
    Real discSize_ = 1;
    std::string title_;
    int width_ = 1200;
    int maxHeight_ = 1600;
    bool contactSheet_ = false;
    bool frames_ = false;
    int columns_ = 0;
    std::string series_;
    PictureSettings pictures_;
    Location where_;
};

} // namespace mpsDem::postGauges
