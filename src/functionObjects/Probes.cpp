#include "functionObjects/Probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/Errors.h"
#include "functionObjects/Observed.h"

namespace mpsDem {

namespace {

std::array<std::string, 3> const knownFields{"p", "U", "n"};

std::vector<std::string> headerOf(std::string const& field, std::vector<Vector> const& locations)
{
    std::string const what = field == "p"   ? "Pressure relative to the atmosphere [Pa]; nan without particles in reach, see count.dat"
                             : field == "U" ? "Velocity [m/s]; nan without particles in reach, see count.dat"
                             : field == "n"
                                 ? "Number density over that of the full lattice [-]; nan without particles in reach, see count.dat"
                                 : "Particles that the values of the other tables rest on";
    std::vector<std::string> header{what};
    for (std::size_t k = 0; k < locations.size(); ++k) header.push_back("Probe " + std::to_string(k) + " " + text(locations[k]));
    return header;
}

std::vector<std::string> columnsOf(std::string const& field, std::size_t count)
{
    std::vector<std::string> columns;
    for (std::size_t k = 0; k < count; ++k)
    {
        if (field == "U")
            addVectorColumns(columns, "U" + std::to_string(k));
        else
            columns.push_back(field + std::to_string(k));
    }
    return columns;
}

} // namespace

Probes::Probes(std::string const& name, Dictionary const& dict, RunContext const& context)
    : context_(context),
      locations_(placesOf(context, dict, "probeLocations", dict.get<std::vector<Vector>>("probeLocations"))),
      fields_(dict.getOr<std::vector<std::string>>("fields", {"p", "U"})),
      hydrostatic_(dict.getOr<bool>("hydrostaticCorrection", false)),
      kernel_{2.1 * context.particles.lattice().spacing}
{
    requireFluid(context, dict);
    require(!locations_.empty(), dict.where("probeLocations"), "probeLocations is an empty list", "at least one point (x y z)");
    require(!fields_.empty(), dict.where("fields"), "fields is an empty list", "some of p, U, n");
    for (std::size_t k = 0; k < fields_.size(); ++k)
    {
        bool const known = std::find(knownFields.begin(), knownFields.end(), fields_[k]) != knownFields.end();
        require(known, dict.where("fields"), "there is no field \"" + fields_[k] + "\"", knownWords("fields", fields_[k], knownFields));
        bool const twice = std::count(fields_.begin(), fields_.end(), fields_[k]) > 1;
        require(!twice, dict.where("fields"), "field \"" + fields_[k] + "\" is given twice", "each field once");
        needsWalls_ = needsWalls_ || fields_[k] == "p";
    }
    warnOfPlacesOutside(context, dict, "probeLocations", locations_, Vector::Zero());
    for (std::string const& field : fields_)
        tables_.push_back(makeTable(context, name, field, columnsOf(field, locations_.size()), headerOf(field, locations_)));
    tables_.push_back(makeTable(context, name, "count", columnsOf("count", locations_.size()), headerOf("count", locations_)));
}

Probes::Sample Probes::sample(Vector const& location) const
{
    ParticleSet const& particles = context_.particles;
    Sample result;
    Real fluidSum = 0, pressureSum = 0;
    grid_.forEachWithin(location, kernel_.re, [&](int j, Vector const& rij, Real r2) {
        bool const isFluid = particles.isFluid(j);
        bool const wetWall = particles.wall().contains(j) && particles.wet[j] != 0;
        if (!isFluid && !(wetWall && needsWalls_)) return;
        Real const w = kernel_(std::sqrt(r2));
        ++result.count;
        pressureSum += w;
        result.p += w * (particles.p[j] - (hydrostatic_ ? context_.density * context_.gravity.dot(rij) : 0));
        if (!isFluid) return;
        fluidSum += w;
        result.u += w * particles.u[j];
        result.n += w * particles.n[j];
    });
    constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
    result.p = pressureSum > tiny ? result.p / pressureSum : none;
    result.u = fluidSum > tiny ? Vector(result.u / fluidSum) : Vector::Constant(none);
    result.n = fluidSum > tiny ? result.n / fluidSum : none;
    return result;
}

void Probes::write(Step const& step)
{
    ParticleSet const& particles = context_.particles;
    auto const owned = static_cast<std::size_t>(particles.owned().size());
    grid_.build(std::span<Vector const>(particles.r.data(), owned), kernel_.re, particles.lattice().dimensions);
    std::vector<std::vector<Real>> rows(tables_.size());
    for (Vector const& location : locations_)
    {
        Sample const s = sample(location);
        for (std::size_t f = 0; f < fields_.size(); ++f)
        {
            if (fields_[f] == "U")
                addVector(rows[f], s.u);
            else
                rows[f].push_back(fields_[f] == "p" ? s.p : s.n);
        }
        rows.back().push_back(s.count);
    }
    for (std::size_t f = 0; f < tables_.size(); ++f) tables_[f].add(step.time, rows[f]);
}

void Probes::report(std::ostream& os) const
{
    for (std::size_t f = 0; f + 1 < tables_.size(); ++f) // the last is that of the counts
    {
        if (f > 0) os << ", ";
        tables_[f].printLast(os);
    }
}

} // namespace mpsDem
