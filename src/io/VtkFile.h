#pragma once

#include <filesystem>

#include "io/PointCloud.h"

namespace mpsDem {

/// Width of real numbers in a .vtp file. Single keeps seven digits: for pictures, never for restart.
enum class VtkPrecision
{
    Single,
    Double
};

/// Writes one `.vtp` for ParaView: inline base64, zlib level 1, the time [s] as field data TimeValue, one vertex cell a particle (without
/// cells ParaView shows nothing as a surface and Threshold finds nothing). A reader sees the whole file or none.
/// @throw CaseError (InputOutput); std::logic_error for arrays of another length than the positions.
void writePointCloud(std::filesystem::path const& path, PointCloud const& cloud, Real time, VtkPrecision precision = VtkPrecision::Single);

/// The same for lines and polygons with cell arrays.
void writeSurface(std::filesystem::path const& path, SurfaceCells const& surface, Real time, VtkPrecision precision = VtkPrecision::Single);

/// The same for triangles with point arrays.
void writeTriangles(std::filesystem::path const& path, TriangleCells const& surface, Real time,
                    VtkPrecision precision = VtkPrecision::Single);

/// Reads the points and point arrays of a `.vtp`. Arrays of one component: scalars, or integers where the file says so; three: vectors;
/// others are passed over. Needs no display.
/// @throw CaseError (InputOutput) where the file cannot be read.
PointCloudData readPointCloud(std::filesystem::path const& path);

/// Reads the points, lines, polygons and cell arrays of a `.vtp`.
SurfaceData readSurface(std::filesystem::path const& path);

} // namespace mpsDem
