#pragma once

#include <filesystem>
#include <string>

#include "core/Dictionary.h"
#include "core/TriSurface.h"
#include "core/Types.h"
#include "io/FacetSoup.h"

namespace mpsDem {

/// Reads the surface that a dictionary names by its file.
///
/// | key   | meaning                                                                   | unit | default |
/// |-------|---------------------------------------------------------------------------|------|---------|
/// | file  | beneath constant/triSurface of the case: STL, binary or ASCII             | -    | none    |
/// | scale | metres per unit of the file                                               | -    | 1       |
/// | translate | moved by, after scaling                                               | m    | (0 0 0) |
///
/// @param name     Of the surface.
/// @param spacing  Of the particles [m]; 0 asks nothing of the extent.
/// @throw CaseError for a path that leaves the folder, a file that is missing (InputOutput) or bad; see readStl().
TriSurface readSurfaceFile(Dictionary const& dict, std::filesystem::path const& caseFolder, std::string const& name, Skin skin,
                           Real spacing);

/// Reads the raster of heights that a dictionary names by its file, the fluid above it.
///
/// | key    | meaning                                                                   | unit | default |
/// |--------|---------------------------------------------------------------------------|------|---------|
/// | file   | beneath constant/triSurface of the case: ESRI ASCII grid                  | -    | none    |
/// | up     | y: x east, y up, z south; z: x east, y north, z up                        | -    | y       |
/// | origin | east, north and height in the file that become (0 0 0)                    | file | (0 0 0) |
/// | scale  | metres per unit of the file                                               | -    | 1       |
/// | every  | takes every n-th sample along rows and columns                            | -    | 1       |
///
/// @throw CaseError for a path that leaves the folder; see readRaster().
TriSurface readRasterSurface(Dictionary const& dict, std::filesystem::path const& caseFolder, std::string const& name);

} // namespace mpsDem
