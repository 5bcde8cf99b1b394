#include "functionObjects/FieldMinMax.h"

#include <algorithm>
#include <array>

#include "core/Errors.h"
#include "functionObjects/Observed.h"

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
            int best = particles.fluid().first;
            for (int i : particles.fluid())
            {
                Real const gain = sign * (value(field, i) - value(field, best));
                if (gain > 0 || (gain == 0 && particles.id[i] < particles.id[best])) best = i;
            }
            row.insert(row.end(), {value(field, best), static_cast<Real>(particles.id[best])});
            addVector(row, particles.r[best]);
        }
    }
    table_.add(step.time, row);
}

} // namespace mpsDem
