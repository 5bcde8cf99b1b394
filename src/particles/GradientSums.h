#pragma once

#include "core/Types.h"

namespace mpsDem {

/// Sums over the neighbours of one particle for its pressure gradient: of (p_j + p_i) for eq 4, and of (p_j - p_i) with the matrix C^-1 for
/// the corrected form (GradientScheme).
template <int d>
struct GradientSums
{
    /// Determinant of C^-1 below which there are too few neighbours around for the corrected form.
    static constexpr Real smallestDeterminant = 0.2;

    Vector symmetric = Vector::Zero();
    Vector difference = Vector::Zero();
    Tensor moment = Tensor::Zero();

    void add(Vector const& rij, Real pi, Real pj, Real w)
    {
        Real const q = w / (rij.squaredNorm() + tiny);
        symmetric += (q * (pj + pi)) * rij;
        difference += (q * (pj - pi)) * rij;
        for (int a = 0; a < d; ++a)
            for (int b = a; b < d; ++b) moment(a, b) += q * rij[a] * rij[b];
    }

    /// The corrected gradient. @param factor  d/n0. @return false, and `gradient` as it was, where there are too few neighbours.
    bool corrected(Real factor, Vector& gradient) const
    {
        Eigen::Matrix<Real, d, d> inverse;
        for (int a = 0; a < d; ++a)
            for (int b = a; b < d; ++b) inverse(a, b) = inverse(b, a) = factor * moment(a, b);
        if (inverse.determinant() < smallestDeterminant) return false;
        gradient.setZero();
        gradient.template head<d>() = inverse.inverse() * (factor * difference.template head<d>());
        return true;
    }
};

} // namespace mpsDem
