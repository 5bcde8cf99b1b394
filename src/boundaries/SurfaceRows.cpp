#include "boundaries/SurfaceRows.h"

#include <algorithm>
#include <cmath>

#include "boundaries/EdgeChains.h"
#include "boundaries/EvenSpread.h"
#include "boundaries/JunctionChains.h"
#include "boundaries/PlanePatches.h"
#include "boundaries/SurfaceRowBuilder.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

constexpr Real holeStep = 0.25;     ///< Between places that are looked at for holes, in spacings.
constexpr Real leastInRow = 0.88;   ///< A place of a row this far from all particles is a hole, in spacings.
constexpr Real leastInFan = 0.95;   ///< The same behind an edge or a corner.
constexpr Real leastOfWalls = 0.88; ///< The same from wall particles for a place of the wall row.
constexpr int holeReach = 7;        ///< Places looked at from where a row ends at an edge.

/// The steps by which the rows of a set of surfaces are made.
class RowMaker
{
public:
    RowMaker(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real spacing)
        : builder(surfaces, ghostRows, spacing),
          deepest_(*std::max_element(ghostRows.begin(), ghostRows.end())),
          chains_(edgeChains(builder.surfaces())),
          junctions_(junctionChains(builder.surfaces()))
    {
        std::vector<int> beyond;
        for (int const rows : ghostRows) beyond.push_back(rows + 1);
        plane_ = planePatches(builder.surfaces(), spacing, beyond);
    }

    void make()
    {
        forEachRow([&](int row) { junctions(row); });
        forEachRow([&](int row) { lines(row); });
        forEachRow([&](int row) { bisectors(row, EdgeChain::Kind::Ridge); });
        forEachRow([&](int row) { bisectors(row, EdgeChain::Kind::Valley); });
        EvenSpread spread(builder, plane_.covers);
        forEachRow([&](int row) { spread.addRow(row); });
        forEachRow([&](int row) { continuedLines(row); });
        builder.addBuried();
        forEachRow([&](int row) { continuedRims(row); });
        builder.addInHolesOfJunctions(leastInRow, leastOfWalls);
        forEachRow([&](int row) { holes(row); });
        forEachRow([&](int row) { holesBehindCorners(row); });
    }

    SurfaceRowBuilder builder;

private:
    using Kind = EdgeChain::Kind;

    template <class Step>
    void forEachRow(Step step) const
    {
        for (int row = 0; row <= deepest_; ++row) step(row);
    }

    [[nodiscard]] bool has(int face, int row) const { return row <= builder.ghostRows(face); }
    [[nodiscard]] bool inPlane(int face) const { return face >= 0 && plane_.covers[static_cast<std::size_t>(face)] != 0; }
    [[nodiscard]] JoinedSurfaces::Edge const& edge(int e) const { return builder.surfaces().edge(e); }
    [[nodiscard]] Vector const& normal(int face) const { return builder.surfaces().face(face).normal; }

    void lines(int row)
    {
        for (std::size_t p = 0; p < plane_.patches.size(); ++p)
        {
            PlanePatch const& patch = plane_.patches[p];
            if (!has(patch.face, row)) continue;
            for (auto const& foot : patch.feet)
                if (foot.beyond == 0)
                    builder.addInRow({foot.point - builder.depth(row) * patch.normal, patch.normal, patch.face, row, 0, tag(p, row)});
        }
    }

    /// Where surfaces meet without a common edge, before all others: what comes later keeps its distance.
    void junctions(int row)
    {
        for (EdgeChain const& chain : junctions_)
            for (auto const& place : chain.places(builder.depth(row), builder.spacing()))
                if (has(place.face, row)) builder.addInJunction({place.point, place.normal, place.face, row});
    }

    void continuedLines(int row)
    {
        for (std::size_t p = 0; p < plane_.patches.size(); ++p)
        {
            PlanePatch const& patch = plane_.patches[p];
            if (!has(patch.face, row)) continue;
            for (auto const& foot : patch.feet)
                if (foot.beyond > 0)
                    builder.addBeyond(
                        {foot.point - builder.depth(row) * patch.normal, patch.normal, patch.face, row, foot.beyond, tag(p, row)});
        }
    }

    [[nodiscard]] int tag(std::size_t patch, int row) const { return static_cast<int>(patch) * (deepest_ + 1) + row; }

    /// In valleys always; on ridges only between rows without lines, which would end anywhere.
    void bisectors(int row, Kind kind)
    {
        for (EdgeChain const& chain : chains_)
        {
            if (chain.kind != kind) continue;
            for (auto const& place : chain.places(builder.depth(row), builder.spacing()))
            {
                auto const& e = edge(place.edge);
                if (!has(e.left, row) || bisectorOf(normal(e.left), normal(e.right)).norm() > longestBisector) continue;
                SurfaceRowBuilder::Candidate const c{place.point, place.normal, e.left, row};
                if (kind == Kind::Valley)
                    builder.addBeyond(c);
                else if (!inPlane(e.left) && !inPlane(e.right))
                    builder.addInHole(c, leastInRow, leastOfWalls);
            }
        }
    }

