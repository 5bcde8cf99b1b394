#include "boundaries/SurfaceRowBuilder.h"

#include <cmath>

namespace mpsDem {

namespace {

constexpr Real shortfall = 0.02;       ///< A row may be nearer to a surface than its depth by this, in spacings.
constexpr Real tipClearance = 0.2;     ///< Least distance of a wall particle in a sharp tip from the other side, in spacings.
constexpr Real leastDistance = 0.7;    ///< Of two boundary particles, in spacings.
constexpr Real leastOfLattices = 0.88; ///< Of particles past an edge from those of another lattice: above the half diagonal of a cell.
constexpr Real reachOfWallRow = 0.75;  ///< Greatest depth of a wall particle past an edge, in spacings.
constexpr Real holeStep = 0.25;        ///< Between places that are looked at for holes, in spacings.
constexpr Real longestPull = 0.3;      ///< Of a particle to its row, in spacings.
constexpr Real cellSize = 1.2;         ///< Of the grid of particles placed, in spacings.
constexpr Real faceCosine = 0.9986;    ///< Of 3 degrees: a place whose way to the surface is along the normal lies behind a face.

} // namespace

SurfaceRowBuilder::SurfaceRowBuilder(std::span<TriSurface const> surfaces, std::span<int const> ghostRows, Real spacing)
    : joined_(surfaces),
      tree_(surfaces),
      placed_(cellSize * spacing),
      walls_(cellSize * spacing),
      ghostRows_(ghostRows.begin(), ghostRows.end()),
      spacing_(spacing)
{
    int count = 0;
    for (TriSurface const& surface : surfaces)
    {
        firstFace_.push_back(count);
        count += static_cast<int>(surface.triangles().size());
    }
}

/// A place on one surface that no other one covers.
bool SurfaceRowBuilder::exposed(Vector const& foot, Vector const& normal) const
{
    return joined_.components() == 1 || tree_.distance(foot + 1e-5 * spacing_ * normal) > 0;
}

SurfaceRowBuilder::Standing SurfaceRowBuilder::standing(Candidate const& c, Vector const& foot, Vector const& normal) const
{
    auto const near = tree_.nearest(c.position);
    if (near.distance > -1e-9 * spacing_) return Standing::Outside;
    Real const below = -near.distance;
    bool const sharpTip = c.row == 0 && below >= tipClearance * spacing_ && near.normal.dot(c.normal) < -0.01;
    if (below < depth(c.row) - shortfall * spacing_ && !sharpTip) return Standing::Outside;
    if (joined_.components() == 1) return Standing::InRow;
    if (exposed(foot, normal)) return Standing::InRow;
    return -tree_.distance(foot) <= (ghostRows(c.face) + 1) * spacing_ ? Standing::Buried : Standing::Outside;
}

void SurfaceRowBuilder::put(Candidate const& c, Vector const& normal, ParticleType type)
{
    if (placed_.near(c.position, leastDistance * spacing_)) return;
    placed_.add(c.position, c.tag);
    if (type == ParticleType::Wall) walls_.add(c.position, c.tag);
    rows.position.push_back(c.position);
    rows.normal.push_back(normal);
    rows.type.push_back(type);
    rows.chain.push_back(joined_.face(c.face).surface);
}

void SurfaceRowBuilder::addInRow(Candidate const& c)
{
    Standing const where = standing(c, c.position + depth(c.row) * c.normal, c.normal);
    if (where == Standing::InRow) put(c, c.normal, c.row == 0 ? ParticleType::Wall : ParticleType::Ghost);
    if (where == Standing::Buried) keepBuried(c);
}

void SurfaceRowBuilder::addBuried()
{
    for (Candidate& c : buried_)
    {
        c.beyond = 1;
        addBeyond(c);
    }
}

void SurfaceRowBuilder::addInHolesOfJunctions(Real least, Real leastOfWall)
{
    constexpr int places = 6; // to each side
    for (Candidate const& c : buried_)
    {
        Vector const e1 = c.normal.unitOrthogonal() * (holeStep * spacing_), e2 = c.normal.cross(e1);
        for (int i = -places; i <= places; ++i)
            for (int j = -places; j <= places; ++j) addInHole({c.position + i * e1 + j * e2, c.normal, c.face, c.row}, least, leastOfWall);
    }
    buried_.clear();
}

/// Whether a place lies behind the middle of a face, where that face's own rows are.
bool SurfaceRowBuilder::coveredByRows(Vector const& r, TriangleTree::Nearest const& near) const
{
    return (near.point - r).dot(near.normal) > faceCosine * -near.distance && exposed(near.point, near.normal);
}

void SurfaceRowBuilder::addBeyond(Candidate const& c)
{
    auto const near = tree_.nearest(c.position);
    Real const below = -near.distance;
    if (below < 1e-9 * spacing_ || below < depth(c.row) - shortfall * spacing_) return;
    Real const farthest = std::hypot(depth(c.row), std::sqrt(2.0) * depth(ghostRows(c.face))); // past two edges of a cuboid
    bool const tooFar = c.beyond > ghostRows(c.face) + 1 || below > farthest + shortfall * spacing_;
    if (!near.atRim && (tooFar || coveredByRows(c.position, near))) return;
    if (c.beyond > 0)
    {
        Real const own = leastDistance * spacing_, others = leastOfLattices * spacing_;
        bool const taken = placed_.anyNear(c.position, others, [&](Vector const& q, int tag) {
            Real const least = tag == c.tag && tag >= 0 ? own : others;
            return (q - c.position).squaredNorm() < least * least;
        });
        if (taken) return;
    }
    bool const wall = c.row == 0 && !near.atRim && below <= reachOfWallRow * spacing_;
    put(c, near.atRim ? c.normal : Vector((near.point - c.position) / below), wall ? ParticleType::Wall : ParticleType::Ghost);
}

void SurfaceRowBuilder::addInJunction(Candidate const& c)
{
    Real const off = -tree_.distance(c.position) - depth(c.row);
    if (off < -shortfall * spacing_ || off > longestPull * spacing_) return; // behind a third surface
    put(c, c.normal, c.row == 0 ? ParticleType::Wall : ParticleType::Ghost);
}

bool SurfaceRowBuilder::isHole(Candidate const& c, Real least, Real leastOfWall) const
{
    if (!placed_.near(c.position, least * spacing_)) return true;
    return c.row == 0 && !walls_.near(c.position, leastOfWall * spacing_) && !placed_.near(c.position, leastDistance * spacing_);
}

void SurfaceRowBuilder::addInHole(Candidate c, Real least, Real leastOfWall)
{
    if (!isHole(c, least, leastOfWall)) return;
    auto const near = tree_.nearest(c.position);
    Real const below = -near.distance, off = std::abs(below - depth(c.row));
    if (below < tipClearance * spacing_ || near.atRim || off > longestPull * spacing_ || !exposed(near.point, near.normal)) return;
    Vector const normal = (near.point - c.position) / below;
    if (off > shortfall * spacing_)
    {
        c.position = near.point - depth(c.row) * normal;
        if (!isHole(c, least, leastOfWall) || -tree_.distance(c.position) < depth(c.row) - shortfall * spacing_) return;
    }
    put(c, normal, c.row == 0 ? ParticleType::Wall : ParticleType::Ghost);
}

} // namespace mpsDem
