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
/// | key    | meaning                                                                                | unit | default |
/// |--------|----------------------------------------------------------------------------------------|------|---------|
/// | file   | beneath constant/triSurface of the case: .stl, binary or ASCII, or .asc, an ESRI grid  | -    | none    |
/// | scale  | metres per unit of the file                                                            | -    | 1       |
/// | translate | .stl: moved by, after scaling                                                       | m    | (0 0 0) |
/// | up     | .asc: axis of the heights; y: z is south, z: y is north; x is east                     | -    | y       |
/// | origin | .asc: east, north and height in the file that become (0 0 0)                           | file | (0 0 0) |
/// | every  | .asc: takes every n-th sample                                                          | -    | 1       |
///
/// @param name     Of the surface.
/// @param spacing  Of the particles [m]; 0 asks nothing of the extent.
/// @throw CaseError for a path that leaves the folder, another ending, a file that is missing (InputOutput) or bad; see readStl(), readRaster().
///        A raster is refused where the surface has to be closed.
TriSurface readSurfaceFile(Dictionary const& dict, std::filesystem::path const& caseFolder, std::string const& name, Skin skin,
                           Real spacing);

} // namespace mpsDem
