#pragma once

#include "core/Types.h"

namespace mpsDem {

/// Kernel function of eq 3 (Zhang et al. 2014), finite at r = 0:
/// \f[ w(r) = \frac{r_e}{0.85 r + 0.15 r_e} - 1 \quad (0 \le r < r_e), \qquad w(r) = 0 \quad (r \ge r_e) \f]
struct Kernel
{
    Real re; ///< Effective radius r_e [m].

    [[nodiscard]] Real operator()(Real r) const { return r < re ? re / (0.85 * r + 0.15 * re) - 1 : 0; }
};

} // namespace mpsDem
