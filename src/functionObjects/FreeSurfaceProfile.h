#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "functionObjects/SurfaceElevation.h"

namespace mpsDem {

/// `type freeSurfaceProfile;`: free-surface elevation along a line at given times.
///
/// | key | meaning | unit | default |
/// | times | times > 0 to write at; steps are shortened to meet them | s | whenever writeControl says |
/// | from, to | ends of the line: x, or (x y z) | m | the fluid's extent in x at that time |
/// | spacing | distance of points along the line, or ... | m | the particles' spacing |
/// | count | ... their number, 2 to 100000 | - | |
/// | direction | of elevation | - | against gravity |
/// and the keys of SurfaceElevationControls.
/// Tables `profile_<time>.dat`: x, eta [m] (3-D: x, y, z of the line, eta); places without fluid are left out.
class FreeSurfaceProfile : public FunctionObject
{
public:
    FreeSurfaceProfile(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const& step) override;
    void write(Step const& step) override;
    void report(std::ostream& os) const override { os << written_; }
    [[nodiscard]] Real wantedTime(Real t) const override;

private:
    void readLine(Dictionary const& dict);
    [[nodiscard]] std::vector<Vector> line() const;
    void writeProfile(Real time);

    RunContext const& context_;
    SurfaceElevationControls controls_;
    SurfaceElevation surface_;
    std::filesystem::path folder_;
    std::vector<Real> times_; ///< Ascending [s].
    std::optional<Vector> from_, to_;
    Real spacing_ = 0;
    int count_ = 0;       ///< 0: from the spacing.
    std::string written_; ///< In this step.
};

} // namespace mpsDem
