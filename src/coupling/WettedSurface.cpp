#include "coupling/WettedSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "parallel/Reduce.h"
#include "particles/Kernel.h"

namespace mpsDem {

namespace {

/// A fluid particle counts for a point only where it is this far in front of it, in spacings.
constexpr Real inFront = 0.1;
/// Wall particles count where their normal agrees with that of the point to this cosine.
constexpr Real likeNormal = 0.5;
/// Points of a contact face in 3-D that are nearer than this are connected, in spacings.
constexpr Real poreReach = 2.1;
/// A wall particle of another solid that faces a point within this distance covers it, in spacings, unless fluid is between: this much
/// nearer to the surface than that wall particle.
constexpr Real coverReach = 1.5;
/// It covers what lies behind it, not what is farther than this aside. The sharp tip of a wedge has no wall particles: 0.75 took what lies
/// under it for wet, and the momentum budget of a slide missed twice as much.
constexpr Real coverAside = 1.25;
constexpr Real between = 0.25;
/// Longest edge of a piece of a triangle, in spacings: two pieces of a square of one spacing.
constexpr Real longestEdge = 1.4143;

} // namespace

WettedSurface::WettedSurface(Surface const& outline, Lattice const& lattice, int body)
    : lattice_(lattice),
      body_(body),
      closed_(outline.closed())
{
    if (outline.flat())
        addSegments(outline.line());
    else
        addTriangles(outline.triangles());
    position_ = localPosition_;
    normal_ = localNormal_;
    pressure_.assign(position_.size(), 0);
    wet_.assign(position_.size(), 0);
}

void WettedSurface::addSegments(Polyline const& line)
{
    for (Polyline::Segment const& segment : line.segments())
    {
        int const pieces = std::max(1, static_cast<int>(std::ceil(segment.length / lattice_.spacing - 1e-9)));
        Real const length = segment.length / pieces;
        for (int k = 0; k < pieces; ++k)
        {
            localPosition_.push_back(segment.a + (k + 0.5) * length * segment.tangent);
            localNormal_.push_back(segment.normal);
            area_.push_back(length * lattice_.thickness);
        }
    }
}

void WettedSurface::addTriangles(TriSurface const& triangles)
{
    std::vector<std::array<Vector, 3>> pieces;
    for (TriSurface::Triangle const& t : triangles.triangles())
    {
        pieces.assign(1, {triangles.point(t, 0), triangles.point(t, 1), triangles.point(t, 2)});
        while (!pieces.empty())
        {
            std::array<Vector, 3> const piece = pieces.back();
            pieces.pop_back();
            int longest = 0;
            auto const side = [&](int k) { return (piece[(k + 1) % 3] - piece[k]).norm(); };
            for (int const k : {1, 2})
                if (side(k) > side(longest) * (1 + 1e-12)) longest = k;
            Vector const a = piece[longest], b = piece[(longest + 1) % 3], c = piece[(longest + 2) % 3];
            if (side(longest) > lattice_.spacing * longestEdge)
            {
                Vector const middle = 0.5 * (a + b);
                pieces.push_back({middle, b, c});
                pieces.push_back({a, middle, c});
                continue;
            }
            localPosition_.push_back((a + b + c) / 3);
            localNormal_.push_back(t.normal);
            area_.push_back(0.5 * (b - a).cross(c - a).norm());
        }
    }
}

void WettedSurface::place(Tensor const& rotation, Vector const& centre)
{
    for (std::size_t s = 0; s < position_.size(); ++s)
    {
        position_[s] = centre + rotation * localPosition_[s];
        normal_[s] = rotation * localNormal_[s];
    }
}

void WettedSurface::evaluatePoint(ParticleSet const& particles, CellGrid const& grid, Field<Real> const& pressure, Real slope,
                                  PressureIntegrationControls const& controls, std::size_t s)
{
    Kernel const w{controls.radius};
    Real const wetRadius2 = controls.wetRadius * controls.wetRadius;
    Vector const normal = normal_[s];
    Real weight = 0, sum = 0;
    bool wet = false;
    grid.forEachWithin(position_[s], controls.radius, [&](int j, Vector const& rsj, Real r2) {
        Real const off = rsj.dot(normal);
        if (particles.isFluid(j))
        {
            if (off <= inFront * lattice_.spacing) return;
            wet = wet || r2 < wetRadius2;
        }
        else
        {
            bool const donor = particles.type[j] == ParticleType::Wall && particles.wet[j] && particles.body[j] == body_ &&
                               particles.normal[j].dot(normal) >= likeNormal;
            if (!donor) return;
        }
        Real const wsj = w(std::sqrt(r2));
        weight += wsj;
        sum += wsj * (pressure[j] - slope * off);
    });
    wet_[s] = wet;
    pressure_[s] = wet && weight > 0 ? sum / weight : 0;
    if (controls.positiveOnly) pressure_[s] = std::max(pressure_[s], Real(0));
}

bool WettedSurface::facesSolid(ParticleSet const& particles, CellGrid const& grid, std::size_t s, Real reach) const
{
    bool found = false;
    grid.forEachWithin(position_[s], reach, [&](int j, Vector const& rsj, Real) {
        found = found || (particles.type[j] == ParticleType::Wall && particles.body[j] != body_ && rsj.dot(normal_[s]) > 0 &&
                          particles.normal[j].dot(normal_[s]) <= -likeNormal);
    });
    return found;
}

void WettedSurface::fillFromRims(ParticleSet const& particles, CellGrid const& grid, Real reach)
{
    if (lattice_.dimensions == 2) return fillBetweenRims(particles, grid, reach);
    if (!pores_) pores_.emplace(localPosition_, localNormal_, area_, poreReach * lattice_.spacing);
    Field<std::uint8_t> face(position_.size());
    for (std::size_t s = 0; s < face.size(); ++s) face[s] = !wet_[s] && facesSolid(particles, grid, s, reach);
    pores_->fill(face, pressure_);
}

void WettedSurface::fillBetweenRims(ParticleSet const& particles, CellGrid const& grid, Real reach)
{
    // Runs of dry points between two wet ones, along the outline: pressure linear in arc length from rim to rim.
    std::size_t const count = position_.size();
    auto const firstWet = std::find(wet_.begin(), wet_.end(), 1);
    if (!closed_ || firstWet == wet_.end()) return;
    std::size_t const start = static_cast<std::size_t>(firstWet - wet_.begin());
    std::size_t rim = start;
    for (std::size_t step = 1; step <= count; ++step)
    {
        std::size_t const s = (start + step) % count;
        if (!wet_[s]) continue;
        std::size_t const dry = (s + count - rim) % count == 0 ? count - 1 : (s + count - rim) % count - 1;
        for (std::size_t k = 1; k <= dry; ++k)
        {
            std::size_t const q = (rim + k) % count;
            if (!facesSolid(particles, grid, q, reach)) continue;
            Real const share = static_cast<Real>(k) / static_cast<Real>(dry + 1);
            pressure_[q] = (1 - share) * pressure_[rim] + share * pressure_[s];
        }
        rim = s;
    }
}

void WettedSurface::findOtherSides()
{
    std::size_t const count = localPosition_.size();
    otherSide_.assign(count, -1);
    for (std::size_t s = 0; s < count; ++s)
    {
        Real nearest = std::numeric_limits<Real>::max();
        for (std::size_t q = 0; q < count; ++q)
        {
            Vector const way = localPosition_[q] - localPosition_[s];
            Real const off = way.dot(localNormal_[s]), aside = (way - off * localNormal_[s]).norm();
            if (off >= 0 || localNormal_[q].dot(localNormal_[s]) >= 0 || aside >= nearest) continue;
            nearest = aside;
            otherSide_[s] = static_cast<int>(q);
        }
    }
}

void WettedSurface::fillFromOtherSide(ParticleSet const& particles, CellGrid const& grid, Real reach, Vector const& weight)
{
    if (otherSide_.size() != position_.size()) findOtherSides();
    for (std::size_t s = 0; s < position_.size(); ++s)
    {
        int const q = otherSide_[s];
        if (wet_[s] || q < 0 || !wet_[static_cast<std::size_t>(q)] || !facesSolid(particles, grid, s, reach)) continue;
        pressure_[s] = pressure_[static_cast<std::size_t>(q)] + weight.dot(position_[s] - position_[static_cast<std::size_t>(q)]);
    }
}

void WettedSurface::dryContactFaces(ParticleSet const& particles, CellGrid const& grid)
{
    for (std::size_t s = 0; s < position_.size(); ++s)
    {
        if (!wet_[s] && pressure_[s] == 0) continue;
        Real const reach = coverReach * lattice_.spacing, aside = coverAside * lattice_.spacing;
        Real cover = 2 * reach, lowestFluid = 2 * reach;
        grid.forEachWithin(position_[s], reach, [&](int j, Vector const& rsj, Real) {
            Real const off = rsj.dot(normal_[s]);
            if (particles.isFluid(j))
            {
                if (off > inFront * lattice_.spacing) lowestFluid = std::min(lowestFluid, off);
            }
            else if (particles.type[j] == ParticleType::Wall && particles.body[j] != body_ &&
                     particles.normal[j].dot(normal_[s]) <= -likeNormal && (rsj - off * normal_[s]).norm() < aside)
                cover = std::min(cover, std::abs(off));
        });
        if (cover > reach || lowestFluid < cover - between * lattice_.spacing) continue;
        wet_[s] = 0;
        pressure_[s] = 0;
    }
}

Load WettedSurface::integrate(Vector const& centre) const
{
    Load load;
    for (std::size_t s = 0; s < position_.size(); ++s) load.add(-pressure_[s] * area_[s] * normal_[s], position_[s] - centre);
    return {sumOverRanks(load.force), sumOverRanks(load.moment)};
}

} // namespace mpsDem
