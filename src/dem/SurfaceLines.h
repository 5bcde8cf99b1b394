#pragma once

#include <array>
#include <vector>

#include "core/TriSurface.h"

namespace mpsDem {

/// Edges sharper than this have contact points of their own: cosine between the normals, 30 degrees, an edge of 150.
inline constexpr Real sharpEdge = 0.86602540378443865;

/// A ridge sharper than 150 degrees: two triangles whose normals differ by more than 30 degrees.
bool isSharp(TriSurface const& surface, TriSurface::Edge const& edge);

/// Place on a sharp line.
struct LinePoint
{
    Vector position;
    Real length;      ///< Part of the line that it stands for [m].
    std::size_t edge; ///< Number of the edge on which it lies.
};

/// Points along all sharp edges: edges that go on straight (within 30 degrees) make one line, which is cut into equal parts of about
/// `spacing` with a point in the middle of each.
std::vector<LinePoint> pointsOnSharpLines(TriSurface const& surface, Real spacing);

/// Numbers of the points where sharp lines end, meet or turn by more than 30 degrees, and of tips without a sharp edge.
std::vector<int> sharpCorners(TriSurface const& surface);

} // namespace mpsDem
