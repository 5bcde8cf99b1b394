#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/State.h"
#include "core/Types.h"
#include "particles/Lattice.h"

namespace mpsDem {

/// What a particle is. The label of a wall particle (`wet`) changes with time, its type does not.
enum class ParticleType : std::uint8_t
{
    Fluid = 0,
    Wall = 1, ///< First row outside a surface, half a spacing behind it; an unknown of eq 8 while it is wet.
    Ghost = 2 ///< Rows behind the wall row; never an unknown.
};

/// Free-surface label of a fluid particle.
enum class SurfaceLabel : std::uint8_t
{
    Interior = 0,
    Surface = 1,    ///< On the free surface: p = 0.
    NearSurface = 2 ///< Has a surface particle within the gradient radius.
};

/// Half-open range of particle numbers, to be used in a range-based for.
struct Range
{
    struct Iterator
    {
        int i;
        int operator*() const { return i; }
        Iterator& operator++()
        {
            ++i;
            return *this;
        }
        bool operator!=(Iterator const& other) const { return i != other.i; }
    };
    int first = 0, last = 0;
    [[nodiscard]] Iterator begin() const { return {first}; }
    [[nodiscard]] Iterator end() const { return {last}; }
    [[nodiscard]] int size() const { return last - first; }
    [[nodiscard]] bool contains(int i) const { return i >= first && i < last; }
};

/// All particles of a rank, one contiguous field per property, in four ranges:
///
///     [ wall | ghost | fluid | halo ]
///
/// Boundary particles stand first and never change their number, so whoever moves them keeps their indices. Fluid particles are
/// re-sorted in space now and then. The halo holds copies of particles owned elsewhere (periodic images, other ranks).
class ParticleSet
{
public:
    explicit ParticleSet(Lattice const& lattice) : lattice_(lattice) {}

    [[nodiscard]] Lattice const& lattice() const { return lattice_; }

    [[nodiscard]] Range wall() const { return {0, walls_}; }
    [[nodiscard]] Range ghost() const { return {walls_, walls_ + ghosts_}; }
    [[nodiscard]] Range boundary() const { return {0, walls_ + ghosts_}; }
    [[nodiscard]] Range fluid() const { return {walls_ + ghosts_, owned_}; }
    [[nodiscard]] Range owned() const { return {0, owned_}; }
    [[nodiscard]] Range halo() const { return {owned_, size()}; }
    [[nodiscard]] int size() const { return static_cast<int>(r.size()); }

    [[nodiscard]] bool isFluid(int i) const { return type[index(i)] == ParticleType::Fluid; }

    // State: kept over time steps and saved.
    Field<Vector> r;          ///< Position [m].
    Field<Vector> u;          ///< Velocity [m/s].
    Field<Real> p;            ///< Pressure [Pa].
    Field<std::int64_t> id;   ///< Unique number, given by setParticles.
    Field<ParticleType> type; ///< What it is.
    Field<int> body;          ///< Index of the body that a boundary particle belongs to; -1 for fluid and fixed walls.
    Field<Vector> normal;     ///< Boundary particles: unit normal of their surface into the fluid; zero for fluid.
    Field<std::uint8_t> wet;  ///< Wall particles: 1 where DBL labels them wall, 0 where ghost. Fluid: always 1.

    Field<Vector> wallAcceleration; ///< Boundary particles only: acceleration of the material point [m/s2]; length boundary().last.

    // Derived: computed anew in every step.
    Field<Vector> uStar;         ///< Velocity after the predictor [m/s].
    Field<Real> n;               ///< Particle number density over n0 [-].
    Field<Vector> F;             ///< Surface vector F_i = (d/n0) sum (r_i - r_j)/|r_ij| w, points out of the fluid [-].
    Field<SurfaceLabel> surface; ///< Free-surface label of fluid particles.
    Field<std::uint8_t> mirror;  ///< 1 where the pressure that a neighbour sees is the neighbour's own (dry walls, ghosts without donors).

    /// Lays out walls, ghosts and fluid given in any order; ids are given 0.. in the resulting order.
    /// @param position, velocity, pressure, type, body, normal  Equal lengths.
    void assign(Field<Vector> const& position, Field<Vector> const& velocity, Field<Real> const& pressure, Field<ParticleType> const& types,
                Field<int> const& bodies, Field<Vector> const& normals);

    /// Reorders the fluid range: particle order[k] of now becomes number fluid().first + k. Derived fields are not kept.
    void reorderFluid(Field<int> const& order);

    /// Changes whenever fluid particles get other numbers: whoever keeps something by number compares it.
    [[nodiscard]] int generation() const { return generation_; }

    /// Removes the halo.
    void dropHalo() { resize(owned_); }
    /// Appends room for `count` halo particles, default values.
    void appendHalo(int count) { resize(owned_ + count); }

    void save(State& state) const; ///< Blocks "particles/...": owned particles in their present order.
    /// What the particles of a state were made for; nothing in states of older versions.
    [[nodiscard]] static std::optional<Lattice> savedLattice(State const& state);
    void load(State const& state); ///< @throw CaseError for lengths that do not fit together.

    /// Index type of the fields.
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

private:
    void resize(int size);

    Lattice lattice_;
    int walls_ = 0, ghosts_ = 0, owned_ = 0, generation_ = 0;
};

} // namespace mpsDem
