#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postGauges/Axes.h"
#include "postGauges/Curve.h"
#include "postGauges/Plot.h"

namespace mpsDem::postGauges {

/// `type curves;`: x-y plot of columns of tables; keys of Axes, `curves { name {...} }` (CurveSource), and
///
/// | key of `compare` | meaning | default |
/// |---|---|---|
/// | reference | name of the curve that counts as true | |
/// | curves | names of those compared with it | all others |
/// | from to | part of x that counts | where both have points |
/// | crest | also compare the first crest | true |
/// | crestProminence | height over the trough before it and fall after it that make a crest, in units of y | a tenth of the reference's range |
///
/// Writes <name>.png/.svg, and <name>_errors.dat where asked to compare.
class CurvesPlot : public Plot
{
public:
    CurvesPlot(std::string const& name, Dictionary const& dict, PictureSettings const& pictures);
    void draw(PostCase const& postCase) const override;

private:
    struct Comparison
    {
        std::string reference;
        std::vector<std::string> curves;
        Real from;
        Real to;
        bool crest;
        std::optional<Real> prominence;
        Location where;
    };

    void readComparison(Dictionary const& dict);
    void compare(PostCase const& postCase, std::vector<Curve> const& curves) const;

    Axes axes_;
    std::vector<CurveSource> sources_;
    std::optional<Comparison> comparison_;
    PictureSettings pictures_;
};

} // namespace mpsDem::postGauges
