#include "dem/ContactProperties.h"

#include <cmath>
#include <numbers>

namespace mpsDem {

ContactProperties ContactProperties::read(Dictionary const& dict, ContactProperties const& common)
{
    ContactProperties p = common;
    p.law = dict.getOr<std::string>("law", common.law);
    if (dict.found("law")) p.where = dict.where("law");
    p.mu = dict.getInRangeOr("mu", common.mu, 0, 10);
    p.e = dict.getInRangeOr("e", common.e, 0.01, 1);
    if (dict.found("youngsModulus")) p.modulus = dict.where("youngsModulus");
    p.youngsModulus = dict.getInRangeOr("youngsModulus", common.youngsModulus, 1e3, 1e13);
    p.poissonsRatio = dict.getInRangeOr("poissonsRatio", common.poissonsRatio, 0, 0.499);
    p.stiffness = dict.getWordOr("stiffness", common.stiffness, {"maxOverlap", "fromModulus", "constant"}, "choices of the stiffness");
    p.maxOverlap = dict.getInRangeOr("maxOverlap", common.maxOverlap, 1e-7, 0.05);
    p.impactSpeed = dict.getInRangeOr("impactSpeed", common.impactSpeed, 0, 1e3);
    p.normalStiffness = dict.getInRangeOr("normalStiffness", common.normalStiffness, 1, 1e20);
    require(p.stiffness != "constant" || p.normalStiffness > 0, dict.where("stiffness"), "stiffness constant without a normalStiffness",
            "normalStiffness [N/m3], above zero");
    return p;
}

bool ContactProperties::idleModulus() const { return !modulus.file.empty() && stiffness != "fromModulus" && law != "hertzMindlin"; }

ContactProperties ContactProperties::readCommon(Dictionary const& dict)
{
    ContactProperties common;
    common.where = dict.where();
    common.mu = dict.getInRange("mu", 0, 10);
    return read(dict, common);
}

ContactProperties ContactProperties::readPair(Dictionary const& dict, ContactProperties const& common, std::string const& first,
                                              std::string const& second)
{
    Dictionary const pairs = dict.subDictOrEmpty("pairs");
    std::string const forward = first + ":" + second;
    std::string const backward = second + ":" + first;
    bool const hasForward = pairs.found(forward);
    bool const hasBackward = pairs.found(backward);
    bool const twice = hasForward && hasBackward && pairs.where(forward).line != pairs.where(backward).line;
    require(!twice, pairs.where(backward), "pair \"" + forward + "\" has two entries", "one of either order of the names");
    if (hasForward) return read(pairs.subDict(forward), common);
    if (hasBackward) return read(pairs.subDict(backward), common);
    return common;
}

Real restitution(Real zeta)
{
    Real const pi = std::numbers::pi;
    if (zeta < 1 - 1e-9)
    {
        Real const phi = std::asin(zeta);
        return std::exp(-(pi - 2 * phi) * std::tan(phi));
    }
    if (zeta < 1 + 1e-9) return std::exp(-2.0);
    Real const psi = std::acosh(zeta);
    return std::exp(-2 * psi / std::tanh(psi));
}

Real dampingRatio(Real e)
{
    if (e >= 1) return 0;
    Real low = 0;
    Real high = 100;
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i)
    {
        Real const middle = 0.5 * (low + high);
        (restitution(middle) > e ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace mpsDem
