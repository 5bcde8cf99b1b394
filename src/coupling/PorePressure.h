#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Pressure of the water between two solids that touch, in 3-D: what the rim of the contact face carries, continued into it as through a
/// thin gap of even width, where the flow through it is without divergence:
/// \f[ \sum_j w_{ij}\,(p_i - p_j) = 0 \f]
/// for every point i of the face, over points j of the surface near it; points around the face keep their pressure.
class PorePressure
{
public:
    /// @param position, normal, area  Of the points of a surface, in body axes [m], [-], [m2].
    /// @param reach                   Points nearer than this are connected [m].
    PorePressure(Field<Vector> const& position, Field<Vector> const& normal, Field<Real> const& area, Real reach);

    /// @param unknown   1 for points of the face.
    /// @param pressure  Given where `unknown` is 0, found where it is 1 [Pa].
    void fill(Field<std::uint8_t> const& unknown, Field<Real>& pressure) const;

private:
    /// Neighbours of each point and their weights.
    std::vector<std::vector<std::pair<int, Real>>> links_;
};

} // namespace mpsDem
