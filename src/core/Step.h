#pragma once

#include <cstdint>

#include "core/Types.h"

namespace mpsDem {

/// One time step t^m -> t^{m+1}.
struct Step
{
    std::int64_t number = 0; ///< Counted from the very start, over restarts.
    Real time = 0;           ///< t^{m+1}, the time reached at its end [s].
    Real dt = 0;             ///< Length [s].
    bool write = false;      ///< True where fields are written at its end.

    [[nodiscard]] Real begin() const { return time - dt; }
};

} // namespace mpsDem
