#pragma once

#include "particles/GradientSums.h"
#include "particles/NeighbourList.h"
#include "particles/ParticleSet.h"
#include "particles/ReferenceConstants.h"

namespace mpsDem {

/// Divergence at a fluid particle, exact for linear fields however the cloud is strained, where eq 5 sees .44 of a rate of strain along the
/// rows of a lattice as a divergence:
/// \f[ \langle\nabla\cdot\Phi\rangle_i = \frac{d}{n^0}\sum_{j\ne i} \delta\Phi_{ij}\cdot C_i\,\mathbf r_{ij}\frac{w(r_{ij})}{r_{ij}^2} \f]
/// dPhi = Phi_j - Phi_i; from a boundary particle only its part along the normal of the surface, past which the water slips. Eq 5 with
/// these differences where there are too few neighbours for C.
///
/// @param phi  phi(j) is the field at particle j.
template <int d, class Phi>
Real correctedDivergence(ParticleSet const& particles, NeighbourList const& neighbours, ReferenceConstants const& constants, Phi const& phi,
                         int i)
{
    using Square = typename MomentSum<d>::Square;
    Real const* const w = neighbours.gradientWeight();
    Vector const ri = particles.r[i], phi_i = phi(i);
    MomentSum<d> moment;
    Square gradient = Square::Zero();
    for (int k = neighbours.first(i); k < neighbours.last(i); ++k)
    {
        int const j = neighbours.index()[k];
        Vector const rij = particles.r[j] - ri;
        Vector difference = phi(j) - phi_i;
        if (!particles.isFluid(j)) difference = particles.normal[j].dot(difference) * particles.normal[j];
        Real const q = w[k] / (rij.squaredNorm() + tiny);
        moment.add(rij, q);
        gradient += (q * difference.template head<d>()) * rij.template head<d>().transpose();
    }
    Real const factor = d / constants.n0;
    Square c = Square::Identity();
    moment.invert(factor, c);
    return factor * gradient.cwiseProduct(c).sum(); // trace of the product: C is symmetric
}

} // namespace mpsDem
