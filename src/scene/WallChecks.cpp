#include "scene/WallChecks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "boundaries/SurfaceTree.h"
#include "core/Errors.h"
#include "scene/SurfaceRays.h"

namespace mpsDem {

namespace {

constexpr Real thinnest = 2;      ///< Walls, in spacings.
constexpr Real opposite = -0.95;  ///< Cosine between the normals of two sides of a wall.
constexpr Real fewestAcross = 3;  ///< A finding has to be that many spacings long (2-D) or that squared wide (3-D).
constexpr Real mostDown = 0.5;    ///< Share of what a wall covers from above, from which on it faces down.
constexpr int mostParts = 200;    ///< Samples along a side of a triangle or segment.
constexpr Real stride = 8;        ///< Of a search downwards or aside, in spacings.
constexpr Real overlap = 1e-3;    ///< Of its strides, in spacings: a wall where two of them meet counts.
constexpr int mostStrides = 1000; ///< Of the same.
constexpr int mostUnheld = 2;     ///< So many may be lost before a run ends.
constexpr int mostAsked = 5000;   ///< Particles about a wall beside them.
constexpr Real leastOpen = 0.02;  ///< Share of these that an open side leaves without one.
constexpr Real straight = 0.9;    ///< Cosine below which an axis is across gravity.

/// A piece of a wall.
struct Sample
{
    Vector r, normal;
    Real size; ///< Length (2-D) or area (3-D) over spacing to that power.
};

int parts(Real length, Real spacing) { return std::clamp(static_cast<int>(std::ceil(length / spacing)), 1, mostParts); }

template <class Visit>
void forEachSample(Surface const& surface, Real spacing, Visit visit)
{
    if (surface.flat())
    {
        for (auto const& segment : surface.line().segments())
        {
            int const count = parts(segment.length, spacing);
            for (int i = 0; i < count; ++i)
                visit(Sample{segment.a + ((i + 0.5) / count) * (segment.b - segment.a), segment.normal, segment.length / count / spacing});
        }
        return;
    }
    TriSurface const& mesh = surface.triangles();
    for (auto const& t : mesh.triangles())
    {
        Vector const a = mesh.point(t, 0), b = mesh.point(t, 1) - a, c = mesh.point(t, 2) - a;
        int const count = parts(std::max({b.norm(), c.norm(), (b - c).norm()}), 2 * spacing);
        Real const size = t.area / (count * count * spacing * spacing);
        auto const at = [&](Real s, Real u) { visit(Sample{a + (s / count) * b + (u / count) * c, t.normal, size}); };
        for (int j = 0; j < count; ++j)
            for (int i = 0; i + j < count; ++i)
            {
                at(i + 1 / 3.0, j + 1 / 3.0);
                if (i + j + 1 < count) at(i + 2 / 3.0, j + 2 / 3.0);
            }
    }
}

std::string placeText(Vector const& r)
{
    return "(" + shortNumber(r.x(), 4) + " " + shortNumber(r.y(), 4) + " " + shortNumber(r.z(), 4) + ") m";
}

std::string wayText(Vector const& way)
{
    auto const number = [](Real value) { return shortNumber(std::abs(value) < 1e-9 ? 0 : value, 3); };
    return "(" + number(way.x()) + " " + number(way.y()) + " " + number(way.z()) + ")";
}

class WallChecks
{
public:
    WallChecks(SceneDefinition const& definition, InitialScene const& scene)
        : definition_(definition),
          scene_(scene),
          spacing_(definition.lattice.spacing),
          large_(std::pow(fewestAcross, definition.lattice.dimensions - 1))
    {
        Real const g = definition.gravity.norm();
        if (g > 0) down_ = definition.gravity / g;
    }

    std::vector<std::string> run()
    {
        if (scene_.surfaces.empty() || scene_.particles.fluid().size() == 0) return {};
        findBacks();
        findThin();
        if (down_.isZero()) return findings_;
        holders_ = scene_.surfaces;
        holders_.insert(holders_.end(), scene_.placed.begin(), scene_.placed.end());
        rays_.emplace(holders_);
        findUnheld();
        findOpenSides();
        return findings_;
    }

private:
    /// Height of the regions over a place; 0 without.
    [[nodiscard]] Real heightOver(Vector const& r, Vector const& up) const
    {
        return std::max(Real(0), depthInRegions(definition_.regions, r, up, spacing_));
    }

    void findBacks()
    {
        if (down_.isZero()) return;
        for (Surface const& wall : scene_.surfaces)
        {
            if (wall.closed()) continue;
            Real down = 0, across = 0, above = 0, below = 0;
            forEachSample(wall, spacing_, [&](Sample const& sample) {
                Real const share = sample.size * sample.normal.dot(down_);
                down += share;
                across += std::abs(share);
            });
            if (!(down > mostDown * across) || across < large_) continue;
            forEachSample(wall, spacing_, [&](Sample const& sample) {
                Real const size = sample.size * std::abs(sample.normal.dot(down_));
                above += size * heightOver(sample.r - 0.5 * spacing_ * down_, -down_);
                below += size * heightOver(sample.r + 0.5 * spacing_ * down_, down_);
            });
            if (above > below)
                findings_.push_back("wall \"" + wall.name() +
                                    "\" turns its back on the fluid: it faces down, and more of the regions lies " +
                                    "above than below it; is its fluidSide the other one?");
        }
    }

