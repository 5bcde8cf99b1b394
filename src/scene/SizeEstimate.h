#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "boundaries/SurfaceTree.h"
#include "scene/InitialState.h"

namespace mpsDem {

/// What the regions of a case cover, sampled at 128 x 128 points a region (3-D: 32 x 32 x 32) (about 0.5 % of a region's box) [m3].
struct RegionVolume
{
    Real all = 0;    ///< Of the union of the regions.
    Real free = 0;   ///< Of it, on the fluid side of the walls.
    Real beyond = 0; ///< Of it, behind walls and outside of the box that holds all walls: further out than a ramp or a step accounts for.
};

RegionVolume sampleRegions(std::vector<std::unique_ptr<Region>> const& regions, SurfaceTree const& walls, Lattice const& lattice);

/// Numbers of particles before any is laid out: fluid from the free volume of the regions, walls from their length and rows, bodies from
/// the ring of their rows. Within some percent; fluid that bodies displace is counted.
struct SizeEstimate
{
    Real fluid = 0, wall = 0, body = 0;

    [[nodiscard]] Real total() const { return fluid + wall + body; }
    /// Memory [bytes] that setParticles takes at its peak, and mpsDemFoam later: measured by the particle.
    [[nodiscard]] Real bytesToSet() const;
    [[nodiscard]] Real bytesToRun() const;
};

SizeEstimate estimateSize(SceneDefinition const& definition);

/// Refuses a case that would not fit into the memory, with the numbers; warns where only the run would not.
/// @param where      Place of the spacing in its dictionary.
/// @param available  [bytes]
/// @param doubt      What may be wrong with the case, for the message; may be empty.
/// @throw CaseError Memory
void requireRoom(SizeEstimate const& size, Lattice const& lattice, Location const& where, std::uint64_t available,
                 std::string const& doubt = {});

/// Names the surface of triangles to which most particles of the case are due, where one is: a file in millimetres that was read as metres
/// has a million times as many. Empty otherwise.
[[nodiscard]] std::string largeSurface(SceneDefinition const& definition, SizeEstimate const& size);

} // namespace mpsDem
