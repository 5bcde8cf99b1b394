#include "functionObjects/Forces.h"

#include <algorithm>
#include <span>

#include "core/Errors.h"
#include "functionObjects/Observed.h"
#include "particles/CellGrid.h"

namespace mpsDem {

namespace {

constexpr Real alike = 0.94;       ///< Cosine of 20 degrees: rows of wall particles run through bends up to this.
constexpr Real neighbouring = 1.5; ///< Spacings.

} // namespace

Forces::Forces(std::string const& name, Dictionary const& dict, RunContext const& context)
    : context_(context),
      centre_(dict.getOr<Vector>("CofR", Vector::Zero()))
{
    requireFluid(context, dict);
    if (dict.found("bodies")) bodies_ = readBodies(context, dict);
    readPatches(dict);
    findCorners();
    std::vector<std::string> columns;
    addVectorColumns(columns, "total_");
    for (int k : patches_) addVectorColumns(columns, context.wallNames[k] + "_");
    for (int k : bodies_) addVectorColumns(columns, context.bodies[k]->name() + "_");
    tables_.push_back(makeTable(context, name, "force", columns, {"Force of the fluid's pressure [N]"}));
    tables_.push_back(makeTable(context, name, "moment", columns, {"Moment of the fluid's pressure about " + text(centre_) + " [N m]"}));
}

void Forces::readPatches(Dictionary const& dict)
{
    std::vector<std::string> const& known = context_.wallNames;
    auto const names = dict.getOr<std::vector<std::string>>("patches", bodies_.empty() ? known : std::vector<std::string>());
    for (std::string const& name : names)
    {
        auto const found = std::find(known.begin(), known.end(), name);
        require(found != known.end(), dict.where("patches"), "there is no fixed surface \"" + name + "\" (rigid bodies go to `bodies`)",
                knownWords("surfaces", name, known));
        patches_.push_back(static_cast<int>(found - known.begin()));
    }
    require(!patches_.empty() || !bodies_.empty(), dict.where(), "there is nothing to find the forces on", "patches (...) or bodies (...)");
}

void Forces::findCorners()
{
    ParticleSet const& particles = context_.particles;
    Lattice const& lattice = particles.lattice();
    auto const walls = static_cast<std::size_t>(particles.wall().size());
    int const needed = lattice.dimensions == 2 ? 1 : 3; // the row along an edge between two sides has two
    CellGrid grid;
    grid.build(std::span<Vector const>(particles.r.data(), walls), neighbouring * lattice.spacing, lattice.dimensions);
    area_.assign(walls, 0);
    for (int i : particles.wall())
    {
        if (context_.wallOf[i] < 0) continue;
        int like = 0;
        grid.forEachWithin(particles.r[i], neighbouring * lattice.spacing, [&](int j, Vector const&, Real) {
            bool const same = j != i && context_.wallOf[j] == context_.wallOf[i];
            like += same && particles.normal[i].dot(particles.normal[j]) > alike ? 1 : 0;
        });
        if (like >= needed) area_[i] = lattice.particleVolume() / lattice.spacing;
    }
}

Load Forces::wallLoad(int surface) const
{
    ParticleSet const& particles = context_.particles;
    Real const half = 0.5 * particles.lattice().spacing;
    Load load;
    for (int i : particles.wall())
    {
        if (context_.wallOf[i] != surface || particles.wet[i] == 0) continue;
        Vector const& n = particles.normal[i];
        Real const p = particles.p[i] + context_.density * half * context_.gravity.dot(n);
        load.add(-p * area_[i] * n, particles.r[i] + half * n - centre_);
    }
    return load;
}

Load Forces::bodyLoad(int body) const
{
    RigidBody const& b = *context_.bodies[body];
    Load load = b.fluid;
    load.moment += (b.centre() - centre_).cross(b.fluid.force);
    return load;
}

void Forces::write(Step const& step)
{
    std::vector<Load> loads{Load()};
    for (int k : patches_) loads.push_back(wallLoad(k));
    for (int k : bodies_) loads.push_back(bodyLoad(k));
    for (std::size_t k = 1; k < loads.size(); ++k) loads.front() += loads[k];
    std::vector<Real> forces, moments;
    for (Load const& load : loads)
    {
        addVector(forces, load.force);
        addVector(moments, load.moment);
    }
    tables_[0].add(step.time, forces);
    tables_[1].add(step.time, moments);
}

void Forces::report(std::ostream& os) const
{
    os << "force ";
    tables_[0].printLast(os);
    os << "; moment ";
    tables_[1].printLast(os);
}

} // namespace mpsDem
