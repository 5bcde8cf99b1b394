#include "fluid/Collision.h"

#include <algorithm>
#include <cmath>

#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

constexpr Real besideEdge = 1.5; ///< Reach along a plane beyond its edge, in spacings.

} // namespace

std::unique_ptr<Collision> Collision::read(Dictionary const& dict, SchemeSet set, Lattice const& lattice, Real density, Ledger& ledger)
{
    if (dict.getWordOr("type", "pairwise", {"pairwise", "none"}, "collision schemes") == "none")
    {
        for (char const* key : {"distance", "surfaceDistance", "restitution", "walls"}) dict.ignore(key);
        return nullptr;
    }
    return std::unique_ptr<Collision>(new Collision(dict, set, lattice, density, ledger));
}

Collision::Collision(Dictionary const& dict, SchemeSet set, Lattice const& lattice, Real density, Ledger& ledger)
    : distance_(lattice.spacing * dict.getInRangeOr("distance", 0.5, 0, 1)),
      surfaceDistance_(lattice.spacing * dict.getInRangeOr("surfaceDistance", set == SchemeSet::Paper ? 0.5 : 0.8, 0, 1)),
      restitution_(dict.getInRangeOr("restitution", 0.2, 0, 1)),
      particleMass_(density * lattice.particleVolume()),
      alongNormal_(dict.getWordOr("walls", set == SchemeSet::Waves ? "normal" : "centres", {"centres", "normal"},
                                  "directions of collisions with walls") == "normal"),
      dissipated_(ledger.energy("energy/collision")),
      wallImpulse_(ledger.impulse("impulse/collisionWithWalls"))
{}

void Collision::clearReactions(ParticleSet const& particles)
{
    fromWalls_.setZero();
    int last = static_cast<int>(reactions_.size()) - 1;
    if (reactions_.empty()) // the bodies of a case never change
        for (int j : particles.boundary()) last = std::max(last, particles.body[j]);
    reactions_.assign(static_cast<std::size_t>(last + 1), Impulse{});
}

void Collision::note(ParticleSet const& particles, PeriodicImages const& images, int j, Vector const& du, Real approach)
{
    int const original = images.source(particles, j);
    if (particles.body[original] < 0)
    {
        fromWalls_ += particleMass_ * du;
        return;
    }
    Impulse& impulse = reactions_[static_cast<std::size_t>(particles.body[original])];
    impulse.linear -= particleMass_ * du;
    impulse.moment -= particleMass_ * particles.r[original].cross(du);
    impulse.amount += particleMass_ * du.norm();
    impulse.rate += particleMass_ * du.norm() * approach / particles.lattice().spacing;
}

Vector Collision::meetPlane(ParticleSet const& particles, PeriodicImages const& images, int j, Vector const& velocity)
{
    Vector const& normal = particles.normal[j];
    Real const approach = (particles.u[j] - velocity).dot(normal);
    if (approach <= 0) return Vector::Zero();
    Vector const du = (1 + restitution_) * approach * normal;
    note(particles, images, j, du, approach);
    return du;
}

Vector Collision::meetPlanes(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images, int i)
{
    Real const reach2 = surfaceDistance_ * surfaceDistance_, spacing = particles.lattice().spacing;
    Real nearest2 = besideEdge * besideEdge * spacing * spacing;
    bool atEdge = false, inFront = false;
    int beside = -1; // the nearest particle out of reach whose plane is within it
    Vector change = Vector::Zero();
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        if (particles.isFluid(j)) continue;
        Vector const rij = particles.r[j] - particles.r[i];
        Real const r2 = rij.squaredNorm();
        if (r2 >= std::max(reach2, nearest2)) continue;
        Real const height = -rij.dot(particles.normal[j]);
        if (r2 < reach2)
        {
            (height < 0 ? atEdge : inFront) = true;
            change += meetPlane(particles, images, j, particles.u[i] + change);
        }
        else if (height > 0 && height < surfaceDistance_)
        {
            nearest2 = r2;
            beside = j;
        }
    }
    bool const alone = particles.surface[i] != SurfaceLabel::Interior && atEdge && !inFront && beside >= 0;
    return alone ? Vector(change + meetPlane(particles, images, beside, particles.u[i] + change)) : change;
}

Vector Collision::changeOf(ParticleSet const& particles, NeighbourList const& neighbours, PeriodicImages const& images, int i)
{
    Real const widest = std::max(distance_, surfaceDistance_);
    auto const atSurface = [&](int k) { return particles.surface[k] != SurfaceLabel::Interior; };
    Vector change = Vector::Zero();
    bool besidePlanes = false;
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        bool const wall = !particles.isFluid(j);
        if (wall && alongNormal_)
        {
            besidePlanes = true;
            continue;
        }
        Vector const rij = particles.r[j] - particles.r[i];
        Real const r2 = rij.squaredNorm();
        if (r2 >= widest * widest) continue;
        Real const reach = wall || atSurface(i) || atSurface(j) ? surfaceDistance_ : distance_;
        if (r2 >= reach * reach) continue;
        Real const approach = (particles.u[i] - particles.u[j]).dot(rij);
        if (approach <= 0) continue;
        Vector const du = -(1 + restitution_) * (wall ? 1.0 : 0.5) * approach / (r2 + tiny) * rij;
        change += du;
        if (wall) note(particles, images, j, du, approach / std::sqrt(r2 + tiny));
    }
    return besidePlanes ? Vector(change + meetPlanes(particles, neighbours, images, i)) : change;
}

void Collision::apply(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt)
{
    clearReactions(particles);
    change_.reserve(particles.r.capacity()); // the halo grows now and then
    change_.assign(particles.r.size(), Vector::Zero());
    for (int i : particles.fluid()) change_[i] = changeOf(particles, neighbours, images, i);
    Real gained = 0;
    for (int i : particles.fluid())
    {
        Vector const du = change_[i];
        gained += particleMass_ * du.dot(particles.u[i] + 0.5 * du);
        particles.u[i] += du;
        particles.r[i] += dt * du;
    }
    dissipated_ -= sumOverRanks(gained);
    wallImpulse_ += sumOverRanks(fromWalls_);
    for (Impulse& impulse : reactions_)
        impulse = {sumOverRanks(impulse.linear), sumOverRanks(impulse.moment), sumOverRanks(impulse.amount), sumOverRanks(impulse.rate)};
}

} // namespace mpsDem
