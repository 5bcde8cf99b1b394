#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Registry.h"
#include "core/Surface.h"
#include "particles/Lattice.h"

namespace mpsDem {

/// A surface of `geometry` before it has a name and its fluid side is settled.
struct SurfaceShape
{
    /// Makes the surface. @param first  The fluid lies on the side that the first of `sides` names.
    std::function<Surface(std::string const& name, bool first)> make;
    std::vector<std::string> sides; ///< The two words that name its sides.
    std::string side;               ///< The one that holds unless a wall says otherwise.
};

/// What a surface's entries are read with.
struct GeometryContext
{
    Lattice lattice;
    std::filesystem::path root; ///< The case: files lie in constant/triSurface.
};

using ShapeRegistry = Registry<SurfaceShape, Dictionary const&, GeometryContext const&>;

/// Surface types of a 2-D case: lines in the plane z = 0.
ShapeRegistry const& shapes2D();
/// Surface types of a 3-D case: triangles.
ShapeRegistry const& shapes3D();

/// Words of the sides of a box that may be left open: left right bottom top, in 3-D also back (low z) and front.
/// @return For -x +x -y +y (-z +z) whether it is open. @throw CaseError for a word that is none of `names`, which stand in this order.
std::vector<bool> readOpenSides(Dictionary const& dict, std::vector<std::string> const& names);

/// Corners of a polygon that stands for a circle: at least 64, so many that it leaves the circle by no more than 0.005 spacings.
std::vector<Vector> circlePoints(Vector const& centre, Real radius, Real spacing);

/// Longest edge of the triangles that stand for a sphere, in spacings: its volume is right within 0.2 % where it is 8 spacings across.
inline constexpr Real sphereEdge = 0.5;

/// `zRange (low high);` of a surface or body that stands over a line or polygon of the x-y plane [m].
std::pair<Real, Real> readZRange(Dictionary const& dict);

} // namespace mpsDem
