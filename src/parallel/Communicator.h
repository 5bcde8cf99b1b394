#pragma once

#include <cstdint>
#include <span>

#include "core/Types.h"

namespace mpsDem {

/// The ranks of a run: the only place through which a number of one rank reaches another one.
///
/// This version runs on one rank, where every operation leaves its numbers as they are. Each one is collective: all ranks call it, in the
/// same order, and all get the same bytes. See etc/doc/architecture.md for how further ranks attach.
class Communicator
{
public:
    [[nodiscard]] static int ranks();
    [[nodiscard]] static int rank();
    [[nodiscard]] static bool isMaster() { return rank() == 0; }

    /// Replace each number by that over all ranks. min and max are those of numbers: what is none must be told apart (Extremum of
    /// Reduce.h), for MPI_MIN and MPI_MAX lose it unless it sits on rank 0.
    static void sum(std::span<Real> values);
    static void sum(std::span<std::int64_t> values);
    static void min(std::span<Real> values);
    static void max(std::span<Real> values);
};

} // namespace mpsDem
