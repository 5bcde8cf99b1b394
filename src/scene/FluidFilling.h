#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <memory>
#include <vector>

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
/// | jitter | each particle is moved by up to this along each axis (2 or 3)   | spacings | 0       | 0 to 0.49 |
/// | seed   | of the jitter                                                   | -        | 1       | >= 0      |
/// | cutCells | of cells that a solid cuts: leave them empty, fill as many as there is room for | - | leave; fill in 3-D | |
struct LatticePlacement
{
    Vector origin = Vector::Zero();
    Vector offset = Vector::Zero();
    Real jitter = 0;
    std::uint64_t seed = 1;
    bool fillCutCells = false;

    /// Reads `lattice`; the defaults where it is absent. @throw CaseError BadInput for a number out of its range; in 2-D a third component.
    static LatticePlacement read(Dictionary const& setParticlesDict, int dimensions = 2);
};

/// Signed distance from solids [m], positive in the fluid, of any tree that has `Real distance(Vector const&) const`: SegmentTree in 2-D,
/// TriangleTree in 3-D. Keeps the address of the tree.
class SolidDistance
{
public:
    template <class Tree>
    requires(!std::same_as<Tree, SolidDistance>) SolidDistance(Tree const& tree)
        : tree_(&tree),
          ask_([](void const* of, Vector const& r) { return static_cast<Tree const*>(of)->distance(r); })
    {}
    [[nodiscard]] Real distance(Vector const& r) const { return ask_(tree_, r); }

private:
    void const* tree_;
    Real (*ask_)(void const*, Vector const&);
};

/// Solids that fluid keeps clear of.
struct Obstacles
{
    SolidDistance walls;  ///< Fixed walls.
    SolidDistance bodies; ///< Surfaces of bodies in space.

    [[nodiscard]] Real distance(Vector const& r) const { return std::min(walls.distance(r), bodies.distance(r)); }
};

/// Fluid particles, equal lengths.
struct FluidFilling
{
    Field<Vector> position; ///< [m]
    Field<int> region;      ///< The last region that holds the particle.
    std::vector<int> count; ///< Of each region: lattice points within it, before solids are carved out.
    /// Of the regions without solids, sampled [m3]. Error of about 0.01 of a cell (3-D: 0.02) for each cell that a surface cuts, random.
    Real volume = 0;
};

/// Lattice points origin + (i + 1/2 + offset) l0 that lie in a region, at least 0.45 l0 from walls on their fluid side and at least
/// 0.45 l0 outside of bodies. With `cutCells fill` cells that a solid cuts get as many more as there is room for (CutCells.h), and the volume is
/// right to a part in a thousand where the lattice fits; left empty, half a row is missing along oblique walls. A jittered point that would come nearer than 0.25 l0 to a solid stays where the lattice has it.
///
/// In 3-D, blocks of cells that are far from solids at their middle and corners are settled at once. What lies beyond the rim of an open
/// wall has no sharp inside: there a block may differ from its cells.
FluidFilling fillRegions(std::vector<std::unique_ptr<Region>> const& regions, LatticePlacement const& placement, Lattice const& lattice,
                         Obstacles const& obstacles);

/// Height of fluid above a point within the regions, measured along the unit vector `up`, over regions that touch each other [m];
/// negative where no region holds the point.
Real depthInRegions(std::vector<std::unique_ptr<Region>> const& regions, Vector const& r, Vector const& up, Real spacing);

} // namespace mpsDem
