#include "functionObjects/SurfaceElevation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mpsDem {

namespace {

constexpr Real linkDistance = 1.5; ///< Spacings: the first ring of a disturbed lattice, not the second.
constexpr Real depth = 3;          ///< Spacings below the top that the volume method looks at: boundary rows are that thick.

constexpr Real kernelRadius = 2.5; ///< Spacings.

/// Wendland's C2 kernel of radius R with integral 1: 7/(pi R^2) (1-q)^4 (1+4q) in 2-D, 21/(2 pi R^3) (1-q)^4 (1+4q) in 3-D, q = r/R.
Real wendland(Real r, Real radius, int dimensions)
{
    Real const q = r / radius;
    if (q >= 1) return 0;
    Real const factor = dimensions == 2 ? 7 / (std::numbers::pi * radius * radius) : 21 / (2 * std::numbers::pi * radius * radius * radius);
    return factor * std::pow(1 - q, 4) * (1 + 4 * q);
}

/// Length of [a - h, a + h] within [-w, w].
Real overlap(Real a, Real h, Real w) { return std::max(0.0, std::min(a + h, w) - std::max(a - h, -w)); }

} // namespace

SurfaceElevationControls SurfaceElevationControls::read(Dictionary const& dict)
{
    SurfaceElevationControls controls = readDrops(dict);
    controls.method = dict.getWordOr("method", "volume", {"volume", "top"}, "methods") == "top" ? Method::Top : Method::Volume;
    controls.width = dict.getInRangeOr("width", 2, 1, 20);
    return controls;
}

SurfaceElevationControls SurfaceElevationControls::readDrops(Dictionary const& dict)
{
    SurfaceElevationControls controls;
    controls.splash = static_cast<int>(dict.getInRangeOr("splash", 20, 1, 1e6));
    controls.zero = dict.getOr<Real>("zero", 0);
    return controls;
}

std::string SurfaceElevationControls::str() const
{
    std::string const columns = ", column of " + std::to_string(width).substr(0, 4) + " spacings";
    return (method == Method::Volume ? "method volume" + columns : std::string("method top, kernel of 2.5 spacings")) +
           ", groups of fewer than " + std::to_string(splash) + " particles are not seen";
}

SurfaceElevation::SurfaceElevation(ParticleSet const& particles, SurfaceElevationControls const& controls, Vector const& up)
    : particles_(particles),
      controls_(controls),
      up_(up)
{
    Vector const aside = std::abs(up.z()) < 0.9 ? Vector::UnitZ() : Vector::UnitY();
    across_ = up.cross(aside).normalized();
    along_ = particles.lattice().dimensions == 2 ? Vector(Vector::Zero()) : Vector(up.cross(across_));
}

Vector SurfaceElevation::project(Vector const& r) const { return {r.dot(across_), r.dot(along_), 0}; }

void SurfaceElevation::update()
{
    fluid_.clear();
    projected_.clear();
    height_.clear();
    for (int i : particles_.fluid()) fluid_.push_back(particles_.r[i]);
    auto const add = [this](Vector const& r) {
        projected_.push_back(project(r));
        height_.push_back(r.dot(up_));
    };
    for (Vector const& r : fluid_) add(r);
    for (int i : particles_.boundary()) add(particles_.r[i]);
    Real const spacing = particles_.lattice().spacing;
    fluidGrid_.build(fluid_, linkDistance * spacing, particles_.lattice().dimensions);
    columnGrid_.build(projected_, spacing, 2);
}

std::pair<Real, Real> SurfaceElevation::extent(Vector const& direction) const
{
    if (fluid_.empty()) return {0, 0};
    Real low = fluid_.front().dot(direction), high = low;
    for (Vector const& r : fluid_)
    {
        low = std::min(low, r.dot(direction));
        high = std::max(high, r.dot(direction));
    }
    return {low, high};
}

