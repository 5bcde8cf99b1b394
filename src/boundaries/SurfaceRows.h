#pragma once

#include <span>

#include "boundaries/BoundaryRows.h"
#include "core/TriSurface.h"

namespace mpsDem {

BoundaryRows boundaryRows(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real spacing);

} // namespace mpsDem
