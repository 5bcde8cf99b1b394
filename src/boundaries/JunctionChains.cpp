#include "boundaries/JunctionChains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/TriangleBoxes.h"

namespace mpsDem {

namespace {

using Piece = EdgeChain::Piece;

/// Looks for the pieces: where two faces of different components cross, and rims that lie on another component.
class PieceFinder
{
public:
    explicit PieceFinder(JoinedSurfaces const& surfaces) : surfaces_(surfaces)
    {
        std::vector<std::vector<TriangleBoxes::Triangle>> triangles(static_cast<std::size_t>(surfaces.components()));
        for (std::size_t f = 0; f < surfaces.faces().size(); ++f)
        {
            auto const& face = surfaces.faces()[f];
            Vector const a = surfaces.point(face, 0);
            triangles[static_cast<std::size_t>(face.component)].push_back(
                {a, surfaces.point(face, 1) - a, surfaces.point(face, 2) - a, face.normal, static_cast<int>(f)});
        }
        for (auto& own : triangles) boxes_.emplace_back(std::move(own), 0);
    }

    std::vector<Piece> find()
    {
        for (std::size_t f = 0; f < surfaces_.faces().size(); ++f) crossings(static_cast<int>(f));
        for (auto const& edge : surfaces_.edges())
            if (edge.rim()) touch(edge);
        return std::move(pieces_);
    }

private:
    void crossings(int f)
    {
        auto const& face = surfaces_.face(f);
        Vector low = surfaces_.point(face, 0), high = low;
        for (int k = 1; k < 3; ++k)
        {
            low = low.cwiseMin(surfaces_.point(face, k));
            high = high.cwiseMax(surfaces_.point(face, k));
        }
        for (std::size_t c = static_cast<std::size_t>(face.component) + 1; c < boxes_.size(); ++c)
            boxes_[c].forEachInBox(low, high, [&](int g) { cross(f, g); });
    }

    /// The two points where the sides of a face go through the plane of another one.
    [[nodiscard]] std::optional<std::array<Vector, 2>> through(int f, int plane) const
    {
        auto const& face = surfaces_.face(f);
        auto const& other = surfaces_.face(plane);
        std::array<Real, 3> off{};
        for (int k = 0; k < 3; ++k)
            off[static_cast<std::size_t>(k)] = (surfaces_.point(face, k) - surfaces_.point(other, 0)).dot(other.normal);
        std::array<Vector, 2> ends;
        std::size_t found = 0;
        for (int k = 0; k < 3; ++k)
        {
            int const next = (k + 1) % 3;
            Real const here = off[static_cast<std::size_t>(k)], there = off[static_cast<std::size_t>(next)];
            if ((here >= 0) == (there >= 0) || found == 2) continue;
            Real const share = here / (here - there);
            ends[found++] = (1 - share) * surfaces_.point(face, k) + share * surfaces_.point(face, next);
        }
        if (found < 2) return std::nullopt;
        return ends;
    }

    void cross(int f, int g)
    {
        Vector const along = surfaces_.face(f).normal.cross(surfaces_.face(g).normal);
        auto p = through(f, g), q = through(g, f);
        if (!p || !q) return;
        if ((*p)[0].dot(along) > (*p)[1].dot(along)) std::swap((*p)[0], (*p)[1]);
        if ((*q)[0].dot(along) > (*q)[1].dot(along)) std::swap((*q)[0], (*q)[1]);
        Vector const begin = (*p)[0].dot(along) > (*q)[0].dot(along) ? (*p)[0] : (*q)[0];
        Vector const end = (*p)[1].dot(along) < (*q)[1].dot(along) ? (*p)[1] : (*q)[1];
        if ((end - begin).dot(along) > 0) add(begin, end, f, g);
    }

