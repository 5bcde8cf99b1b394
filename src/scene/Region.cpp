#include "scene/Region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/Errors.h"
#include "scene/SurfaceColumns.h"
#include "scene/SurfaceFile.h"

namespace mpsDem {

namespace {

Vector flat(Vector v)
{
    v.z() = 0;
    return v;
}

/// Origin + s i + t j + u k, 0 <= s, t, u < 1: the box and the rotated box, in 2-D the parallelogram of i and j.
class BoxRegion : public Region
{
public:
    /// @param k  (0 0 1) in 2-D.
    BoxRegion(int dimensions, Vector const& origin, Vector const& i, Vector const& j, Vector const& k, Location const& place)
        : origin_(origin),
          edges_{i, j, k},
          axes_(static_cast<std::size_t>(dimensions))
    {
        Real const volume = i.dot(j.cross(k));
        require(std::abs(volume) > 1e-12 * i.norm() * j.norm() * k.norm(), place,
                dimensions == 2 ? "a box without area" : "a box without volume",
                dimensions == 2 ? "corners that differ in x and in y"
                                : "corners that differ in x, in y and in z; edges in three directions");
        duals_ = {j.cross(k) / volume, k.cross(i) / volume, i.cross(j) / volume};
    }

    bool contains(Vector const& r) const override
    {
        Real constexpr slack = 1e-12;
        Vector const d = r - origin_;
        for (std::size_t k = 0; k < axes_; ++k)
        {
            Real const s = duals_[k].dot(d);
            if (!(s >= -slack && s < 1 - slack)) return false;
        }
        return true;
    }
    Vector low() const override
    {
        Vector corner = origin_;
        for (std::size_t k = 0; k < axes_; ++k) corner += edges_[k].cwiseMin(0);
        return corner;
    }
    Vector high() const override
    {
        Vector corner = origin_;
        for (std::size_t k = 0; k < axes_; ++k) corner += edges_[k].cwiseMax(0);
        return corner;
    }
    Real exitDistance(Vector const& r, Vector const& up) const override
    {
        Real distance = std::numeric_limits<Real>::infinity();
        for (std::size_t k = 0; k < axes_; ++k)
        {
            Real const speed = duals_[k].dot(up), place = duals_[k].dot(r - origin_);
            if (std::abs(speed) < tiny) continue;
            distance = std::min(distance, ((speed > 0 ? 1 : 0) - place) / speed);
        }
        return std::max(Real(0), distance);
    }

private:
    Vector origin_;
    std::array<Vector, 3> edges_, duals_;
    std::size_t axes_;
};

/// Way along `up` from d within a ball (in 2-D a disc) of the given radius about the origin, out of it.
Real wayOutOfBall(Vector const& d, Vector const& up, Real radius)
{
    Real const b = d.dot(up);
    return std::max(Real(0), -b + std::sqrt(std::max(Real(0), b * b - d.squaredNorm() + radius * radius)));
}

/// Ball; in 2-D a disc.
class BallRegion : public Region
{
public:
    BallRegion(int dimensions, Vector const& centre, Real radius)
        : centre_(centre),
          reach_(radius, radius, dimensions == 2 ? 0 : radius),
          radius_(radius)
    {}

    bool contains(Vector const& r) const override { return (r - centre_).norm() <= radius_ * (1 + 1e-12); }
    Vector low() const override { return centre_ - reach_; }
    Vector high() const override { return centre_ + reach_; }
    Real exitDistance(Vector const& r, Vector const& up) const override { return wayOutOfBall(r - centre_, up, radius_); }

private:
    Vector centre_, reach_;
    Real radius_;
};

/// Circular cylinder in 3-D, with its first end, without its second.
class CylinderRegion : public Region
{
public:
    CylinderRegion(Vector const& end1, Vector const& end2, Real radius)
        : end1_(end1),
          end2_(end2),
          axis_((end2 - end1).normalized()),
          length_((end2 - end1).norm()),
          radius_(radius)
    {}

    bool contains(Vector const& r) const override
    {
        Vector const d = r - end1_;
        Real const along = d.dot(axis_), slack = 1e-12 * length_;
        return along >= -slack && along < length_ - slack && (d - along * axis_).norm() <= radius_ * (1 + 1e-12);
    }
    Vector low() const override { return end1_.cwiseMin(end2_) - reach(); }
    Vector high() const override { return end1_.cwiseMax(end2_) + reach(); }
    Real exitDistance(Vector const& r, Vector const& up) const override
    {
        Vector const d = r - end1_;
        Real const along = d.dot(axis_), speed = up.dot(axis_);
        Vector const across = up - speed * axis_;
        Real distance = std::numeric_limits<Real>::infinity();
        if (std::abs(speed) > tiny) distance = ((speed > 0 ? length_ : 0) - along) / speed;
        Real const norm = across.norm();
        if (norm > 1e-12) distance = std::min(distance, wayOutOfBall(d - along * axis_, across / norm, radius_) / norm);
        return std::max(Real(0), distance);
    }

private:
    [[nodiscard]] Vector reach() const { return radius_ * (1 - axis_.array().square()).max(0).sqrt().matrix(); }

