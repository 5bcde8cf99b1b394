#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Everything that must survive a restart, as named blocks of numbers.
///
/// Whoever owns state writes it here under a name of its own ("body/slide/position") and reads it back from there:
/// the io library stores the blocks without knowing what they mean. A missing block is an error, never a default.
class State
{
public:
    using Reals = std::vector<Real>;
    using Integers = std::vector<std::int64_t>;
    using Block = std::variant<Reals, Integers>;

    /// Writes the block `name`, in place of one of that name: vectors as three numbers each, single values as blocks of one.
    void set(std::string const& name, std::span<Real const> values) { blocks_[name] = Reals(values.begin(), values.end()); }
    void set(std::string const& name, std::span<std::int64_t const> values) { blocks_[name] = Integers(values.begin(), values.end()); }
    void set(std::string const& name, std::span<Vector const> values);
    void set(std::string const& name, Vector const& value) { set(name, std::span<Vector const>(&value, 1)); }
    void set(std::string const& name, Real value) { set(name, std::span<Real const>(&value, 1)); }
    void set(std::string const& name, std::int64_t value) { set(name, std::span<std::int64_t const>(&value, 1)); }
    /// Takes a block as it is.
    void setBlock(std::string const& name, Block block) { blocks_[name] = std::move(block); }

    /// Whether there is a block `name`.
    [[nodiscard]] bool has(std::string const& name) const { return blocks_.count(name) != 0; }

    /// @throw CaseError (InputOutput) for a missing block or one of another kind or length.
    [[nodiscard]] Reals const& reals(std::string const& name) const;
    [[nodiscard]] Integers const& integers(std::string const& name) const;
    [[nodiscard]] std::vector<Vector> vectors(std::string const& name) const;
    [[nodiscard]] Vector vector(std::string const& name) const;
    [[nodiscard]] Real real(std::string const& name) const;
    [[nodiscard]] std::int64_t integer(std::string const& name) const;

    [[nodiscard]] std::map<std::string, Block> const& blocks() const { return blocks_; }

private:
    Block const& block(std::string const& name) const;

    std::map<std::string, Block> blocks_;
};

} // namespace mpsDem
