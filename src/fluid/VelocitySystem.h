#pragma once

#include <utility>
#include <vector>

#include "core/Types.h"

namespace mpsDem {

/// A sparse symmetric positive definite system with the velocity of each fluid particle as unknown, one matrix for all components.
///
/// Conjugate gradients with the diagonal as preconditioner, for the diagonally dominant matrix of the implicit viscous term. No allocation
/// once the sizes have been seen.
class VelocitySystem
{
public:
    /// Begins anew, with so many rows to come.
    void begin(int rows);
    /// An entry of the row that is being made, off the diagonal; each column once, in any order.
    void add(int column, Real value) { entries_.emplace_back(column, value); }
    /// Ends the row.
    void endRow(Real diagonal, Vector const& right, Vector const& guess);

    /// Solves until |b - A x| <= tolerance |b| for each component.
    void solve(Real tolerance);
    [[nodiscard]] Vector solution(int row) const { return x_.row(row).transpose(); }

private:
    /// image_ = A v.
    void multiply(Eigen::Ref<Eigen::VectorXd const> const& v);
    void solveComponent(int component, Real tolerance);

    std::vector<std::pair<int, Real>> entries_; ///< Of the present row.
    Field<int> rowStart_, column_;
    Field<Real> value_;
    Eigen::Matrix<Real, Eigen::Dynamic, 3> right_, x_;
    Eigen::VectorXd inverseDiagonal_, residual_, direction_, image_, scaled_;
};

} // namespace mpsDem
