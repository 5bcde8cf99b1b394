#pragma once

#include "core/Types.h"

namespace mpsDem {

/// The regular arrangement that particles start from.
struct Lattice
{
    int dimensions = 2; ///< d: 2 (x-y plane) or 3.
    Real spacing = 0;   ///< l0, distance of neighbouring particles at the start [m].
    Real thickness = 1; ///< Width in z that a 2-D particle stands for [m]; 1 in 3-D has no meaning.

    /// Volume of one particle [m3].
    [[nodiscard]] Real particleVolume() const { return dimensions == 2 ? spacing * spacing * thickness : spacing * spacing * spacing; }
};

} // namespace mpsDem
