#include "boundaries/EdgeChains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "boundaries/PlanePatches.h"

namespace mpsDem {

namespace {

using Kind = EdgeChain::Kind;

/// Links edges of one kind that follow each other.
class ChainBuilder
{
public:
    explicit ChainBuilder(JoinedSurfaces const& surfaces)
        : surfaces_(surfaces),
          kind_(surfaces.edges().size()),
          taken_(surfaces.edges().size(), 0),
          first_(surfaces.corners().size() + 1, 0)
    {
        for (std::size_t e = 0; e < kind_.size(); ++e) kind_[e] = kindOf(surfaces.edges()[e]);
        for (std::size_t e = 0; e < kind_.size(); ++e)
            if (kind_[e])
                for (int const c : surfaces.edges()[e].corner) ++first_[static_cast<std::size_t>(c) + 1];
        for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
        at_.resize(static_cast<std::size_t>(first_.back()));
        std::vector<int> fill(first_.begin(), first_.end() - 1);
        for (std::size_t e = 0; e < kind_.size(); ++e)
            if (kind_[e])
                for (int const c : surfaces.edges()[e].corner)
                    at_[static_cast<std::size_t>(fill[static_cast<std::size_t>(c)]++)] = static_cast<int>(e);
    }

    [[nodiscard]] std::vector<EdgeChain> chains()
    {
        std::vector<EdgeChain> result;
        for (bool const loops : {false, true})
            for (std::size_t e = 0; e < kind_.size(); ++e)
                for (std::size_t end = 0; end < 2; ++end)
                {
                    int const self = static_cast<int>(e);
                    if (!kind_[e] || taken_[e] || (!loops && next(self, surfaces_.edge(self).corner[end]) >= 0)) continue;
                    result.push_back(walk(self, end == 0, loops));
                }
        return result;
    }

private:
    [[nodiscard]] std::optional<Kind> kindOf(JoinedSurfaces::Edge const& edge) const
    {
        if (edge.rim()) return Kind::Rim;
        if (!isSharp(surfaces_, edge)) return std::nullopt;
        Vector const along = surfaces_.corner(edge.corner[1]).point - surfaces_.corner(edge.corner[0]).point;
        Vector const turn = surfaces_.face(edge.left).normal.cross(surfaces_.face(edge.right).normal);
        return turn.dot(along) > 0 ? Kind::Ridge : Kind::Valley;
    }

    /// The edge that goes on behind `corner`; -1 where there is none or more than one.
    [[nodiscard]] int next(int edge, int corner) const
    {
        std::size_t const c = static_cast<std::size_t>(corner);
        if (first_[c + 1] - first_[c] != 2) return -1;
        int const a = at_[static_cast<std::size_t>(first_[c])], b = at_[static_cast<std::size_t>(first_[c]) + 1];
        int const other = a == edge ? b : a;
        if (kind_[static_cast<std::size_t>(other)] != kind_[static_cast<std::size_t>(edge)]) return -1;
        return direction(edge, corner, false).dot(direction(other, corner, true)) > straightCosine ? other : -1;
    }

    /// Unit vector along an edge towards a corner, or away from it.
    [[nodiscard]] Vector direction(int edge, int corner, bool away) const
    {
        auto const& e = surfaces_.edge(edge);
        Vector const d = (surfaces_.corner(e.corner[1]).point - surfaces_.corner(e.corner[0]).point).normalized();
        return (e.corner[0] == corner) == away ? d : Vector(-d);
    }

    EdgeChain walk(int edge, bool forwards, bool loop)
    {
        EdgeChain chain{*kind_[static_cast<std::size_t>(edge)], loop, {}};
        int corner = surfaces_.edge(edge).corner[forwards ? 0 : 1];
        while (edge >= 0 && !taken_[static_cast<std::size_t>(edge)])
        {
            taken_[static_cast<std::size_t>(edge)] = 1;
            auto const& e = surfaces_.edge(edge);
            chain.pieces.push_back(piece(edge, e.corner[0] == corner));
            corner = e.corner[0] == corner ? e.corner[1] : e.corner[0];
            edge = next(edge, corner);
        }
        return chain;
    }

    [[nodiscard]] EdgeChain::Piece piece(int edge, bool forwards) const
    {
        auto const& e = surfaces_.edge(edge);
        Vector const a = surfaces_.corner(e.corner[0]).point, b = surfaces_.corner(e.corner[1]).point;
        Vector const n = surfaces_.face(e.left).normal;
        EdgeChain::Piece result{forwards ? a : b, forwards ? b : a, n, Vector::Zero(), e.left, edge};
        if (e.rim())
            result.outwards = (b - a).cross(n).normalized();
        else
        {
            result.depth = bisectorOf(n, surfaces_.face(e.right).normal);
        }
        return result;
    }

    JoinedSurfaces const& surfaces_;
    std::vector<std::optional<Kind>> kind_;
    std::vector<char> taken_;
    std::vector<int> first_, at_; ///< Edges at each corner.
};

} // namespace

std::vector<EdgeChain::Place> EdgeChain::places(Real depth, Real spacing) const
{
    std::size_t const count = pieces.size();
    std::vector<Vector> corners;
    for (std::size_t i = 0; i <= count; ++i)
    {
        Piece const& before = pieces[i > 0 ? i - 1 : loop ? count - 1 : 0];
        Piece const& behind = pieces[i < count ? i : loop ? 0 : count - 1];
        corners.push_back((i < count ? behind.a : before.b) - depth / 2 * (before.depth + behind.depth));
    }
    std::vector<Real> length;
    Real total = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        length.push_back(std::max(Real(0), (corners[i + 1] - corners[i]).dot((pieces[i].b - pieces[i].a).normalized())));
        total += length.back();
    }
    std::vector<Place> result;
    int const parts = static_cast<int>(std::lround(total / spacing));
    std::size_t i = 0;
    Real passed = 0;
    for (int m = 0; m < parts; ++m)
    {
        Real const along = (m + 0.5) * total / parts;
        while (i + 1 < count && passed + length[i] < along) passed += length[i++];
        Real const share = length[i] > 0 ? (along - passed) / length[i] : 0.5;
        result.push_back({corners[i] + share * (corners[i + 1] - corners[i]), pieces[i].outwards, pieces[i].depth.normalized(),
                          pieces[i].face, pieces[i].edge});
    }
    return result;
}

std::vector<EdgeChain> edgeChains(JoinedSurfaces const& surfaces) { return ChainBuilder(surfaces).chains(); }

} // namespace mpsDem
