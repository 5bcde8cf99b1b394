#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// Square sparse matrix by compressed rows.
///
/// The pressure equation gives a symmetric positive (semi)definite M-matrix: positive diagonal, off-diagonals <= 0, row sums >= 0.
/// Each row is sorted by column and holds its diagonal; a particle with known pressure is an identity row without couplings.
struct SparseMatrix
{
    int rows = 0;
    std::vector<int> rowStart; ///< rows + 1 entries; row i is [rowStart[i], rowStart[i + 1]).
    std::vector<int> column;
    std::vector<Real> value;

    [[nodiscard]] std::size_t entries() const { return value.size(); }
};

/// y = A x.
inline void multiply(SparseMatrix const& a, std::span<Real const> x, std::span<Real> y)
{
    for (int i = 0; i < a.rows; ++i)
    {
        Real sum = 0;
        for (int k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k) sum += a.value[k] * x[a.column[k]];
        y[i] = sum;
    }
}

/// Norm of a vector, sqrt(sum v_i^2).
inline Real norm(std::span<Real const> v)
{
    Real sum = 0;
    for (Real const value : v) sum += value * value;
    return std::sqrt(sum);
}

/// |b - A x| / |b|, or |A x| where b vanishes.
inline Real relativeResidual(SparseMatrix const& a, std::span<Real const> b, std::span<Real const> x)
{
    Real square = 0;
    for (int i = 0; i < a.rows; ++i)
    {
        Real rest = b[i];
        for (int k = a.rowStart[i]; k < a.rowStart[i + 1]; ++k) rest -= a.value[k] * x[a.column[k]];
        square += rest * rest;
    }
    Real const scale = norm(b);
    return scale > 0 ? std::sqrt(square) / scale : std::sqrt(square);
}

} // namespace mpsDem
