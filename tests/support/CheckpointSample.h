#pragma once

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/Checkpoint.h"

namespace mpsDem {

/// A small state with the numbers that text or arithmetic would spoil; `seed` makes states differ.
inline State sampleState(int seed = 1)
{
    using Limits = std::numeric_limits<Real>;
    State state;
    std::vector<Real> const edges = {0.0, -0.0, Limits::denorm_min(), -Limits::max(), Limits::infinity(), Limits::quiet_NaN(), 0.1 * seed};
    state.set("edges", edges);
    std::vector<Vector> positions;
    for (int i = 0; i < 40; ++i) positions.emplace_back(0.01 * i, 1.0 / (i + seed), 0.0);
    state.set("particles/position", positions);
    std::vector<std::int64_t> const ids = {std::numeric_limits<std::int64_t>::min(), -1, 0, seed, (std::int64_t{1} << 53) + 1};
    state.set("particles/id", ids);
    state.set("contact/springs", std::vector<Real>{});
    state.set("body/slide/position", Vector(1.0 / 3, seed, 0));
    return state;
}

inline CheckpointInfo sampleInfo(std::int64_t step, Real time)
{
    CheckpointInfo info;
    info.step = step;
    info.time = time;
    info.codeVersion = "1.0";
    info.inputHash = "0123abcd";
    info.effects = {"fluid", "rigid bodies, 1"};
    return info;
}

/// Same names, kinds, lengths and bits (NaN and signed zero included).
inline bool sameBits(State const& a, State const& b)
{
    if (a.blocks().size() != b.blocks().size()) return false;
    for (auto const& [name, block] : a.blocks())
    {
        if (!b.has(name) || b.blocks().at(name).index() != block.index()) return false;
        auto const equal = [&](auto const& values) {
            auto const& others = std::get<std::decay_t<decltype(values)>>(b.blocks().at(name));
            bool const sameSize = values.size() == others.size();
            return sameSize && (values.empty() || std::memcmp(values.data(), others.data(), values.size() * sizeof(values[0])) == 0);
        };
        if (!std::visit(equal, block)) return false;
    }
    return true;
}

} // namespace mpsDem
