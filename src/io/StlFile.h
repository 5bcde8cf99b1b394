#pragma once

#include <filesystem>
#include <string>

#include "core/TriSurface.h"
#include "core/Types.h"
#include "io/FacetSoup.h"

namespace mpsDem {

/// How a file of facets is to be read.
struct StlOptions
{
    Real scale = 1;         ///< Metres per unit of the file: 0.001 where it counts in mm.
    Skin skin = Skin::Open; ///< Closed for a body or a region of fluid.
    Real spacing = 0;       ///< Of the particles [m]: a surface of far too many or too few of them draws a warning. 0: not asked.
};

/// Reads a surface from an STL file, binary or ASCII, all solids in it as one surface; see joinFacets() for how facets become one.
///
/// Size decides, not the first word: a file of 84 + 50 n bytes with n in bytes 80 to 83 is binary, even one that begins with "solid". Normals
/// in the file do not count, windings do. Numbers of an ASCII file keep all their digits (VTK's reader rounds them to floats, half a metre
/// in the coordinates of a map, and lets NaN and truncated files pass); those of a binary file have seven.
/// @throw CaseError InputOutput where the file cannot be read; BadInput with facet or line for what is no STL: truncated, empty, a count that
///        does not fit, words where numbers belong; and what joinFacets() refuses.
TriSurface readStl(std::filesystem::path const& file, std::string const& name, StlOptions const& options = {});

/// Writes a binary STL file that readStl() and others read; seven digits. @throw CaseError InputOutput.
void writeStl(std::filesystem::path const& file, TriSurface const& surface);

} // namespace mpsDem
