#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "boundaries/SurfaceTree.h"
#include "core/Dictionary.h"
#include "core/Types.h"
#include "particles/Lattice.h"
#include "scene/Region.h"

namespace mpsDem {

/// Where the lattice of the fluid lies: entry `lattice` of setParticlesDict.
///
/// | key    | meaning                                                         | unit     | default | range     |
/// |--------|-----------------------------------------------------------------|----------|---------|-----------|
/// | origin | corner of a cell of the lattice; particles stand in the middles | m        | (0 0 0) |           |
/// | offset | shifts it                                                       | spacings | (0 0 0) | -1 to 1   |
/// | jitter | each particle is moved by up to this along each axis            | spacings | 0       | 0 to 0.49 |
/// | seed   | of the jitter                                                   | -        | 1       | >= 0      |
struct LatticePlacement
{
    Vector origin = Vector::Zero();
    Vector offset = Vector::Zero();
    Real jitter = 0;
    std::uint64_t seed = 1;

    /// Reads `lattice`; the defaults where it is absent. @throw CaseError BadInput for a number out of its range.
    static LatticePlacement read(Dictionary const& setParticlesDict);
};

/// Solids that fluid keeps clear of.
struct Obstacles
{
    SurfaceTree const& walls;  ///< Fixed walls.
    SurfaceTree const& bodies; ///< Outlines of bodies in space.
};

/// Fluid particles, equal lengths.
struct FluidFilling
{
    Field<Vector> position; ///< [m]
    Field<int> region;      ///< The last region that holds the particle.
    std::vector<int> count; ///< Of each region: lattice points within it, before solids are carved out.
    Real volume =
        0; ///< Of the regions without solids, sampled (error about 0.01 of a cell for each cell that a surface cuts, random) [m3].
};

/// Lattice points origin + (i + 1/2 + offset) l0 that lie in a region, at least 0.45 l0 from walls on their fluid side and at least
/// 0.45 l0 outside of bodies. A jittered point that would come nearer than 0.25 l0 to a solid stays where the lattice has it.
FluidFilling fillRegions(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                         Obstacles const& obstacles);

/// Height of fluid above a point within the regions, measured along the unit vector `up`, over regions that touch each other [m];
/// negative where no region holds the point.
Real depthInRegions(std::vector<std::unique_ptr<Region>> const& regions, Vector const& r, Vector const& up, Real spacing);

} // namespace mpsDem
