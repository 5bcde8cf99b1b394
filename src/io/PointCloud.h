#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Views of named arrays, in the order in which they are written; all of the same length.
struct NamedArrays
{
    using IntegerSpan = std::variant<std::span<int const>, std::span<std::int64_t const>, std::span<std::uint8_t const>>;

    std::vector<std::pair<std::string, std::span<Real const>>> scalars;
    std::vector<std::pair<std::string, std::span<Vector const>>> vectors;
    std::vector<std::pair<std::string, IntegerSpan>> integers;
};

/// Particles to be written: positions [m] and one value of each array a particle.
struct PointCloud : NamedArrays
{
    std::span<Vector const> position;
};

/// Lines and polygons to be written, e.g. the outline of a body; one value of each array a cell, lines first, then polygons.
struct SurfaceCells : NamedArrays
{
    std::span<Vector const> points;                  ///< [m]
    std::vector<std::vector<std::int64_t>> lines;    ///< Point numbers of each open polyline.
    std::vector<std::vector<std::int64_t>> polygons; ///< Point numbers of each closed polygon, first point not repeated.
};

/// Triangles to be written; one value of each array a point.
struct TriangleCells : NamedArrays
{
    std::span<Vector const> points;  ///< [m]
    std::span<Vector const> normals; ///< Unit vectors, one a point; empty: none are written.
    std::span<std::array<int, 3> const> triangles;
};

/// Named arrays as read from a file.
struct NamedValues
{
    std::map<std::string, std::vector<Real>> scalars;
    std::map<std::string, std::vector<Vector>> vectors;
    std::map<std::string, std::vector<std::int64_t>> integers;
};

/// Particles as read from a file.
struct PointCloudData : NamedValues
{
    Real time = 0; ///< [s]
    std::vector<Vector> position;
};

/// Lines and polygons as read from a file.
struct SurfaceData : NamedValues
{
    Real time = 0; ///< [s]
    std::vector<Vector> points;
    std::vector<std::vector<std::int64_t>> lines;
    std::vector<std::vector<std::int64_t>> polygons;
};

} // namespace mpsDem
