#include "dem/PairStiffness.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

namespace {

constexpr Real standardGravity = 9.81;
constexpr Real cornerOverlap = 0.05;

Real effectiveModulus(ContactProperties const& p) { return p.youngsModulus / (2 * (1 - p.poissonsRatio * p.poissonsRatio)); }

Real fromModulus(ContactProperties const& properties, PairLoad const& load)
{
    Real const cell = load.spacing * load.spacing;
    Real const pointArea = load.disc ? load.largestSide : cell;
    Real const force = standardGravity * load.mass * pointArea / load.largestSide;
    Real const factor = 4.0 / 3.0 * effectiveModulus(properties) * std::sqrt(0.5 * load.spacing);
    Real const overlap = std::pow(force / factor, 2.0 / 3.0);
    return 1.5 * force / overlap / pointArea;
}

} // namespace

Real stiffnessPerArea(ContactProperties const& properties, PairLoad const& load)
{
    if (properties.stiffness == "constant") return properties.normalStiffness;
    if (properties.stiffness == "fromModulus") return fromModulus(properties, load);
    Real const byWeight = standardGravity * load.mass / (properties.maxOverlap * load.spacing * load.largestSide);
    Real const cornerArea = (load.disc ? 1.0 : 0.5) * load.spacing * load.thickness;
    Real const rootOfCorner = properties.impactSpeed / (cornerOverlap * load.spacing);
    return std::max(byWeight, load.mass * rootOfCorner * rootOfCorner / cornerArea);
}

ContactMaterial contactMaterial(ContactProperties const& properties, PairLoad const& load, Real share)
{
    Real const nu = properties.poissonsRatio;
    ContactMaterial material;
    material.stiffnessPerArea = stiffnessPerArea(properties, load);
    material.effectiveModulus = effectiveModulus(properties);
    material.effectiveShear = properties.youngsModulus / (2 * (1 + nu)) / (2 * (2 - nu));
    material.tangentialRatio = 2 * (1 - nu) / (2 - nu);
    material.mu = properties.mu;
    material.zeta = dampingRatio(properties.e);
    material.share = share;
    return material;
}

} // namespace mpsDem
