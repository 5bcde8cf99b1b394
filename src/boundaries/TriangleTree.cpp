#include "boundaries/TriangleTree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "boundaries/JoinedSurfaces.h"
#include "core/Errors.h"
#include "core/TriangleBoxes.h"

namespace mpsDem {

namespace {

using Hit = TriangleBoxes::Hit;
using Part = TriangleBoxes::Part;

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr std::size_t mostCovers = 8; ///< Surfaces that cover each other at one place.

} // namespace

/// Queries over components: pieces that hang together by edges. What meets otherwise (a ramp in the middle of a floor) is another one.
struct TriangleTree::Parts
{
    struct Component
    {
        TriangleBoxes boxes;
        bool closed = true;
        bool body = false; ///< Closed, its solid inside: nothing outside of its box lies behind it.
        int family = 0;    ///< Components whose rims lie on each other (a fine and a coarse mesh) have the same one.
    };

    /// A hit with its component.
    struct Place
    {
        int component = -1;
        Hit hit;
        Real distance = infinity; ///< Signed.
    };

    explicit Parts(std::span<TriSurface const> surfaces);

    [[nodiscard]] Component const& component(int c) const { return components[static_cast<std::size_t>(c)]; }
    void joinAlong(JoinedSurfaces::Edge const& rim);
    [[nodiscard]] bool atRim(Hit const& hit) const;
    [[nodiscard]] Vector normalAt(Hit const& hit) const;
    [[nodiscard]] Vector normalOverComponents(Place const& place) const;
    [[nodiscard]] bool liesBehind(int c, Vector const& r) const;
    [[nodiscard]] bool related(int c, std::span<int const> others) const;
    [[nodiscard]] bool freeRim(Place const& place) const;
    [[nodiscard]] Place signedPlace(int c, Hit const& hit, Vector const& r) const;
    [[nodiscard]] Place nearestOfAll(Vector const& r) const;
    [[nodiscard]] Place nearestThatBuries(Place const& place, Vector const& r, std::span<int const> visited) const;
    [[nodiscard]] Place nearest(Vector const& r) const;

