#include "boundaries/EvenSpread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles/CellGrid.h"

namespace mpsDem {

namespace {

constexpr Real dartsOfSpacing = 14;    ///< Darts thrown on l0 x l0.
constexpr Real dartDistance = 0.775;   ///< Of darts, in spacings: what 14 darts need for one particle on l0 x l0.
constexpr Real longestPull = 0.35;     ///< Of a dart to its row, in spacings.
constexpr Real rowTolerance = 0.02;    ///< Of the depth, in spacings.
constexpr Real reachOfRepulsion = 1.5; ///< In spacings.
constexpr Real layerHeight = 0.5;      ///< Particles repel each other within a layer of this half height, in spacings.
constexpr Real longestStep = 0.12;     ///< In spacings.
constexpr Real strength = 0.35;        ///< Step for an overlap of the whole reach, in spacings.
constexpr int passes = 8;              ///< In which the darts are thrown.
constexpr int steps = 6;               ///< Of repulsion.
constexpr int stepsBetweenPulls = 2;
constexpr int tagOfRow = 1 << 30;
Real const smoothCosine = std::cos(35.0 * std::numbers::pi / 180);

} // namespace

EvenSpread::EvenSpread(SurfaceRowBuilder& builder, std::vector<char> const& covered) : builder_(builder), covered_(covered)
{
    if (std::all_of(covered.begin(), covered.end(), [](char c) { return c != 0; })) return;
    gatherNormals();
    throwDarts();
}

void EvenSpread::gatherNormals()
{
    JoinedSurfaces const& s = builder_.surfaces();
    std::vector<int> first(s.corners().size() + 1, 0);
    for (auto const& f : s.faces())
        for (int const c : f.corner) ++first[static_cast<std::size_t>(c) + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<int> at(static_cast<std::size_t>(first.back())), fill(first.begin(), first.end() - 1);
    for (std::size_t f = 0; f < s.faces().size(); ++f)
        for (int const c : s.faces()[f].corner) at[static_cast<std::size_t>(fill[static_cast<std::size_t>(c)]++)] = static_cast<int>(f);
    normals_.resize(s.faces().size());
    for (std::size_t f = 0; f < s.faces().size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
        {
            Vector const& own = s.faces()[f].normal;
            Vector sum = Vector::Zero();
            std::size_t const c = static_cast<std::size_t>(s.faces()[f].corner[k]);
            for (int i = first[c]; i < first[c + 1]; ++i)
            {
                Vector const& other = s.face(at[static_cast<std::size_t>(i)]).normal;
                if (other.dot(own) > smoothCosine) sum += other;
            }
            normals_[f][k] = sum / sum.dot(own);
        }
}

/// Area of the row behind a face over the face's own.
Real EvenSpread::areaRatio(int face, int row) const
{
    JoinedSurfaces const& s = builder_.surfaces();
    auto const& f = s.face(face);
    auto const& n = normals_[static_cast<std::size_t>(face)];
    Real const depth = builder_.depth(row);
    Vector const ab = s.point(f, 1) - s.point(f, 0), ac = s.point(f, 2) - s.point(f, 0);
    Vector const below = (ab - depth * (n[1] - n[0])).cross(ac - depth * (n[2] - n[0]));
    return std::max(Real(0), below.dot(f.normal)) / ab.cross(ac).norm();
}

void EvenSpread::throwDarts()
{
    JoinedSurfaces const& s = builder_.surfaces();
    Real const perArea = dartsOfSpacing / (builder_.spacing() * builder_.spacing());
    Real due = uniform();
    for (std::size_t f = 0; f < s.faces().size(); ++f)
    {
        if (covered_[f]) continue;
        Vector const a = s.point(s.faces()[f], 0);
        Real const area = (s.point(s.faces()[f], 1) - a).cross(s.point(s.faces()[f], 2) - a).norm() / 2;
        due += perArea * area * greatestRatio(static_cast<int>(f));
        for (; due >= 1; due -= 1)
        {
            Real u = uniform(), v = uniform();
            if (u + v > 1)
            {
                u = 1 - u;
                v = 1 - v;
            }
            Real const rank = uniform();
            darts_.push_back({static_cast<int>(f), u, v, rank, static_cast<int>(passes * uniform())});
        }
    }
    // In passes over the faces rather than in any order: neighbours are then neighbours in memory.
    std::stable_sort(darts_.begin(), darts_.end(), [](Dart const& d, Dart const& e) { return d.pass < e.pass; });
}

Vector EvenSpread::foot(Dart const& dart) const
{
    JoinedSurfaces const& s = builder_.surfaces();
    auto const& face = s.face(dart.face);
    Vector const a = s.point(face, 0);
    return a + dart.u * (s.point(face, 1) - a) + dart.v * (s.point(face, 2) - a);
}

SurfaceRowBuilder::Candidate EvenSpread::candidate(Dart const& dart, int row) const
{
    auto const& n = normals_[static_cast<std::size_t>(dart.face)];
    Vector const offset = (1 - dart.u - dart.v) * n[0] + dart.u * n[1] + dart.v * n[2];
    return {foot(dart) - builder_.depth(row) * offset, offset.normalized(), dart.face, row, 0, tagOfRow + row};
}

/// Moves a place along its way to the surface until it lies at the depth of its row; false where it cannot.
bool EvenSpread::pullToRow(SurfaceRowBuilder::Candidate& c) const
{
    Real const l0 = builder_.spacing(), depth = builder_.depth(c.row);
    auto const near = builder_.tree().nearest(c.position);
    Real const below = -near.distance;
    if (below < 0.05 * l0 || near.atRim || std::abs(below - depth) > longestPull * l0) return false;
    Vector const normal = (near.point - c.position) / below;
    Vector const pulled = near.point - depth * normal;
    Real const moved = std::abs(below - depth);
    if (moved > rowTolerance / 2 * l0 && -builder_.tree().distance(pulled) < depth - rowTolerance * l0) return false;
    int const face = builder_.faceOf(near);
    if (!isDue(face, c.row)) return false;
    c.position = pulled;
    c.normal = normal;
    c.face = face;
    return true;
}

/// Brings a dart to its row, or leaves it where its foot is buried.
SurfaceRowBuilder::Standing EvenSpread::settle(SurfaceRowBuilder::Candidate& c, Dart const& dart) const
{
    using Standing = SurfaceRowBuilder::Standing;
    if (builder_.surfaces().components() > 1)
    {
        Standing const where = builder_.standing(c, foot(dart), builder_.surfaces().face(dart.face).normal);
        if (where == Standing::Buried) return where;
    }
    return pullToRow(c) ? Standing::InRow : Standing::Outside;
}

std::vector<EvenSpread::Particle> EvenSpread::particles(int row) const
{
    using Standing = SurfaceRowBuilder::Standing;
    Real const least = dartDistance * builder_.spacing();
    PlacedPoints own(1.5 * least);
    auto const taken = [&](Vector const& r) { return own.near(r, least) || builder_.placed().near(r, least); };
    std::vector<Particle> result;
    for (Dart const& dart : darts_)
    {
        if (!isDue(dart.face, row) || dart.rank * greatestRatio(dart.face) > areaRatio(dart.face, row)) continue;
        auto c = candidate(dart, row);
        if (taken(c.position)) continue;
        Vector const thrown = c.position;
        Standing const where = settle(c, dart);
        if (where == Standing::Outside) continue;
        if (c.position != thrown && taken(c.position)) continue;
        own.add(c.position, 0);
        result.push_back({c, where == Standing::InRow});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](Particle const& p, Particle const& q) { return p.candidate.face < q.candidate.face; });
    return result;
}

/// Back to the row, or to the last good place.
void EvenSpread::pullAll(std::vector<Particle>& particles, std::vector<SurfaceRowBuilder::Candidate>& lastGood) const
{
    Real const far = (stepsBetweenPulls + 1) * longestStep * builder_.spacing();
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        if (!particles[i].movable) continue;
        auto& c = particles[i].candidate;
        if (!pullToRow(c) || (c.position - lastGood[i].position).norm() > far) c = lastGood[i];
        lastGood[i] = c;
    }
}

void EvenSpread::repel(std::vector<Particle>& particles) const
{
    Real const l0 = builder_.spacing(), reach = reachOfRepulsion * l0;
    std::vector<std::vector<Vector>> fixed(particles.size());
    std::vector<SurfaceRowBuilder::Candidate> lastGood;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        lastGood.push_back(particles[i].candidate);
        auto const& c = particles[i].candidate;
        builder_.placed().anyNear(c.position, reach, [&](Vector const& q, int) {
            if (std::abs((q - c.position).dot(c.normal)) < l0) fixed[i].push_back(q);
            return false;
        });
    }
    Field<Vector> position(particles.size());
    CellGrid grid;
    for (int step = 1; step <= steps; ++step)
    {
        for (std::size_t i = 0; i < particles.size(); ++i) position[i] = particles[i].candidate.position;
        grid.build(position, reach, 3);
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
            if (!particles[i].movable) continue;
            auto& c = particles[i].candidate;
            Vector push = Vector::Zero();
            auto const add = [&](Vector const& rij) {
                Real const r = rij.norm();
                if (r < 1e-9 * l0 || r >= reach || std::abs(rij.dot(c.normal)) > layerHeight * l0) return;
                Real const overlap = 1 - r / reach;
                push -= overlap * overlap / r * rij;
            };
            grid.forEachWithin(position[i], reach, [&](int, Vector const& rij, Real) { add(rij); });
            for (Vector const& q : fixed[i]) add(q - position[i]);
            push -= push.dot(c.normal) * c.normal;
            push *= strength * l0;
            if (push.norm() > longestStep * l0) push *= longestStep * l0 / push.norm();
            c.position += push;
        }
        if (step % stepsBetweenPulls == 0) pullAll(particles, lastGood);
    }
}

void EvenSpread::addRow(int row)
{
    if (darts_.empty()) return;
    std::vector<Particle> all = particles(row);
    repel(all);
    for (Particle const& p : all)
    {
        if (p.movable)
            builder_.put(p.candidate, p.candidate.normal, row == 0 ? ParticleType::Wall : ParticleType::Ghost);
        else
            builder_.keepBuried(p.candidate);
    }
}

} // namespace mpsDem
