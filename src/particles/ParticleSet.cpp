#include "particles/ParticleSet.h"

#include <array>

#include "core/Errors.h"

namespace mpsDem {

void ParticleSet::resize(int size)
{
    std::size_t const count = index(size);
    r.resize(count, Vector::Zero());
    u.resize(count, Vector::Zero());
    p.resize(count, 0);
    id.resize(count, -1);
    type.resize(count, ParticleType::Fluid);
    body.resize(count, -1);
    normal.resize(count, Vector::Zero());
    wet.resize(count, 1);
    uStar.resize(count, Vector::Zero());
    n.resize(count, 0);
    F.resize(count, Vector::Zero());
    surface.resize(count, SurfaceLabel::Interior);
    mirror.resize(count, 0);
}

void ParticleSet::assign(Field<Vector> const& position, Field<Vector> const& velocity, Field<Real> const& pressure,
                         Field<ParticleType> const& types, Field<int> const& bodies, Field<Vector> const& normals)
{
    resize(0);
    resize(static_cast<int>(position.size()));
    owned_ = size();
    walls_ = ghosts_ = 0;
    int next = 0;
    for (ParticleType const wanted : {ParticleType::Wall, ParticleType::Ghost, ParticleType::Fluid})
    {
        for (std::size_t i = 0; i < position.size(); ++i)
        {
            if (types[i] != wanted) continue;
            std::size_t const k = index(next);
            r[k] = position[i];
            u[k] = velocity[i];
            p[k] = pressure[i];
            id[k] = next++;
            type[k] = wanted;
            body[k] = bodies[i];
            normal[k] = normals[i];
            wet[k] = wanted == ParticleType::Fluid ? 1 : 0;
        }
        if (wanted == ParticleType::Wall) walls_ = next;
        if (wanted == ParticleType::Ghost) ghosts_ = next - walls_;
    }
    wallAcceleration.assign(index(boundary().last), Vector::Zero());
    ++generation_;
}

namespace {

constexpr char const* latticeBlock = "particles/lattice"; ///< Dimensions, spacing [m], thickness [m].

template <class T>
void permute(Field<T>& field, int first, Field<int> const& order)
{
    thread_local Field<T> sorted; // kept: a run sorts now and then
    sorted.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = field[static_cast<std::size_t>(order[k])];
    std::copy(sorted.begin(), sorted.end(), field.begin() + first);
}

} // namespace

void ParticleSet::reorderFluid(Field<int> const& order)
{
    expect(halo().size() == 0, "ParticleSet::reorderFluid: drop the halo first");
    int const first = fluid().first;
    ++generation_;
    owned_ = first + static_cast<int>(order.size());
    permute(r, first, order);
    permute(u, first, order);
    permute(p, first, order);
    permute(id, first, order);
    resize(owned_);
}

void ParticleSet::save(State& state) const
{
    std::size_t const count = index(owned_);
    std::array<Real, 3> const lattice{static_cast<Real>(lattice_.dimensions), lattice_.spacing, lattice_.thickness};
    state.set(latticeBlock, std::span<Real const>(lattice));
    state.set("particles/position", std::span(r.data(), count));
    state.set("particles/velocity", std::span(u.data(), count));
    state.set("particles/pressure", std::span(p.data(), count));
    state.set("particles/id", std::span<std::int64_t const>(id.data(), count));
    std::vector<std::int64_t> kind(count), owner(count), label(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        kind[i] = static_cast<std::int64_t>(type[i]);
        owner[i] = body[i];
        label[i] = wet[i];
    }
    state.set("particles/type", std::span<std::int64_t const>(kind));
    state.set("particles/body", std::span<std::int64_t const>(owner));
    state.set("particles/wet", std::span<std::int64_t const>(label));
    state.set("particles/normal", std::span(normal.data(), index(boundary().last)));
}

std::optional<Lattice> ParticleSet::savedLattice(State const& state)
{
    if (!state.has(latticeBlock)) return std::nullopt;
    State::Reals const& saved = state.reals(latticeBlock);
    if (saved.size() != 3) throw CaseError(ExitCode::InputOutput, "saved state: damaged block " + std::string(latticeBlock));
    return Lattice{static_cast<int>(saved[0]), saved[1], saved[2]};
}

void ParticleSet::load(State const& state)
{
    auto const position = state.vectors("particles/position");
    auto const velocity = state.vectors("particles/velocity");
    auto const normals = state.vectors("particles/normal");
    auto const& pressure = state.reals("particles/pressure");
    auto const& ids = state.integers("particles/id");
    auto const& kind = state.integers("particles/type");
    auto const& owner = state.integers("particles/body");
    auto const& label = state.integers("particles/wet");
    std::size_t const count = position.size();
    bool const equal = velocity.size() == count && pressure.size() == count && ids.size() == count && kind.size() == count &&
                       owner.size() == count && label.size() == count && normals.size() <= count;
    if (!equal) throw CaseError(ExitCode::InputOutput, "saved state: particle fields differ in length");
    resize(0);
    resize(static_cast<int>(count));
    owned_ = size();
    walls_ = ghosts_ = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        r[i] = position[i];
        u[i] = velocity[i];
        p[i] = pressure[i];
        id[i] = ids[i];
        type[i] = static_cast<ParticleType>(kind[i]);
        body[i] = static_cast<int>(owner[i]);
        wet[i] = static_cast<std::uint8_t>(label[i]);
        if (i < normals.size()) normal[i] = normals[i];
        if (type[i] == ParticleType::Wall) ++walls_;
        if (type[i] == ParticleType::Ghost) ++ghosts_;
    }
    wallAcceleration.assign(index(boundary().last), Vector::Zero());
    ++generation_;
}

} // namespace mpsDem
