#include "functionObjects/FieldMinMax.h"

#include <algorithm>
#include <array>

#include "core/Errors.h"
#include "functionObjects/Observed.h"
#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

std::array<std::string, 3> const knownFields{"p", "U", "n"};

std::vector<std::string> readFields(Dictionary const& dict)
{
    auto const fields = dict.getOr<std::vector<std::string>>("fields", {"p", "U"});
    require(!fields.empty(), dict.where("fields"), "fields is an empty list", "some of p, U, n");
    for (std::string const& field : fields)
        require(std::find(knownFields.begin(), knownFields.end(), field) != knownFields.end(), dict.where("fields"),
                "there is no field \"" + field + "\"", knownWords("fields", field, knownFields));
    return fields;
}

std::vector<std::string> columnsFor(std::vector<std::string> const& fields)
{
    std::vector<std::string> columns;
    for (std::string const& field : fields)
    {
        for (std::string const which : {"min", "max"})
        {
            std::string const name = which + "(" + field + ")";
            columns.insert(columns.end(), {name, name + "_id"});
            addVectorColumns(columns, name + "_");
        }
    }
    return columns;
}

} // namespace

FieldMinMax::FieldMinMax(std::string const& name, Dictionary const& dict, RunContext const& context)
    : context_(context),
      fields_(readFields(dict)),
      table_(makeTable(context, name, "fieldMinMax", columnsFor(fields_),
                       {"Extremes over the fluid: p [Pa], magnitude of U [m/s], n [-]; particle id and place [m]"}))
{
    requireFluid(context, dict);
}

Real FieldMinMax::value(std::string const& field, int i) const
{
    ParticleSet const& particles = context_.particles;
    return field == "p" ? particles.p[i] : field == "U" ? particles.u[i].norm() : particles.n[i];
}

void FieldMinMax::write(Step const& step)
{
    ParticleSet const& particles = context_.particles;
    std::vector<Real> row;
    for (std::string const& field : fields_)
    {
        for (Real const sign : {-1.0, 1.0})
        {
            Place best;
            for (int i : particles.fluid()) best = largerOf(best, {sign * value(field, i), particles.id[i], particles.r[i]});
            best = maxOverRanks(best);
            row.insert(row.end(), {sign * best.value, static_cast<Real>(best.id)});
            addVector(row, best.position);
        }
    }
    table_.add(step.time, row);
}

} // namespace mpsDem