    /// Behind the rims of faces without lines.
    void continuedRims(int row)
    {
        Real const l0 = builder.spacing();
        for (EdgeChain const& chain : chains_)
        {
            if (chain.kind != Kind::Rim || inPlane(edge(chain.pieces.front().edge).left)) continue;
            for (auto const& place : chain.places(builder.depth(row), l0))
            {
                int const face = edge(place.edge).left;
                if (!has(face, row)) continue;
                for (int m = 0; m < builder.ghostRows(face) + 2; ++m)
                    builder.addBeyond({place.point + (m + 0.5) * l0 * place.outwards, place.normal, face, row, m + 1});
            }
        }
    }

    /// Looks for holes along the edges: where the rows behind lines end at a ridge, and in the fans behind valleys and rims.
    void holes(int row)
    {
        for (EdgeChain const& chain : chains_)
            for (auto const& piece : chain.pieces)
            {
                auto const& e = edge(piece.edge);
                int const parts = std::max(1, static_cast<int>(std::lround((piece.b - piece.a).norm() / (holeStep * builder.spacing()))));
                for (int i = 0; i < parts; ++i)
                {
                    Vector const r = piece.a + (i + 0.5) / parts * (piece.b - piece.a);
                    if (chain.kind == Kind::Valley) fan(r, normal(e.left), normal(e.right), e.left, row);
                    if (chain.kind == Kind::Rim) fan(r, piece.depth, -piece.outwards, e.left, row);
                    if (chain.kind == Kind::Rim) continue;
                    // A row behind a ridge ends where it is as deep below the other face.
                    Real const cosine = normal(e.left).dot(normal(e.right));
                    Real const tangent = std::sqrt(std::max(Real(0), 1 - cosine) / std::max(1 + cosine, 1e-3));
                    for (int const face : {e.left, e.right})
                        if (inPlane(face) && has(face, row))
                            endOfRow(r, piece.b - piece.a, face, row, chain.kind == Kind::Ridge ? builder.depth(row) * tangent : 0);
                }
            }
    }

    void fan(Vector const& r, Vector const& n, Vector const& m, int face, int row)
    {
        if (!has(face, row)) return;
        Real const angle = std::atan2(n.cross(m).norm(), n.dot(m)), depth = builder.depth(row);
        int const parts = static_cast<int>(std::ceil(angle * depth / (holeStep * builder.spacing())));
        for (int i = 1; i < parts; ++i)
        {
            Real const share = static_cast<Real>(i) / parts;
            Vector const direction = (std::sin((1 - share) * angle) * n + std::sin(share * angle) * m) / std::sin(angle);
            builder.addInHole({r - depth * direction, direction, face, row}, leastInFan, leastInFan);
        }
    }

    void endOfRow(Vector const& r, Vector const& along, int face, int row, Real begin)
    {
        JoinedSurfaces const& all = builder.surfaces();
        Vector const n = normal(face);
        Vector const middle = (all.point(all.face(face), 0) + all.point(all.face(face), 1) + all.point(all.face(face), 2)) / 3;
        Vector inwards = n.cross(along).normalized();
        if (inwards.dot(middle - r) < 0) inwards = -inwards;
        for (int i = 0; i < holeReach; ++i)
            builder.addInHole({r + (begin + i * holeStep * builder.spacing()) * inwards - builder.depth(row) * n, n, face, row}, leastInRow,
                              leastOfWalls);
    }

    void holesBehindCorners(int row);

    int deepest_;
    std::vector<EdgeChain> chains_, junctions_;
    PlanePatches plane_;
};

/// Looks for holes behind corners: places between the directions of three faces that meet there.
void RowMaker::holesBehindCorners(int row)
{
    std::vector<std::vector<int>> faces(builder.surfaces().corners().size());
    for (EdgeChain const& chain : chains_)
    {
        if (chain.kind != Kind::Valley) continue;
        for (auto const& piece : chain.pieces)
            for (int const c : edge(piece.edge).corner)
                for (int const f : {edge(piece.edge).left, edge(piece.edge).right})
                {
                    auto& own = faces[static_cast<std::size_t>(c)];
                    if (std::find(own.begin(), own.end(), f) == own.end()) own.push_back(f);
                }
    }
    Real const depth = builder.depth(row);
    int const parts = static_cast<int>(std::ceil(2 * depth / (holeStep * builder.spacing())));
    for (std::size_t c = 0; c < faces.size(); ++c)
        for (std::size_t f = 2; f < faces[c].size(); ++f)
            for (int i = 1; i < parts; ++i)
                for (int j = 1; i + j < parts; ++j)
                {
                    Vector const direction =
                        (i * normal(faces[c][0]) + j * normal(faces[c][f - 1]) + (parts - i - j) * normal(faces[c][f])).normalized();
                    if (!direction.allFinite() || !has(faces[c][0], row)) continue;
                    builder.addInHole({builder.surfaces().corners()[c].point - depth * direction, direction, faces[c][0], row}, leastInFan,
                                      leastInFan);
                }
}

} // namespace

BoundaryRows boundaryRows(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real spacing)
{
    expect(surfaces.size() == ghostRows.size(), "boundaryRows: one number of rows a surface");
    if (surfaces.empty()) return {};
    RowMaker maker(surfaces, ghostRows, spacing);
    maker.make();
    return std::move(maker.builder.rows);
}

} // namespace mpsDem
