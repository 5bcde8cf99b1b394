#include "postGauges/Camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mpsDem::postGauges {

namespace {

constexpr Real degree = std::numbers::pi / 180;

} // namespace

CameraControls CameraControls::read(Dictionary const& dict)
{
    CameraControls controls;
    controls.azimuth = dict.getInRangeOr("azimuth", controls.azimuth, -360, 360);
    controls.elevation = dict.getInRangeOr("elevation", controls.elevation, -90, 90);
    controls.perspective = dict.getWordOr("projection", "perspective", {"perspective", "orthographic"}, "projections") == "perspective";
    controls.fieldOfView = dict.getInRangeOr("fieldOfView", controls.fieldOfView, 1, 120);
    controls.zoom = dict.getInRangeOr("zoom", controls.zoom, 0.01, 100);
    if (dict.found("focus")) controls.focus = dict.get<Vector>("focus");
    return controls;
}

Vector SpaceBox::corner(int i) const
{
    return {(i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(), (i & 4) != 0 ? high.z() : low.z()};
}

Camera::Camera(CameraControls const& controls, Vector const& up, SpaceBox const& box) : perspective_(controls.perspective)
{
    Vector const first = std::abs(up.x()) < 0.9 ? Vector::UnitX() : Vector::UnitZ();
    Vector const across = (first - first.dot(up) * up).normalized(), front = across.cross(up);
    Real const a = controls.azimuth * degree, e = controls.elevation * degree;
    Vector const level = std::cos(a) * front + std::sin(a) * across;
    right_ = std::cos(a) * across - std::sin(a) * front;
    backward_ = std::cos(e) * level + std::sin(e) * up;
    upward_ = backward_.cross(right_);
    Vector const middle = 0.5 * (box.low + box.high);
    focus_ = controls.focus.value_or(middle);
    Real const radius = 0.5 * (box.high - box.low).norm() + (focus_ - middle).norm();
    distance_ = radius * (1 + 1 / std::tan(0.5 * controls.fieldOfView * degree));
    window_ = {1e300, -1e300, 1e300, -1e300};
    for (int i = 0; i < 8; ++i)
    {
        Point const p = project(box.corner(i));
        window_ = {std::min(window_.xLow, p.u), std::max(window_.xHigh, p.u), std::min(window_.yLow, p.v), std::max(window_.yHigh, p.v)};
    }
    Real const width = (window_.xHigh - window_.xLow) / controls.zoom, height = (window_.yHigh - window_.yLow) / controls.zoom;
    Real const u = controls.focus ? 0 : 0.5 * (window_.xLow + window_.xHigh), v = controls.focus ? 0 : 0.5 * (window_.yLow + window_.yHigh);
    window_ = {u - 0.5 * width, u + 0.5 * width, v - 0.5 * height, v + 0.5 * height};
}

Camera::Point Camera::project(Vector const& r) const
{
    Vector const d = r - focus_;
    Real const x = d.dot(right_), y = d.dot(upward_), towards = d.dot(backward_);
    if (!perspective_) return {x, y, towards};
    Real const depth = std::max(distance_ - towards, 1e-3 * distance_);
    return {distance_ * x / depth, distance_ * y / depth, 1 / depth};
}

Vector Camera::place(Real u, Real v, Real nearness) const
{
    if (!perspective_) return {u, v, nearness};
    Real const depth = 1 / nearness;
    return {u * depth / distance_, v * depth / distance_, distance_ - depth};
}

Vector Camera::toViewer(Vector const& r) const
{
    return perspective_ ? Vector((focus_ + distance_ * backward_ - r).normalized()) : backward_;
}

} // namespace mpsDem::postGauges
