#pragma once

#include <array>
#include <vector>

#include "io/WaterSurface.h"

namespace mpsDem::postGauges {

/// Triangles for drawing, three points each, with normals that are smooth where the skin bends by less than 35 degrees.
SurfaceMesh smoothSkin(std::vector<std::vector<Vector>> const& polygons);

/// Where a plane cuts polygons: chains of points, closed ones for a closed skin.
std::vector<std::vector<Vector>> cutChains(std::vector<std::vector<Vector>> const& polygons, CutPlane const& plane);

} // namespace mpsDem::postGauges
