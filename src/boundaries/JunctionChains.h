#pragma once

#include <vector>

#include "boundaries/EdgeChains.h"
#include "boundaries/JoinedSurfaces.h"

namespace mpsDem {

/// Lines along which components of a set of surfaces meet without a common edge: one cuts through the middle of another, or ends on it (a
/// raster of heights between box walls). All are valleys: the fluid is where it is on the fluid side of both.
/// Pieces bend by less than 20 degrees from one to the next; what faces nearly the same way (less than 20 degrees) is no valley.
std::vector<EdgeChain> junctionChains(JoinedSurfaces const& surfaces);

} // namespace mpsDem
