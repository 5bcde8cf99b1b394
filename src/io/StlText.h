#pragma once

#include <string_view>

#include "io/FacetSoup.h"

namespace mpsDem {

/// Whether a text begins with the word solid, blanks and a byte order mark aside.
bool startsAsStlText(std::string_view text);

/// Reads `solid [name] (facet normal n n n outer loop (vertex x y z) x 3 endloop endfacet)* endsolid [name]`, one or several of them, in small
/// or capital letters and any lines, into facets and their lines. Normals are skipped.
/// @throw CaseError BadInput with the line and the facet for anything else, a text that ends early among it.
void readStlText(std::string_view text, FacetSoup& soup);

} // namespace mpsDem
