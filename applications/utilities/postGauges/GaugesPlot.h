#pragma once

#include <string>
#include <vector>

#include "postGauges/Axes.h"
#include "postGauges/Curve.h"
#include "postGauges/FreeSurface.h"
#include "postGauges/Particles.h"
#include "postGauges/Plot.h"

namespace mpsDem::postGauges {

/// Keys of the free surface, shared by gauges and profiles:
///
/// | key | meaning | default |
/// |---|---|---|
/// | method | volume or top (see FreeSurface) | volume |
/// | width | width of the column in spacings, 1 to 20 | 2 |
/// | splash | groups of fewer fluid particles are drops, 1 to 1e6 | 20 |
/// | zero | level that counts as eta = 0, along `up` [m] | 0 |
/// | series | particle files in VTK/ | particles |
struct SurfaceKeys
{
    SurfaceSettings settings;
    Real zero = 0;
    std::string series;

    static SurfaceKeys read(Dictionary const& dict);
    /// The settings with spacing, dimensions and direction of the case.
    [[nodiscard]] SurfaceSettings settingsFor(PostCase const& postCase) const;
};

/// eta at each location [m]; NaN where there is no fluid.
std::vector<Real> elevations(ParticleFrame const& frame, std::vector<Vector> const& locations, SurfaceSettings const& settings, Real zero);

/// `type gauges;`: free-surface elevation over time at given places, from particle files. Writes <name>.dat in the form of the solver's
/// interfaceHeight (`# Time eta0 eta1 ...`, nan where a column is dry) and a plot of it.
///
/// Keys: `locations ((x y z) ...)`, those of SurfaceKeys and of Axes, and `references { name {...} }` (CurveSource) drawn with them.
class GaugesPlot : public Plot
{
public:
    GaugesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);
    void draw(PostCase const& postCase) const override;

private:
    void drawPicture(PostCase const& postCase, std::vector<Real> const& times, std::vector<std::vector<Real>> const& eta) const;

    std::vector<Vector> locations_;
    SurfaceKeys surface_;
    Axes axes_;
    std::vector<CurveSource> references_;
    PictureSettings pictures_;
    Location where_;
};

} // namespace mpsDem::postGauges
