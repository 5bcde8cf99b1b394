#include "particles/ReferenceConstants.h"

#include <cmath>

namespace mpsDem {

ReferenceConstants referenceConstants(Lattice const& lattice, Real radius)
{
    Kernel const w{radius};
    int const reach = static_cast<int>(std::ceil(radius / lattice.spacing));
    int const reachZ = lattice.dimensions == 3 ? reach : 0;
    Real n0 = 0, second = 0;
    Vector surfaceSum = Vector::Zero();
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (int k = -reachZ; k <= reachZ; ++k)
            {
                if (i == 0 && j == 0 && k == 0) continue;
                Vector const rij = lattice.spacing * Vector(i, j, k);
                Real const r = rij.norm(), wij = w(r);
                n0 += wij;
                second += wij * r * r;
                if (j <= 0) surfaceSum -= wij / r * rij; // the half space below a plane surface
            }
    return {n0, second / n0, lattice.dimensions / n0 * surfaceSum.norm()};
}

} // namespace mpsDem
