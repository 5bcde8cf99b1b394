#pragma once

#include <vector>

#include "functionObjects/FunctionObject.h"
#include "functionObjects/SurfaceElevation.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type interfaceHeight;`: free-surface elevation over time above given places.
///
/// | key | meaning | unit | default |
/// | locations | list of points; their height does not matter | m | none |
/// | direction | of elevation | - | against gravity |
/// and the keys of SurfaceElevationControls.
/// Table `height.dat`: Time, eta0, eta1, ... [m]; nan where a column holds no fluid.
class InterfaceHeight : public FunctionObject
{
public:
    InterfaceHeight(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override { table_.printLast(os); }

private:
    std::vector<Vector> locations_;
    SurfaceElevation surface_;
    TableFile table_;
};

} // namespace mpsDem
