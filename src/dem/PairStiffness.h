#pragma once

#include "dem/ContactLaw.h"
#include "dem/ContactPoints.h"
#include "dem/ContactProperties.h"

namespace mpsDem {

/// What the stiffness of a pair is chosen from.
struct PairLoad
{
    Real mass;        ///< Heaviest body of the pair [kg].
    Real largestSide; ///< Smallest of the bodies' longest sides, on which the weight may rest [m2].
    Real spacing;     ///< dx [m].
    Real thickness;   ///< [m].
    bool disc;        ///< A single sphere carries all.
};

/// Contact stiffness per area k_A [N/m3] of the linear law.
///
/// maxOverlap: the largest of m 9.81 / (maxOverlap dx A) for the weight on the longest side A, and m v^2 / (0.05 dx)^2 / (dx t / 2) for
/// one corner that stops the whole body at impactSpeed v. fromModulus: tangent stiffness 3 F / (2 delta) of Hertz's law
/// F = 4/3 E* sqrt(dx/2) delta^1.5 for spheres of the spacing that share the weight. constant: normalStiffness.
Real stiffnessPerArea(ContactProperties const& properties, PairLoad const& load);

/// Constants of the laws for one pair. @param share  0.5 where both bodies' points find the touch.
ContactMaterial contactMaterial(ContactProperties const& properties, PairLoad const& load, Real share);

} // namespace mpsDem
