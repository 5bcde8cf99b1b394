#pragma once

#include <Eigen/LU>

#include "core/Types.h"

namespace mpsDem {

/// C^-1 = d/n0 sum_j w r_ij r_ij^T/r^2 of one particle: what makes gradients of linear fields exact.
template <int d>
struct MomentSum
{
    using Square = Eigen::Matrix<Real, d, d>;

    /// Determinant of C^-1 below which there are too few neighbours around.
    /// Of a lattice: half space .42 in 2-D and .35 in 3-D, quarter .17 and .12.
    static constexpr Real smallestDeterminant = d == 2 ? 0.2 : 0.15;

    Tensor moment = Tensor::Zero();

    /// @param q  w/r^2.
    void add(Vector const& rij, Real q)
    {
        for (int a = 0; a < d; ++a)
            for (int b = a; b < d; ++b) moment(a, b) += q * rij[a] * rij[b];
    }

    /// C. @param factor  d/n0. @return false, and C as it was, where there are too few neighbours.
    bool invert(Real factor, Square& c) const
    {
        Square inverse;
        for (int a = 0; a < d; ++a)
            for (int b = a; b < d; ++b) inverse(a, b) = inverse(b, a) = factor * moment(a, b);
        if (inverse.determinant() < smallestDeterminant) return false;
        c = inverse.inverse();
        return true;
    }
};

/// Sums over the neighbours of one particle for its pressure gradient: of (p_j + p_i) for eq 4, and of (p_j - p_i) with the matrix C^-1 for
/// the corrected form (GradientScheme).
template <int d>
struct GradientSums
{
    Vector symmetric = Vector::Zero();
    Vector difference = Vector::Zero();
    MomentSum<d> moment;

    void add(Vector const& rij, Real pi, Real pj, Real w)
    {
        Real const q = w / (rij.squaredNorm() + tiny);
        symmetric += (q * (pj + pi)) * rij;
        difference += (q * (pj - pi)) * rij;
        moment.add(rij, q);
    }

    /// The corrected gradient. @param factor  d/n0. @return false, and `gradient` as it was, where there are too few neighbours.
    bool corrected(Real factor, Vector& gradient) const
    {
        typename MomentSum<d>::Square c;
        if (!moment.invert(factor, c)) return false;
        gradient.setZero();
        gradient.template head<d>() = c * (factor * difference.template head<d>());
        return true;
    }
};

} // namespace mpsDem
