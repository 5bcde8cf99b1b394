#pragma once

#include <vector>

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type fieldMinMax;`: smallest and largest value of fields of the fluid, with particle and place.
///
/// | key | meaning | default |
/// | fields | some of p [Pa], U (its magnitude) [m/s], n [n/n0] | (p U) |
/// Table `fieldMinMax.dat`; for each field: min(f), its particle's id and place, max(f), its particle's id and place. Of equal values that
/// of the smallest id counts.
class FieldMinMax : public FunctionObject
{
public:
    FieldMinMax(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override { table_.printLast(os); }

private:
    [[nodiscard]] Real value(std::string const& field, int i) const;

    RunContext const& context_;
    std::vector<std::string> fields_;
    TableFile table_;
};

} // namespace mpsDem
