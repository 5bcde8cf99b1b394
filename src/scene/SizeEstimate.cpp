#include "scene/SizeEstimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundaries/BoundaryRows.h"
#include "core/Errors.h"
#include "core/Log.h"

namespace mpsDem {

namespace {

constexpr int samplesAside2D = 128;
constexpr int samplesAside3D = 32;
constexpr Real likelySlip = 1000; ///< Extent of a surface in spacings from which on its file may be in millimetres.
/// Bytes a particle beside the program itself (etc/doc/errors.md): 470 to 510 measured; 1270 to 1740, output included.
constexpr Real toSet = 550, toRun = 1800;
constexpr Real mostNumbers = 2e9; ///< Particles are numbered by 32 bits.

std::string rounded(Real number) { return shortNumber(number, 3); }

std::string inGigabytes(Real bytes) { return rounded(bytes / 1e9) + " GB"; }

/// Length of a line times the thickness it stands for, area of triangles [m2].
Real areaOf(Surface const& surface, Lattice const& lattice)
{
    if (!surface.flat()) return surface.triangles().area();
    Real length = 0;
    for (auto const& segment : surface.line().segments()) length += segment.length;
    return length * lattice.thickness;
}

Real particlesOf(WallDefinition const& wall, Lattice const& lattice)
{
    Real const layer = lattice.particleVolume() / lattice.spacing; // area that a particle of a row stands for
    return areaOf(wall.surface, lattice) / layer * (1 + wall.ghostRows);
}

/// Of a ring within a shape all of whose sides touch one circle (sphere) of radius d V / A: triangle, square, disc.
Real particlesOf(BodyShape const& shape, SceneDefinition const& definition)
{
    Lattice const& lattice = definition.lattice;
    Real const width = (1 + ghostRowsFor(definition.kernelRadius)) * lattice.spacing;
    Real const d = lattice.dimensions, volume = shape.properties.volume, radius = d * volume / areaOf(shape.outline, lattice);
    Real const core = std::max(Real(0), 1 - width / radius);
    return volume * (1 - std::pow(core, d)) / lattice.particleVolume();
}

struct Box
{
    Vector low, high;

    Box(SurfaceTree const& walls, Real margin) : low(walls.low().array() - margin), high(walls.high().array() + margin) {}
    [[nodiscard]] bool holds(Vector const& r) const { return (r.array() >= low.array()).all() && (r.array() <= high.array()).all(); }
};

} // namespace

RegionVolume sampleRegions(std::vector<std::unique_ptr<Region>> const& regions, SurfaceTree const& walls, Lattice const& lattice)
{
    RegionVolume volume;
    Box const box(walls, lattice.spacing);
    bool const deep = lattice.dimensions == 3;
    int const aside = deep ? samplesAside3D : samplesAside2D, layers = deep ? aside : 1;
    for (std::size_t k = 0; k < regions.size(); ++k)
    {
        Vector const low = regions[k]->low(), size = (regions[k]->high() - low) / aside;
        Real const share = size.x() * size.y() * (deep ? size.z() : lattice.thickness);
        auto const count = [&](Vector const& r) {
            auto const holds = [&](auto const& region) { return region->contains(r); };
            bool const counted = std::any_of(regions.begin() + static_cast<std::ptrdiff_t>(k) + 1, regions.end(), holds);
            if (counted || !holds(regions[k])) return;
            volume.all += share;
            if (walls.distance(r) > 0)
                volume.free += share;
            else if (!box.holds(r))
                volume.beyond += share;
        };
        for (int l = 0; l < layers; ++l)
            for (int j = 0; j < aside; ++j)
                for (int i = 0; i < aside; ++i)
                    count({low.x() + (i + 0.5) * size.x(), low.y() + (j + 0.5) * size.y(), deep ? low.z() + (l + 0.5) * size.z() : 0});
    }
    return volume;
}

Real SizeEstimate::bytesToSet() const { return toSet * total(); }

Real SizeEstimate::bytesToRun() const { return toRun * total(); }

SizeEstimate estimateSize(SceneDefinition const& definition)
{
    SizeEstimate size;
    Lattice const& lattice = definition.lattice;
    std::vector<Surface> surfaces;
    for (WallDefinition const& wall : definition.walls)
    {
        surfaces.push_back(wall.surface);
        size.wall += particlesOf(wall, lattice);
    }
    size.fluid = sampleRegions(definition.regions, SurfaceTree(surfaces), lattice).free / lattice.particleVolume();
    if (definition.regions.empty()) return size;
    for (BodyShape const& shape : definition.shapes) size.body += particlesOf(shape, definition);
    return size;
}

std::string largeSurface(SceneDefinition const& definition, SizeEstimate const& size)
{
    Real const half = 0.5 * size.total();
    auto const text = [&](std::string const& kind, Surface const& surface, Location const& where) -> std::string {
        Real const extent = (surface.triangles().high() - surface.triangles().low()).maxCoeff();
        if (extent < likelySlip * definition.lattice.spacing) return {};
        return "most are those of " + kind + " \"" + surface.name() + "\" (" + where.str() + "), which measures " + rounded(extent) +
               " m: are the numbers of its file millimetres (scale 0.001)?";
    };
    for (WallDefinition const& wall : definition.walls)
        if (!wall.surface.flat() && particlesOf(wall, definition.lattice) > half) return text("wall", wall.surface, wall.where);
    for (BodyShape const& shape : definition.shapes)
        if (!shape.outline.flat() && !definition.regions.empty() && particlesOf(shape, definition) > half)
            return text("body", shape.outline, shape.where);
    return {};
}

void requireRoom(SizeEstimate const& size, Lattice const& lattice, Location const& where, std::uint64_t available, std::string const& doubt)
{
    Real const room = static_cast<Real>(available), most = std::min(room / toSet, mostNumbers);
    std::string const numbers = "about " + rounded(size.total()) + " particles (fluid " + rounded(size.fluid) + ", walls " +
                                rounded(size.wall) + ", bodies " + rounded(size.body) + ")";
    if (!(size.total() <= most))
        throw CaseError(ExitCode::Memory, where,
                        numbers + " need " + inGigabytes(size.bytesToSet()) + " of memory, " + inGigabytes(room) + " are free",
                        "a spacing of about " + rounded(lattice.spacing * std::pow(size.total() / most, 1.0 / lattice.dimensions)) +
                            " m or more, smaller regions, or a machine with more memory; at most " + rounded(mostNumbers) + " particles" +
                            (doubt.empty() ? "" : "\n    " + doubt));
    if (size.bytesToRun() > room)
        warn(numbers + ": the run will need " + inGigabytes(size.bytesToRun()) + " of memory, " + inGigabytes(room) + " are free here");
}

} // namespace mpsDem
