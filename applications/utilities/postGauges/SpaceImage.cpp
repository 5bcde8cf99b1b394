#include "postGauges/SpaceImage.h"

#include <algorithm>
#include <cmath>

namespace mpsDem::postGauges {

namespace {

constexpr Real mostSamples = 6e7; ///< Beyond this a pixel has one: memory.

Vector pick(DrawnMesh const& mesh, int i) { return mesh.points[static_cast<std::size_t>(i)]; }

Colour mixed(DrawnMesh const& mesh, std::array<int, 3> const& triangle, std::array<Real, 3> const& share)
{
    if (mesh.colours.size() == 1) return mesh.colours.front();
    Colour colour{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t c = 0; c < 3; ++c)
            colour[c] += static_cast<float>(share[k]) * mesh.colours[static_cast<std::size_t>(triangle[k])][c];
    return colour;
}

Vector mixedNormal(DrawnMesh const& mesh, std::array<int, 3> const& triangle, std::array<Real, 3> const& share, Vector const& flat)
{
    if (mesh.normals.empty()) return flat;
    Vector normal = Vector::Zero();
    for (std::size_t k = 0; k < 3; ++k) normal += share[k] * mesh.normals[static_cast<std::size_t>(triangle[k])];
    Real const length = normal.norm();
    return length > 1e-12 ? Vector(normal / length) : flat;
}

} // namespace

void SpaceImage::Layer::resize(std::size_t samples)
{
    nearness.assign(samples, empty);
    normal.assign(samples, {});
    colour.assign(samples, {});
}

SpaceImage::SpaceImage(Camera const& camera, Window const& window, int width, int height)
    : camera_(camera),
      window_(window),
      width_(width),
      height_(height),
      perPixel_(4.0 * width * height > mostSamples ? 1 : 2),
      columns_(perPixel_ * width),
      rows_(perPixel_ * height),
      samplesAMetre_(columns_ / (window.xHigh - window.xLow))
{
    solid_.resize(at(0, rows_));
}

SpaceImage::Corner SpaceImage::corner(Vector const& r) const
{
    auto const p = camera_.project(r);
    return {(p.u - window_.xLow) * samplesAMetre_, (p.v - window_.yLow) * samplesAMetre_, p.nearness};
}

SpaceImage::Side::Side(Corner const& a, Corner const& b, Real turn)
{
    // From the same end whichever triangle asks: two that share the side get the same number with opposite signs.
    bool const swapped = b.x != a.x ? b.x < a.x : b.y < a.y;
    Corner const& from = swapped ? b : a;
    Corner const& to = swapped ? a : b;
    sign = swapped ? -turn : turn;
    x = from.x;
    y = from.y;
    dx = to.x - from.x;
    dy = to.y - from.y;
}

template <class Visit>
void SpaceImage::forEachSample(std::array<Corner, 3> const& c, Visit visit) const
{
    Real const area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
    if (area == 0) return;
    auto const [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
    auto const [low, high] = std::minmax({c[0].y, c[1].y, c[2].y});
    if (!(right >= 0 && left <= columns_ && high >= 0 && low <= rows_)) return;
    auto const first = [](Real place) { return static_cast<int>(std::ceil(std::max(place, 0.0) - 0.5)); };
    auto const last = [](Real place, int count) { return static_cast<int>(std::floor(std::min<Real>(place, count) - 0.5)); };
    Real const turn = area > 0 ? 1 : -1;
    std::array<Side, 3> const sides = {Side(c[1], c[2], turn), Side(c[2], c[0], turn), Side(c[0], c[1], turn)};
    for (int y = first(low); y <= last(high, rows_); ++y)
        for (int x = first(left); x <= last(right, columns_); ++x)
        {
            std::array<Real, 3> share{};
            bool inside = true;
            for (std::size_t k = 0; k < 3 && inside; ++k)
            {
                share[k] = sides[k].cross(x + 0.5, y + 0.5) / std::abs(area);
                inside = share[k] > 0 || (share[k] == 0 && sides[k].sign > 0);
            }
            if (!inside) continue;
            visit(at(x, y), static_cast<float>(share[0] * c[0].nearness + share[1] * c[1].nearness + share[2] * c[2].nearness), share);
        }
}

/// visit(triangle, corners, flat normal, whether it faces the viewer)
template <class Visit>
void SpaceImage::forEachTriangle(DrawnMesh const& mesh, Visit visit) const
{
    for (auto const& triangle : mesh.triangles)
    {
        Vector const a = pick(mesh, triangle[0]), b = pick(mesh, triangle[1]), c = pick(mesh, triangle[2]);
        Vector const normal = (b - a).cross(c - a).normalized();
        visit(triangle, std::array<Corner, 3>{corner(a), corner(b), corner(c)}, normal, normal.dot(camera_.toViewer(a)) > 0);
    }
}

void SpaceImage::put(Layer& layer, std::size_t sample, float nearness, Vector const& normal, Colour const& colour)
{
    layer.nearness[sample] = nearness;
    layer.normal[sample] = {static_cast<float>(normal.x()), static_cast<float>(normal.y()), static_cast<float>(normal.z())};
    layer.colour[sample] = colour;
}

void SpaceImage::addSolid(DrawnMesh const& mesh, Faces faces)
{
    forEachTriangle(mesh, [&](auto const& triangle, auto const& corners, Vector const& flat, bool towards) {
        if (!towards && faces == Faces::TowardsViewer) return;
        Real const side = towards ? 1 : -1;
        forEachSample(corners, [&](std::size_t sample, float nearness, std::array<Real, 3> const& share) {
            if (nearness <= solid_.nearness[sample]) return;
            put(solid_, sample, nearness, side * mixedNormal(mesh, triangle, share, flat), mixed(mesh, triangle, share));
        });
    });
}

void SpaceImage::addSphere(Vector const& centre, Real radius, Colour const& colour)
{
    auto const middle = corner(centre);
    Real const size = radius * camera_.magnification(middle.nearness) * samplesAMetre_, depth = camera_.depth(middle.nearness);
    int const xFirst = std::max(0, static_cast<int>(std::ceil(middle.x - size - 0.5))),
              yFirst = std::max(0, static_cast<int>(std::ceil(middle.y - size - 0.5)));
    int const xLast = static_cast<int>(std::min(columns_ - 1.0, std::floor(middle.x + size - 0.5)));
    int const yLast = static_cast<int>(std::min(rows_ - 1.0, std::floor(middle.y + size - 0.5)));
    for (int y = yFirst; y <= yLast; ++y)
        for (int x = xFirst; x <= xLast; ++x)
        {
            Real const a = (x + 0.5 - middle.x) / size, b = (y + 0.5 - middle.y) / size, rest = 1 - a * a - b * b;
            if (rest <= 0) continue;
            Real const c = std::sqrt(rest);
            auto const nearness = static_cast<float>(camera_.nearness(depth - radius * c));
            std::size_t const sample = at(x, y);
            if (nearness <= solid_.nearness[sample]) continue;
            put(solid_, sample, nearness, a * camera_.right() + b * camera_.upward() + c * camera_.backward(), colour);
        }
}

void SpaceImage::addWater(DrawnMesh const& mesh, WaterLook const& look)
{
    look_ = look;
    if (thickness_.empty())
    {
        thickness_.assign(solid_.nearness.size(), 0.0F);
        water_.resize(solid_.nearness.size());
    }
    forEachTriangle(mesh, [&](auto const& triangle, auto const& corners, Vector const& flat, bool towards) {
        float const sign = towards ? -1.0F : 1.0F;
        forEachSample(corners, [&](std::size_t sample, float nearness, std::array<Real, 3> const& share) {
            float const seen = std::max(nearness, solid_.nearness[sample]); // what is behind a solid counts as at its skin
            thickness_[sample] += sign * static_cast<float>(camera_.depth(seen));
            if (!towards || nearness <= std::max(water_.nearness[sample], solid_.nearness[sample])) return;
            put(water_, sample, nearness, mixedNormal(mesh, triangle, share, flat), mixed(mesh, triangle, share));
        });
    });
}

void SpaceImage::addLine(Vector const& from, Vector const& to, Colour const& colour, Real width)
{
    lines_.push_back({corner(from), corner(to), colour, width * perPixel_});
}

} // namespace mpsDem::postGauges