    void findThin()
    {
        SurfaceRays const rays(scene_.surfaces);
        SurfaceTree const tree(scene_.surfaces);
        for (Surface const& wall : scene_.surfaces)
        {
            Real size = 0, least = std::numeric_limits<Real>::infinity();
            Vector place = Vector::Zero();
            forEachSample(wall, spacing_, [&](Sample const& sample) {
                Real const thickness = thicknessAt(sample, rays, tree);
                if (!(thickness < thinnest * spacing_)) return;
                size += sample.size;
                if (thickness >= least) return;
                least = thickness;
                place = sample.r;
            });
            if (size < large_) continue;
            findings_.push_back("wall \"" + wall.name() + "\" is " + shortNumber(least / spacing_, 3) + " spacings thick at " +
                                placeText(place) + ": below 2 the particles of its two sides have no room, and water may pass");
        }
    }

    /// Infinite where the wall is not thin, or fluid cannot reach both sides.
    [[nodiscard]] Real thicknessAt(Sample const& sample, SurfaceRays const& rays, SurfaceTree const& tree) const
    {
        Real const infinity = std::numeric_limits<Real>::infinity();
        Real const whole = thinnest * (1 - 1e-6) * spacing_;
        Real least = infinity;
        rays.forEachHit(sample.r - 1e-6 * spacing_ * sample.normal, sample.r - whole * sample.normal, [&](SurfaceRays::Hit const& hit) {
            if (hit.normal.dot(sample.normal) < opposite) least = std::min(least, (sample.r - hit.point).norm());
        });
        if (least == infinity) return infinity;
        Vector const step = 0.5 * spacing_ * sample.normal;
        bool const reached = tree.distance(sample.r + step) > 0 && tree.distance(sample.r - least * sample.normal - step) > 0;
        return reached ? least : infinity;
    }

    /// Fluid particles that meet neither wall nor body on a way.
    struct Unmet
    {
        int count = 0, asked = 0;
        int farthest = -1; ///< Of them along the way.
    };

    /// Asks each `every`th fluid particle; none where a periodic box lets it go on for ever.
    [[nodiscard]] Unmet unmet(Vector const& way, int every) const
    {
        Field<Vector> const& r = scene_.particles.r;
        Range const fluid = scene_.particles.fluid();
        Unmet result;
        if (!definition_.periodic.contains(r[fluid.first] + 1e12 * way)) return result;
        Real end = -std::numeric_limits<Real>::infinity();
        for (Surface const& holder : holders_)
            for (Vector const& point : holder.points()) end = std::max(end, point.dot(way));
        for (int i = fluid.first; i < fluid.last; i += every)
        {
            ++result.asked;
            if (meets(r[i], way, end + spacing_ - r[i].dot(way))) continue;
            ++result.count;
            if (result.farthest < 0 || r[i].dot(way) > r[result.farthest].dot(way) + 1e-6 * spacing_) result.farthest = i;
        }
        return result;
    }

    void findUnheld()
    {
        Unmet const open = unmet(down_, 1);
        if (open.count <= mostUnheld) return;
        std::string text = std::to_string(open.count) + " of " + std::to_string(open.asked) +
                           " fluid particles have no wall below them, the lowest at " + placeText(scene_.particles.r[open.farthest]) +
                           ": they will fall out; ";
        if (open.count == open.asked)
        {
            text += "no water would be left";
            for (std::string const& other : findings_) text += "; " + other;
            throw CaseError(ExitCode::BadInput, text, "a floor with its fluidSide towards the fluid");
        }
        findings_.push_back(text + "is a wall too small, or has it a hole?");
    }

    void findOpenSides()
    {
        bool const inSpace = definition_.lattice.dimensions == 3;
        Vector const across = Vector::Unit(std::abs(down_.x()) < straight ? 0 : 1);
        Vector const first = (across - across.dot(down_) * down_).normalized(), second = down_.cross(first);
        int const every = std::max(1, static_cast<int>(scene_.particles.fluid().size()) / mostAsked);
        for (Vector const& way : {first, Vector(-first), second, Vector(-second)})
        {
            if (!inSpace && std::abs(way.z()) > 0.5) continue;
            Unmet const open = unmet(way, every);
            if (open.count <= std::max<Real>(mostUnheld, leastOpen * open.asked)) continue;
            findings_.push_back("fluid at " + placeText(scene_.particles.r[open.farthest]) + " has no wall beside it along " +
                                wayText(way) + ", nor has it elsewhere (" + std::to_string(open.count) + " of " +
                                std::to_string(open.asked) + " particles asked): it will run out there" +
                                (inSpace ? "; sideWalls yes closes a channel" : ""));
        }
    }

    [[nodiscard]] bool meets(Vector const& from, Vector const& way, Real length) const
    {
        Real const step = std::max(stride * spacing_, length / mostStrides);
        bool met = false;
        for (Real gone = 0; gone < length && !met; gone += step)
            rays_->forEachHit(from + (gone - overlap * spacing_) * way, from + (gone + step) * way,
                              [&](SurfaceRays::Hit const&) { met = true; });
        return met;
    }

    SceneDefinition const& definition_;
    InitialScene const& scene_;
    Real spacing_;
    Real large_;
    Vector down_ = Vector::Zero();    ///< Along gravity; zero without.
    std::vector<Surface> holders_;    ///< Walls and bodies.
    std::optional<SurfaceRays> rays_; ///< Of these.
    std::vector<std::string> findings_;
};

} // namespace

std::vector<std::string> doubtfulWalls(SceneDefinition const& definition, InitialScene const& scene)
{
    return WallChecks(definition, scene).run();
}

} // namespace mpsDem
