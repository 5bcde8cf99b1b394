#pragma once

#include <cstdint>
#include <span>

#include "core/Types.h"
#include "pressure/SparseMatrix.h"

namespace mpsDem {

/// Groups of rows that no particle with p = 0 touches: their pressure is known up to a constant only.
class PressureGroups
{
public:
    /// Flood fill over the matrix from all pinned rows; what it doesn't reach falls into groups.
    /// @param pinned  Per row: 1 where the row is coupled to a known pressure.
    void find(SparseMatrix const& matrix, Field<std::uint8_t> const& pinned);

    [[nodiscard]] int count() const { return static_cast<int>(size_.size()); }

    /// Takes the mean of each group off the right side; groups of up to three rows get zero.
    void makeCompatible(std::span<Real> right);

    /// Shifts each group so that its lowest value is zero; groups of up to three rows become zero.
    void shift(std::span<Real> solution);

private:
    static constexpr int smallGroup = 3; ///< Rows; a lone particle, a pair or a triple in flight carries no pressure.

    void flood(SparseMatrix const& matrix, int seed, int label);

    Field<int> group_; ///< Per row: -1 pinned, else number of its group.
    Field<int> size_;  ///< Rows of each group.
    Field<int> stack_;
    Field<Real> mean_, lowest_; ///< Per group.
};

} // namespace mpsDem
