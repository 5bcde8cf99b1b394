#include "scene/SizeEstimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundaries/BoundaryRows.h"
#include "core/Errors.h"
#include "core/Log.h"

namespace mpsDem {

namespace {

constexpr int samplesAside = 128;
constexpr Real toSet = 400;       ///< Bytes a particle: 300 measured from 190 000 to 740 000 particles, and vectors that double.
constexpr Real toRun = 1600;      ///< Bytes a particle, measured from 50 000 to 190 000 with the standard schemes.
constexpr Real mostNumbers = 2e9; ///< Particles are numbered by 32 bits.

std::string rounded(Real number) { return shortNumber(number, 3); }

std::string inGigabytes(Real bytes) { return rounded(bytes / 1e9) + " GB"; }

Real lengthOf(Polyline const& line)
{
    Real length = 0;
    for (auto const& segment : line.segments()) length += segment.length;
    return length;
}

struct Box
{
    Vector low = Vector::Constant(std::numeric_limits<Real>::infinity()), high = -low;

    Box(SegmentTree const& walls, Real margin)
    {
        for (SegmentTree::Item const& item : walls.items())
            for (Vector const& r : {item.segment.a, item.segment.b})
            {
                low = low.cwiseMin(r);
                high = high.cwiseMax(r);
            }
        low.array() -= margin;
        high.array() += margin;
    }
    [[nodiscard]] bool holds(Vector const& r) const { return (r.array() >= low.array()).all() && (r.array() <= high.array()).all(); }
};

} // namespace

RegionVolume sampleRegions(std::vector<std::unique_ptr<Region>> const& regions, SegmentTree const& walls, Lattice const& lattice)
{
    RegionVolume volume;
    Box const box(walls, lattice.spacing);
    for (std::size_t k = 0; k < regions.size(); ++k)
    {
        Vector const low = regions[k]->low(), size = (regions[k]->high() - low) / samplesAside;
        Real const share = size.x() * size.y() * lattice.thickness;
        for (int j = 0; j < samplesAside; ++j)
            for (int i = 0; i < samplesAside; ++i)
            {
                Vector const r = low + Vector((i + 0.5) * size.x(), (j + 0.5) * size.y(), 0);
                auto const holds = [&](auto const& region) { return region->contains(r); };
                bool const counted = std::any_of(regions.begin() + static_cast<std::ptrdiff_t>(k) + 1, regions.end(), holds);
                if (counted || !holds(regions[k])) continue;
                volume.all += share;
                if (walls.distance(r) > 0)
                    volume.free += share;
                else if (!box.holds(r))
                    volume.beyond += share;
            }
    }
    return volume;
}

Real SizeEstimate::bytesToSet() const { return toSet * total(); }

Real SizeEstimate::bytesToRun() const { return toRun * total(); }

SizeEstimate estimateSize(SceneDefinition const& definition)
{
    SizeEstimate size;
    Lattice const& lattice = definition.lattice;
    std::vector<Polyline> surfaces;
    for (WallDefinition const& wall : definition.walls)
    {
        surfaces.push_back(wall.surface);
        size.wall += lengthOf(wall.surface) / lattice.spacing * (1 + wall.ghostRows);
    }
    size.fluid = sampleRegions(definition.regions, SegmentTree(surfaces), lattice).free / lattice.particleVolume();
    if (definition.regions.empty()) return size;
    Real const width = (1 + ghostRowsFor(definition.kernelRadius)) * lattice.spacing;
    for (BodyShape const& shape : definition.shapes)
    {
        // A ring of this width within a shape all of whose sides touch one circle of radius 2 A / P: triangle, square, disc.
        Real const volume = shape.properties.volume, radius = 2 * volume / (lattice.thickness * lengthOf(shape.outline));
        Real const core = std::max(Real(0), 1 - width / radius);
        size.body += volume * (1 - core * core) / lattice.particleVolume();
    }
    return size;
}

void requireRoom(SizeEstimate const& size, Real spacing, Location const& where, std::uint64_t available)
{
    Real const room = static_cast<Real>(available), most = std::min(room / toSet, mostNumbers);
    std::string const numbers = "about " + rounded(size.total()) + " particles (fluid " + rounded(size.fluid) + ", walls " +
                                rounded(size.wall) + ", bodies " + rounded(size.body) + ")";
    if (!(size.total() <= most))
        throw CaseError(ExitCode::Memory, where,
                        numbers + " need " + inGigabytes(size.bytesToSet()) + " of memory, " + inGigabytes(room) + " are free",
                        "a spacing of about " + rounded(spacing * std::sqrt(size.total() / most)) +
                            " m or more, smaller regions, or a machine with more memory; at most " + rounded(mostNumbers) + " particles");
    if (size.bytesToRun() > room)
        warn(numbers + ": the run will need " + inGigabytes(size.bytesToRun()) + " of memory, " + inGigabytes(room) + " are free here");
}

} // namespace mpsDem