std::vector<SurfaceElevation::Member> SurfaceElevation::near(Vector const& centre, Real reach) const
{
    std::vector<Member> members;
    columnGrid_.forEachRun(centre, reach, [&](int first, int last) {
        for (int slot = first; slot < last; ++slot)
        {
            int const i = columnGrid_.order()[slot];
            Vector const d = columnGrid_.sortedPositions()[slot] - centre;
            bool const isFluid = i < static_cast<int>(fluid_.size());
            if (d.lpNorm<Eigen::Infinity>() < reach) members.push_back({d, height_[i], isFluid ? i : -1});
        }
    });
    std::sort(members.begin(), members.end(),
              [](Member const& a, Member const& b) { return a.height != b.height ? a.height > b.height : a.fluid < b.fluid; });
    return members;
}

Real SurfaceElevation::share(Member const& member) const
{
    Real const half = 0.5 * particles_.lattice().spacing, halfWidth = controls_.width * half;
    Real const first = overlap(member.aside.x(), half, halfWidth) / (2 * half);
    return particles_.lattice().dimensions == 2 ? first : first * overlap(member.aside.y(), half, halfWidth) / (2 * half);
}

std::vector<SurfaceElevation::Member> SurfaceElevation::filled(std::vector<Member> const& all) const
{
    Real const spacing = particles_.lattice().spacing;
    std::vector<Member> members;
    Real lowest = 0;
    for (auto m = all.begin(); m != all.end(); ++m)
    {
        if (!members.empty() && m->height < lowest) break;
        bool const seen = m->fluid < 0 ? !members.empty() : !isDrop(m->fluid);
        if (!seen || (members.empty() && share(*m) <= 0)) continue;
        if (members.empty()) lowest = m->height - (depth + 2 * kernelRadius) * spacing;
        members.push_back(*m);
    }
    return members;
}

bool SurfaceElevation::isDrop(int fluid) const
{
    std::size_t const needed = std::min(static_cast<std::size_t>(controls_.splash), fluid_.size());
    std::vector<int> group{fluid};
    Real const reach = linkDistance * particles_.lattice().spacing;
    for (std::size_t k = 0; k < group.size() && group.size() < needed; ++k)
    {
        fluidGrid_.forEachWithin(fluid_[group[k]], reach, [&group](int j, Vector const&, Real) {
            if (std::find(group.begin(), group.end(), j) == group.end()) group.push_back(j);
        });
    }
    return group.size() < needed;
}

std::optional<Real> SurfaceElevation::elevation(Vector const& location) const
{
    Real const spacing = particles_.lattice().spacing;
    bool const byVolumes = controls_.method == SurfaceElevationControls::Method::Volume;
    Real const columnReach = 0.5 * (controls_.width + 1) * spacing;
    std::vector<Member> const members =
        filled(near(project(location), byVolumes ? columnReach : std::max(columnReach, kernelRadius * spacing)));
    if (members.empty()) return std::nullopt;
    return (byVolumes ? byVolume(members) : byFill(members)) - controls_.zero;
}

Real SurfaceElevation::byVolume(std::vector<Member> const& members) const
{
    Real const spacing = particles_.lattice().spacing;
    Real const base = members.front().height + (0.5 - depth) * spacing;
    Real volume = 0; // in columns' bases times metres
    for (Member const& m : members) volume += share(m) * std::clamp(m.height + 0.5 * spacing - base, 0.0, spacing);
    return base + volume / std::pow(controls_.width, particles_.lattice().dimensions - 1);
}

Real SurfaceElevation::byFill(std::vector<Member> const& members) const
{
    int const dimensions = particles_.lattice().dimensions;
    Real const spacing = particles_.lattice().spacing, top = members.front().height;
    auto const fill = [&](Real height) {
        Real sum = 0;
        for (Member const& m : members)
            sum += wendland(std::hypot(m.aside.x(), m.aside.y(), m.height - height) / spacing, kernelRadius, dimensions);
        return sum;
    };
    Real low = top + spacing;
    while (fill(low) < 0.5 && low > top - 4 * spacing) low -= 0.25 * spacing;
    if (low <= top - 4 * spacing) return top + 0.5 * spacing; // a layer too thin to fill half of the kernel
    Real high = low + 0.25 * spacing;
    for (int i = 0; i < 40; ++i)
    {
        Real const middle = 0.5 * (low + high);
        (fill(middle) < 0.5 ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace mpsDem
