#include "postGauges/Slice.h"

#include <algorithm>
#include <cmath>

#include "postGauges/Axes.h"
#include "postGauges/BodySkin.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

Slice Slice::read(Dictionary const& dict)
{
    Slice slice;
    if (!dict.found("slice")) return slice;
    slice.limited_ = true;
    if (!dict.isDict("slice"))
    {
        auto const range = readRange(dict, "slice");
        slice.point_ = Vector(0, 0, 0.5 * (range->first + range->second));
        slice.thickness_ = range->second - range->first;
        return slice;
    }
    Dictionary const plane = dict.subDict("slice");
    auto const normal = plane.getOr<Vector>("normal", Vector::UnitZ());
    require(normal.allFinite() && normal.norm() > 0, plane.where("normal"), "the normal of the slice is zero", "normal (0 0 1);");
    slice.normal_ = normal.normalized();
    if (plane.found("point")) slice.point_ = plane.get<Vector>("point");
    if (plane.found("thickness")) slice.thickness_ = plane.getInRange("thickness", 1e-12, 1e12);
    return slice;
}

Slice Slice::completed(PostCase const& postCase, ParticleFrame const& frame) const
{
    Slice slice = *this;
    if (postCase.dimensions == 2 && !limited_) return slice;
    slice.limited_ = true;
    Vector low = Vector::Constant(1e300), high = -low;
    for (Vector const& r : frame.data.position)
    {
        low = low.cwiseMin(r);
        high = high.cwiseMax(r);
    }
    if (!slice.point_) slice.point_ = frame.data.position.empty() ? Vector(Vector::Zero()) : Vector(0.5 * (low + high));
    if (!slice.thickness_) slice.thickness_ = 2 * postCase.requireSpacing();
    bool const lying = std::abs(normal_.dot(postCase.up)) > 0.99; // seen from above or below
    slice.right_ = lying ? Vector(Vector::UnitX() - normal_.x() * normal_) : Vector(postCase.up.cross(normal_));
    if (slice.right_.norm() < 1e-3) slice.right_ = Vector::UnitZ() - normal_.z() * normal_;
    slice.right_.normalize();
    slice.upward_ = normal_.cross(slice.right_);
    return slice;
}

std::vector<std::size_t> Slice::particles(ParticleFrame const& frame) const
{
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < frame.data.position.size(); ++i)
        if (holds(frame.data.position[i])) held.push_back(i);
    if (limited_)
        std::stable_sort(held.begin(), held.end(), [&](std::size_t a, std::size_t b) {
            return frame.data.position[a].dot(normal_) < frame.data.position[b].dot(normal_);
        });
    return held;
}

std::vector<std::vector<Vector>> Slice::outlines(std::vector<std::vector<Vector>> const& polygons) const
{
    auto const flat = [&](std::vector<Vector> const& polygon) {
        return std::all_of(polygon.begin(), polygon.end(), [&](Vector const& r) { return r.z() == polygon.front().z(); });
    };
    // Outlines of a 2-D case lie in its plane.
    bool const planar = std::all_of(polygons.begin(), polygons.end(), flat);
    auto chains = limited_ && !planar ? cutChains(polygons, {*point_, normal_}) : polygons;
    for (auto& chain : chains)
        for (Vector& r : chain) r = place(r);
    return chains;
}

std::string Slice::label(Vector const& axis)
{
    for (int d = 0; d < 3; ++d)
        if (std::abs(axis[d]) > 1 - 1e-9) return std::string(1, "xyz"[d]) + " [m]";
    return "[m]";
}

std::string Slice::tics(Window const& window) const
{
    std::string commands;
    auto const add = [&commands](char const* name, Vector const& axis, Real low, Real high) {
        if (axis.minCoeff() > -1 + 1e-9) return;
        commands += std::string("set ") + name + " (";
        char const* separator = "";
        for (Real const value : niceTics(low, high, 7))
        {
            commands += separator + quoted(number(value == 0 ? 0 : -value)) + ' ' + number(value, 12);
            separator = ", ";
        }
        commands += ")\n";
    };
    add("xtics", right_, window.xLow, window.xHigh);
    add("ytics", upward_, window.yLow, window.yHigh);
    return commands;
}

} // namespace mpsDem::postGauges
