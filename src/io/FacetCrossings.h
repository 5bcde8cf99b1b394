#pragma once

#include <string>

#include "io/FacetShells.h"

namespace mpsDem {

/// Refuses a skin that cuts through itself: its volume and mass would count twice what lies within two of its parts.
///
/// Two triangles without a common corner cut each other where each has corners on both sides of the other's plane and the two pieces of the
/// planes' common line that lie in them overlap (Moeller 1997). Faces that only touch do not. A tree of boxes finds the pairs: n log n.
/// @param tolerance  Depth and length of a cut that does not count [m].
/// @throw CaseError BadInput with the numbers of the first two facets and their place.
void requireNoCrossing(FacetMesh const& mesh, FacetSoup const& soup, std::string const& name, Real tolerance);

} // namespace mpsDem
