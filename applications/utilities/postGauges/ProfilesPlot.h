#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "postGauges/GaugesPlot.h"

namespace mpsDem::postGauges {

/// `type profiles;`: the free surface along a line at given times. Writes <name>_t<time>.dat (`# x eta`) for each time and one picture.
///
/// | key | meaning | default |
/// |---|---|---|
/// | times | [s], the nearest written ones are taken | all |
/// | from to | ends of the line (x y z) [m] | extent of the fluid in x |
/// | spacing | distance of the points [m] | the particle spacing |
/// | axis | abscissa: x y z, or distance from `from` | x |
/// | layout | panels: one below the other; overlay: in one | panels |
/// | bodies | names of bodies drawn with it | () |
/// | references | { name { time ...; CurveSource } } drawn at that time | |
/// and the keys of SurfaceKeys and of Axes (`size` is that of one panel).
class ProfilesPlot : public Plot
{
public:
    ProfilesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);
    void draw(PostCase const& postCase) const override;

private:
    /// What one time gave.
    struct Profile
    {
        Real time = 0;
        std::vector<Curve> curves; ///< The computed one first.
    };

    void readReferences(Dictionary const& dict);
    [[nodiscard]] std::vector<Vector> line(ParticleFrame const& frame, PostCase const& postCase) const;
    [[nodiscard]] Real abscissa(Vector const& place, Vector const& start) const;
    [[nodiscard]] std::vector<Profile> profiles(PostCase const& postCase) const;
    /// Decimals by which the times differ, at least two.
    [[nodiscard]] static int decimalsOf(std::vector<Profile> const& all);
    void addReferences(PostCase const& postCase, std::vector<Profile>& all) const;
    [[nodiscard]] std::vector<std::string> bodyItems(PostCase const& postCase, Real time, Picture& picture) const;
    void drawPanels(PostCase const& postCase, std::vector<Profile> const& all) const;
    void drawOverlay(PostCase const& postCase, std::vector<Profile> const& all) const;

    std::vector<Real> times_;
    std::optional<Vector> from_;
    std::optional<Vector> to_;
    Real distance_ = 0;
    std::string axis_;
    bool panels_ = true;
    std::vector<std::string> bodies_;
    std::vector<std::pair<Real, CurveSource>> references_;
    SurfaceKeys surface_;
    Axes axes_;
    PictureSettings pictures_;
    Location where_;
};

} // namespace mpsDem::postGauges