    JoinedSurfaces joined;
    std::vector<Component> components;
};

TriangleTree::Parts::Parts(std::span<TriSurface const> surfaces) : joined(surfaces)
{
    std::size_t const count = static_cast<std::size_t>(joined.components());
    components.resize(count);
    std::vector<std::vector<TriangleBoxes::Triangle>> triangles(count);
    std::vector<Real> volume(count, 0);
    Vector const origin = joined.faces().empty() ? Vector::Zero() : joined.point(joined.face(0), 0);
    for (std::size_t f = 0; f < joined.faces().size(); ++f)
    {
        JoinedSurfaces::Face const& face = joined.faces()[f];
        std::size_t const c = static_cast<std::size_t>(face.component);
        Vector const a = joined.point(face, 0), ab = joined.point(face, 1) - a, ac = joined.point(face, 2) - a;
        triangles[c].push_back({a, ab, ac, face.normal, static_cast<int>(f)});
        volume[c] += (a - origin).dot(ab.cross(ac));
        for (int const e : face.edge) components[c].closed = components[c].closed && !joined.edge(e).rim();
    }
    for (std::size_t c = 0; c < count; ++c)
    {
        components[c].boxes = TriangleBoxes(std::move(triangles[c]), 1e-12 * joined.extent());
        components[c].body = components[c].closed && volume[c] > 0;
        components[c].family = static_cast<int>(c);
    }
    if (count > 1)
        for (JoinedSurfaces::Edge const& edge : joined.edges())
            if (edge.rim()) joinAlong(edge);
}

/// Two components are of one family where their rims run along each other with the fluid on the same side.
void TriangleTree::Parts::joinAlong(JoinedSurfaces::Edge const& rim)
{
    Vector const a = joined.corner(rim.corner[0]).point, b = joined.corner(rim.corner[1]).point;
    int const own = joined.face(rim.left).component;
    for (int c = 0; c < static_cast<int>(components.size()); ++c)
    {
        int const from = component(c).family, to = component(own).family;
        if (from == to) continue;
        Hit const hit = component(c).boxes.nearest(0.5 * (a + b), joined.tolerance());
        if (hit.number < 0 || hit.part != Part::Side || !atRim(hit)) continue;
        JoinedSurfaces::Edge const& other = joined.edge(joined.face(hit.number).edge[static_cast<std::size_t>(hit.k)]);
        if ((joined.corner(other.corner[1]).point - joined.corner(other.corner[0]).point).dot(b - a) > 0) continue;
        for (Component& each : components)
            if (each.family == std::max(from, to)) each.family = std::min(from, to);
    }
}

bool TriangleTree::Parts::atRim(Hit const& hit) const
{
    JoinedSurfaces::Face const& face = joined.face(hit.number);
    std::size_t const k = static_cast<std::size_t>(hit.k);
    if (hit.part == Part::Side) return joined.edge(face.edge[k]).rim();
    return hit.part == Part::Corner && joined.corner(face.corner[k]).rim;
}

/// Normal that decides on the sign: of the face, the edge or the corner.
Vector TriangleTree::Parts::normalAt(Hit const& hit) const
{
    JoinedSurfaces::Face const& face = joined.face(hit.number);
    std::size_t const k = static_cast<std::size_t>(hit.k);
    if (hit.part == Part::Side) return joined.edge(face.edge[k]).normal;
    return hit.part == Part::Corner ? joined.corner(face.corner[k]).normal : face.normal;
}

/// Rims of two components may meet without common points (a fine and a coarse mesh): both have their part in the normal.
Vector TriangleTree::Parts::normalOverComponents(Place const& place) const
{
    Vector normal = normalAt(place.hit);
    if (components.size() == 1 || !atRim(place.hit)) return normal;
    normal.normalize();
    for (int c = 0; c < static_cast<int>(components.size()); ++c)
    {
        if (c == place.component) continue;
        Hit const other = component(c).boxes.nearest(place.hit.point, joined.tolerance());
        if (other.number >= 0 && atRim(other)) normal += normalAt(other).normalized();
    }
    return normal;
}

TriangleTree::Parts::Place TriangleTree::Parts::signedPlace(int c, Hit const& hit, Vector const& r) const
{
    Place place{c, hit, 0};
    place.distance = (r - hit.point).dot(normalOverComponents(place)) >= 0 ? hit.distance : -hit.distance;
    return place;
}

/// A rim that no other component touches or covers.
bool TriangleTree::Parts::freeRim(Place const& place) const
{
    if (!atRim(place.hit)) return false;
    Vector const& r = place.hit.point;
    for (int c = 0; c < static_cast<int>(components.size()); ++c)
    {
        if (c == place.component) continue;
        Hit const other = component(c).boxes.nearest(r, infinity);
        if (other.distance <= joined.tolerance()) return false;
        if (!atRim(other) && (r - other.point).dot(normalAt(other)) < 0) return false;
    }
    return true;
}

/// A place r of another component lies behind component c. Beyond its rims nothing does, except beyond one that ends on the middle of
/// another component.
bool TriangleTree::Parts::liesBehind(int c, Vector const& r) const
{
    Component const& own = component(c);
    Real const near = joined.tolerance();
    if (own.body && ((own.boxes.low() - r).maxCoeff() > near || (r - own.boxes.high()).maxCoeff() > near)) return false;
    Hit const hit = own.boxes.nearest(r, infinity);
    if (hit.distance <= near || (r - hit.point).dot(normalAt(hit)) >= 0) return false;
    if (!atRim(hit)) return true;
    for (int other = 0; other < static_cast<int>(components.size()); ++other)
    {
        if (other == c) continue;
        Hit const touched = component(other).boxes.nearest(hit.point, infinity);
        if (atRim(touched)) continue;
        if (touched.distance <= near || (hit.point - touched.point).dot(normalAt(touched)) < 0) return true;
    }
    return false;
}

/// Where several components are equally near, one that the place lies behind decides: a rock that stands on a floor is solid.
TriangleTree::Parts::Place TriangleTree::Parts::nearestOfAll(Vector const& r) const
{
    if (components.size() == 1) return signedPlace(0, component(0).boxes.nearest(r, infinity), r);
    Place best;
    Real least = infinity;
    for (int c = 0; c < static_cast<int>(components.size()); ++c)
    {
        Hit const hit = component(c).boxes.nearest(r, least + joined.tolerance());
        if (hit.number < 0) continue;
        Place const place = signedPlace(c, hit, r);
        bool const tie = best.component >= 0 && hit.distance > least - joined.tolerance();
        least = std::min(least, hit.distance);
        if (!tie || (place.distance < 0 && best.distance > 0)) best = place;
    }
    return best;
}

bool TriangleTree::Parts::related(int c, std::span<int const> others) const
{
    return std::any_of(others.begin(), others.end(), [&](int other) { return component(other).family == component(c).family; });
}

TriangleTree::Parts::Place TriangleTree::Parts::nearestThatBuries(Place const& place, Vector const& r, std::span<int const> visited) const
{
    Place next;
    for (int c = 0; c < static_cast<int>(components.size()); ++c)
    {
        if (related(c, visited) || !liesBehind(c, place.hit.point)) continue;
        Hit const hit = component(c).boxes.nearest(r, std::abs(next.distance));
        if (hit.number >= 0 && hit.distance < std::abs(next.distance)) next = signedPlace(c, hit, r);
    }
    return next;
}

TriangleTree::Parts::Place TriangleTree::Parts::nearest(Vector const& r) const
{
    Place place = nearestOfAll(r);
    if (components.size() == 1) return place;
    std::array<int, mostCovers> visited{};
    for (std::size_t count = 0; count < visited.size(); ++count)
    {
        visited[count] = place.component;
        Place const next = nearestThatBuries(place, r, std::span(visited).first(count + 1));
        if (next.component < 0) break;
        place = next;
    }
    return place;
}

TriangleTree::TriangleTree(std::span<TriSurface const> surfaces) : parts_(std::make_unique<Parts>(surfaces)) {}
TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

bool TriangleTree::empty() const { return parts_->components.empty(); }

TriangleTree::Nearest TriangleTree::nearest(Vector const& r) const
{
    expect(!empty(), "TriangleTree::nearest: no triangles");
    Parts::Place const place = parts_->nearest(r);
    JoinedSurfaces::Face const& face = parts_->joined.face(place.hit.number);
    return {place.hit.point, place.distance, face.normal, face.surface, face.triangle, parts_->freeRim(place)};
}

Real TriangleTree::distance(Vector const& r) const { return empty() ? infinity : parts_->nearest(r).distance; }

} // namespace mpsDem
