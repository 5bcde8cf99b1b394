#include "core/State.h"

#include "core/Errors.h"

namespace mpsDem {

namespace {

[[noreturn]] void refuse(std::string const& name, std::string const& what)
{
    throw CaseError(ExitCode::InputOutput, "saved state: block \"" + name + "\" " + what,
                    "the state was written by another version or for another case; run setParticles again");
}

template <class T>
T const& only(std::vector<T> const& values, std::string const& name)
{
    if (values.size() != 1) refuse(name, "has " + std::to_string(values.size()) + " values, one is expected");
    return values.front();
}

} // namespace

void State::set(std::string const& name, std::span<Vector const> values)
{
    Reals flat;
    flat.reserve(3 * values.size());
    for (Vector const& v : values) flat.insert(flat.end(), v.data(), v.data() + 3);
    blocks_[name] = std::move(flat);
}

State::Block const& State::block(std::string const& name) const
{
    auto const found = blocks_.find(name);
    if (found == blocks_.end()) refuse(name, "is missing");
    return found->second;
}

State::Reals const& State::reals(std::string const& name) const
{
    auto const* values = std::get_if<Reals>(&block(name));
    if (!values) refuse(name, "does not hold real numbers");
    return *values;
}

State::Integers const& State::integers(std::string const& name) const
{
    auto const* values = std::get_if<Integers>(&block(name));
    if (!values) refuse(name, "does not hold integers");
    return *values;
}

std::vector<Vector> State::vectors(std::string const& name) const
{
    Reals const& flat = reals(name);
    if (flat.size() % 3 != 0) refuse(name, "does not hold vectors");
    std::vector<Vector> values(flat.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = Vector(flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]);
    return values;
}

Vector State::vector(std::string const& name) const { return only(vectors(name), name); }
Real State::real(std::string const& name) const { return only(reals(name), name); }
std::int64_t State::integer(std::string const& name) const { return only(integers(name), name); }

} // namespace mpsDem
