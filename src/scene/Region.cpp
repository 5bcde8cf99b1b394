#include "scene/Region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Errors.h"

namespace mpsDem {

namespace {

Vector flat(Vector v)
{
    v.z() = 0;
    return v;
}

/// Parallelogram origin + s i + t j, 0 <= s, t < 1: the box and the rotated box. Half-open, so that a lattice with points on two opposite
/// sides fills it with the right number of particles.
class ParallelogramRegion : public Region
{
public:
    ParallelogramRegion(Vector const& origin, Vector const& i, Vector const& j, Location const& place)
        : origin_(flat(origin)),
          i_(flat(i)),
          j_(flat(j))
    {
        Real const area = i_.x() * j_.y() - i_.y() * j_.x();
        require(std::abs(area) > 1e-12 * i_.norm() * j_.norm(), place, "a box without area", "corners that differ in x and in y");
        dualI_ = Vector(j_.y(), -j_.x(), 0) / area;
        dualJ_ = Vector(-i_.y(), i_.x(), 0) / area;
    }

    bool contains(Vector const& r) const override
    {
        Real const s = dualI_.dot(r - origin_), t = dualJ_.dot(r - origin_);
        Real constexpr slack = 1e-12;
        return s >= -slack && s < 1 - slack && t >= -slack && t < 1 - slack;
    }
    Vector low() const override { return origin_ + i_.cwiseMin(0).eval() + j_.cwiseMin(0).eval(); }
    Vector high() const override { return origin_ + i_.cwiseMax(0).eval() + j_.cwiseMax(0).eval(); }
    Real exitDistance(Vector const& r, Vector const& up) const override
    {
        Real distance = std::numeric_limits<Real>::infinity();
        for (Vector const& dual : {dualI_, dualJ_})
        {
            Real const speed = dual.dot(up), place = dual.dot(r - origin_);
            if (std::abs(speed) < tiny) continue;
            distance = std::min(distance, ((speed > 0 ? 1 : 0) - place) / speed);
        }
        return std::max(Real(0), distance);
    }

private:
    Vector origin_, i_, j_, dualI_, dualJ_;
};

class DiscRegion : public Region
{
public:
    DiscRegion(Vector const& centre, Real radius) : centre_(flat(centre)), radius_(radius) {}

    bool contains(Vector const& r) const override { return (r - centre_).norm() <= radius_ * (1 + 1e-12); }
    Vector low() const override { return centre_ - Vector(radius_, radius_, 0); }
    Vector high() const override { return centre_ + Vector(radius_, radius_, 0); }
    Real exitDistance(Vector const& r, Vector const& up) const override
    {
        Vector const d = r - centre_;
        Real const b = d.dot(up);
        return std::max(Real(0), -b + std::sqrt(std::max(Real(0), b * b - d.squaredNorm() + radius_ * radius_)));
    }

private:
    Vector centre_;
    Real radius_;
};

Vector readFinite(Dictionary const& dict, std::string const& key)
{
    Vector const v = dict.get<Vector>(key);
    require(v.allFinite(), dict.where(key), key + " is not finite", "three numbers");
    return v;
}

Real readRadius(Dictionary const& dict) { return readPositive(dict, "radius"); }

std::unique_ptr<Region> makeBox(Dictionary const& dict)
{
    bool const asPair = dict.found("box");
    Vector const a = asPair ? readVectorSequence(dict, "box", 2)[0] : readFinite(dict, "min");
    Vector const b = asPair ? readVectorSequence(dict, "box", 2)[1] : readFinite(dict, "max");
    Vector const low = a.cwiseMin(b), size = b.cwiseMax(a) - low;
    return std::make_unique<ParallelogramRegion>(low, Vector(size.x(), 0, 0), Vector(0, size.y(), 0), dict.where(asPair ? "box" : "min"));
}

std::unique_ptr<Region> makeRotatedBox(Dictionary const& dict)
{
    dict.ignore("k");
    return std::make_unique<ParallelogramRegion>(readFinite(dict, "origin"), readFinite(dict, "i"), readFinite(dict, "j"), dict.where("i"));
}

std::unique_ptr<Region> makeCylinder(Dictionary const& dict)
{
    Vector const p1 = readFinite(dict, "p1"), p2 = readFinite(dict, "p2");
    require(flat(p1 - p2).norm() < 1e-9 * (1 + p1.norm()), dict.where("p2"), "the axis of a cylinder is not along z",
            "p1 and p2 with the same x and y: a 2-D case sees the disc");
    return std::make_unique<DiscRegion>(p1, readRadius(dict));
}

std::unique_ptr<Region> makeSphere(Dictionary const& dict)
{
    return std::make_unique<DiscRegion>(readFinite(dict, dict.found("centre") ? "centre" : "origin"), readRadius(dict));
}

} // namespace

RegionRegistry& regionRegistry()
{
    static RegionRegistry registry = [] {
        RegionRegistry made("region", "regions");
        made.add("boxToParticle", makeBox);
        made.add("rotatedBoxToParticle", makeRotatedBox);
        made.add("cylinderToParticle", makeCylinder);
        made.add("sphereToParticle", makeSphere);
        return made;
    }();
    return registry;
}

std::vector<std::unique_ptr<Region>> readRegions(Dictionary const& setParticlesDict)
{
    std::vector<std::unique_ptr<Region>> regions;
    if (!setParticlesDict.found("regions")) return regions;
    for (auto const& [type, dict] : setParticlesDict.getDictList("regions"))
    {
        auto region = regionRegistry().make(type, dict.where(), dict);
        region->type = type;
        region->where = dict.where();
        region->values = readFieldValues(dict, "fieldValues");
        regions.push_back(std::move(region));
    }
    return regions;
}

} // namespace mpsDem