    Vector end1_, end2_, axis_;
    Real length_, radius_;
};

/// What a closed surface holds.
class SurfaceRegion : public Region
{
public:
    explicit SurfaceRegion(TriSurface surface)
        : surface_(std::move(surface)),
          columns_(surface_, Vector::UnitZ()),
          low_(surface_.low()),
          high_(surface_.high())
    {}

    bool contains(Vector const& r) const override { return columns_.inside(r); }
    Vector low() const override { return low_; }
    Vector high() const override { return high_; }
    Real exitDistance(Vector const& r, Vector const& up) const override
    {
        if (!along_ || along_->direction() != up) along_ = std::make_unique<SurfaceColumns>(surface_, up);
        return along_->exitDistance(r);
    }

private:
    TriSurface surface_;
    SurfaceColumns columns_;
    mutable std::unique_ptr<SurfaceColumns> along_; ///< The direction asked for last.
    Vector low_, high_;
};

Vector readFinite(Dictionary const& dict, std::string const& key)
{
    Vector const v = dict.get<Vector>(key);
    require(v.allFinite(), dict.where(key), key + " is not finite", "three numbers");
    return v;
}

Real readRadius(Dictionary const& dict) { return readPositive(dict, "radius"); }

std::unique_ptr<Region> makeBox(Dictionary const& dict, RegionCase const& of)
{
    bool const asPair = dict.found("box"), inPlane = of.lattice.dimensions == 2;
    Vector const a = asPair ? readVectorSequence(dict, "box", 2)[0] : readFinite(dict, "min");
    Vector const b = asPair ? readVectorSequence(dict, "box", 2)[1] : readFinite(dict, "max");
    Vector const low = a.cwiseMin(b), size = b.cwiseMax(a) - low;
    if (inPlane)
        warnOfDepth(dict.where(asPair ? "box" : "min"), "the box", size.z(), of.lattice, true);
    else
        require(size.z() > 0 || !(size.x() * size.y() > 0), dict.where(asPair ? "box" : "min"), "a box without extent in z",
                "corners that differ in x, in y and in z; or dimensions 2 in constant/particleProperties");
    return std::make_unique<BoxRegion>(of.lattice.dimensions, inPlane ? flat(low) : low, Vector(size.x(), 0, 0), Vector(0, size.y(), 0),
                                       Vector(0, 0, inPlane ? 1 : size.z()), dict.where(asPair ? "box" : "min"));
}

std::unique_ptr<Region> makeRotatedBox(Dictionary const& dict, RegionCase const& of)
{
    Vector const origin = readFinite(dict, "origin"), i = readFinite(dict, "i"), j = readFinite(dict, "j");
    if (of.lattice.dimensions == 3) return std::make_unique<BoxRegion>(3, origin, i, j, readFinite(dict, "k"), dict.where("i"));
    dict.ignore("k");
    return std::make_unique<BoxRegion>(2, flat(origin), flat(i), flat(j), Vector::UnitZ(), dict.where("i"));
}

std::unique_ptr<Region> makeCylinder(Dictionary const& dict, RegionCase const& of)
{
    Vector const p1 = readFinite(dict, "p1"), p2 = readFinite(dict, "p2");
    if (of.lattice.dimensions == 3)
    {
        require((p2 - p1).norm() > 0, dict.where("p2"), "a cylinder without length", "p1 and p2 that differ");
        return std::make_unique<CylinderRegion>(p1, p2, readRadius(dict));
    }
    require(flat(p1 - p2).norm() < 1e-9 * (1 + p1.norm()), dict.where("p2"), "the axis of a cylinder is not along z",
            "p1 and p2 with the same x and y: a 2-D case sees the disc");
    return std::make_unique<BallRegion>(2, flat(p1), readRadius(dict));
}

std::unique_ptr<Region> makeSphere(Dictionary const& dict, RegionCase const& of)
{
    Vector const centre = readFinite(dict, dict.found("centre") ? "centre" : "origin");
    return std::make_unique<BallRegion>(of.lattice.dimensions, of.lattice.dimensions == 2 ? flat(centre) : centre, readRadius(dict));
}

std::unique_ptr<Region> makeSurface(Dictionary const& dict, RegionCase const& of)
{
    if (of.lattice.dimensions == 2)
        refuseInPlane(dict.where(), "region", "surfaceToParticle",
                      {"boxToParticle", "rotatedBoxToParticle", "cylinderToParticle", "sphereToParticle"}, {"surfaceToParticle"});
    return std::make_unique<SurfaceRegion>(readSurfaceFile(dict, of.folder, "region", Skin::Closed, of.lattice.spacing));
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
        made.add("surfaceToParticle", makeSurface);
        return made;
    }();
    return registry;
}

std::vector<std::unique_ptr<Region>> readRegions(Dictionary const& setParticlesDict, Lattice const& lattice,
                                                 std::filesystem::path const& caseFolder)
{
    RegionCase const of{lattice, caseFolder};
    std::vector<std::unique_ptr<Region>> regions;
    if (!setParticlesDict.found("regions")) return regions;
    for (auto const& [type, dict] : setParticlesDict.getDictList("regions"))
    {
        auto region = regionRegistry().make(type, dict.where(), dict, of);
        region->type = type;
        region->where = dict.where();
        region->values = readFieldValues(dict, "fieldValues", lattice.dimensions);
        regions.push_back(std::move(region));
    }
    return regions;
}

} // namespace mpsDem