    void touch(JoinedSurfaces::Edge const& edge)
    {
        Vector const a = surfaces_.corner(edge.corner[0]).point, b = surfaces_.corner(edge.corner[1]).point;
        Real const near = 10 * surfaces_.tolerance();
        for (std::size_t c = 0; c < boxes_.size(); ++c)
        {
            if (static_cast<int>(c) == surfaces_.face(edge.left).component) continue;
            auto const hit = boxes_[c].nearest(0.5 * (a + b), near);
            if (hit.number < 0 || boxes_[c].nearest(a, near).number < 0 || boxes_[c].nearest(b, near).number < 0) continue;
            add(a, b, edge.left, hit.number);
        }
    }

    void add(Vector const& a, Vector const& b, int f, int g)
    {
        Vector const n = surfaces_.face(f).normal, m = surfaces_.face(g).normal;
        if (n.dot(m) > straightCosine || (b - a).norm() < surfaces_.tolerance()) return;
        Vector const depth = bisectorOf(n, m);
        if (depth.norm() <= longestBisector) pieces_.push_back({a, b, depth, Vector::Zero(), f});
    }

    JoinedSurfaces const& surfaces_;
    std::vector<TriangleBoxes> boxes_;
    std::vector<Piece> pieces_;
};

/// Strings pieces together that follow each other.
class Stringer
{
public:
    Stringer(std::vector<Piece> pieces, Real tolerance) : pieces_(std::move(pieces)), taken_(pieces_.size(), 0), cell_(tolerance)
    {
        for (std::size_t k = 0; k < pieces_.size(); ++k)
            for (Vector const& end : {pieces_[k].a, pieces_[k].b}) at_[key(end)].push_back(k);
    }

    std::vector<EdgeChain> chains()
    {
        std::vector<EdgeChain> result;
        for (bool const loops : {false, true})
            for (std::size_t k = 0; k < pieces_.size(); ++k)
            {
                if (taken_[k] != 0) continue;
                bool const first = !next(k, pieces_[k].a), last = !next(k, pieces_[k].b);
                if (!loops && !first && !last) continue;
                if (!first) std::swap(pieces_[k].a, pieces_[k].b);
                result.push_back(walk(k, loops));
            }
        return result;
    }

private:
    using Key = std::array<long, 3>;

    [[nodiscard]] Key key(Vector const& r) const
    {
        return {std::lround(r.x() / cell_), std::lround(r.y() / cell_), std::lround(r.z() / cell_)};
    }

    /// The piece that goes on behind an end; none where there is no other one, more than one, or a bend.
    [[nodiscard]] std::optional<std::size_t> next(std::size_t k, Vector const& end) const
    {
        auto const& here = at_.at(key(end));
        if (here.size() != 2) return std::nullopt;
        std::size_t const other = here[0] == k ? here[1] : here[0];
        if (other == k || taken_[other] != 0) return std::nullopt;
        auto const away = [&](Piece const& p) {
            return key(p.a) == key(end) ? Vector((p.b - p.a).normalized()) : Vector((p.a - p.b).normalized());
        };
        bool const straight = away(pieces_[k]).dot(away(pieces_[other])) < -straightCosine;
        return straight ? std::optional(other) : std::nullopt;
    }

    EdgeChain walk(std::size_t k, bool loop)
    {
        EdgeChain chain{EdgeChain::Kind::Valley, loop, {}};
        for (std::optional<std::size_t> i = k; i;)
        {
            taken_[*i] = 1;
            chain.pieces.push_back(pieces_[*i]);
            Vector const end = pieces_[*i].b;
            i = next(*i, end);
            if (i && key(pieces_[*i].a) != key(end)) std::swap(pieces_[*i].a, pieces_[*i].b);
        }
        return chain;
    }

    std::vector<Piece> pieces_;
    std::vector<char> taken_;
    Real cell_;
    std::map<Key, std::vector<std::size_t>> at_;
};

} // namespace

std::vector<EdgeChain> junctionChains(JoinedSurfaces const& surfaces)
{
    if (surfaces.components() < 2) return {};
    return Stringer(PieceFinder(surfaces).find(), 1e3 * surfaces.tolerance()).chains();
}

} // namespace mpsDem
