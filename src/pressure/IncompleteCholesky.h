#pragma once

#include <vector>

#include "core/Types.h"
#include "pressure/SparseMatrix.h"

namespace mpsDem {

/// Strict triangle of a matrix by rows.
///
/// Each row is filled with zeros to a multiple of four entries: a loop of nearly constant length costs no mispredicted branch per row,
/// which halves the time of a sweep over short rows.
struct Triangle
{
    static constexpr int unit = 4;

    std::vector<int> start;
    std::vector<int> column;
    std::vector<Real> value;

    /// Address space for so many entries; what they held is lost where there was less.
    void reserve(std::size_t entries);
    /// At least so many entries, within what is reserved: pages are taken as rows are filled.
    void makeRoom(std::size_t entries);

    /// Fills row i, whose entries end at `last`, with zeros. The neighbour that a sweep computes last is to be used last: the largest
    /// column of a lower triangle is put at the end of its row, the smallest one of an upper triangle in front.
    void closeRow(int i, int last, bool isLower);

    /// sum - sum_k value_k x[column_k] over row i, from front to back: the last entry depends on the row before.
    [[nodiscard]] Real subtractForward(int i, Real const* x, Real sum) const
    {
        int const* const c = column.data();
        Real const* const v = value.data();
        for (int k = start[i]; k < start[i + 1]; k += unit)
        {
            sum -= v[k] * x[c[k]];
            sum -= v[k + 1] * x[c[k + 1]];
            sum -= v[k + 2] * x[c[k + 2]];
            sum -= v[k + 3] * x[c[k + 3]];
        }
        return sum;
    }

    /// The same from back to front: the first entry depends on the row after.
    [[nodiscard]] Real subtractBackward(int i, Real const* x, Real sum) const
    {
        int const* const c = column.data();
        Real const* const v = value.data();
        for (int k = start[i + 1] - 1; k >= start[i]; k -= unit)
        {
            sum -= v[k] * x[c[k]];
            sum -= v[k - 1] * x[c[k - 1]];
            sum -= v[k - 2] * x[c[k - 2]];
            sum -= v[k - 3] * x[c[k - 3]];
        }
        return sum;
    }
};

/// Modified incomplete Cholesky factorisation without fill, M = (D + L) D^-1 (D + L^T), L the strict lower triangle of A.
///
/// The fill that M has and A has not is moved to the diagonal, so that M and A have the same row sums up to a term of order h^2
/// (Gustafsson, BIT 18 (1978) 142); the number of iterations then grows with h^-1/2 where it grows with h^-1 otherwise.
/// Everything is kept scaled to D = 1 and in the order of elimination: A = L + (2 - C) + U.
class IncompleteCholesky
{
public:
    /// Chooses the order of elimination: that of the rows, or reverse breadth-first order from row 0 (Cuthill and McKee) where theirs is
    /// poor. In the latter every row but one of each component has a later neighbour, which a modified factorisation needs.
    void chooseOrder(SparseMatrix const& a);

    /// Factorises a matrix for which the order was chosen (or one with the same rows).
    /// @param shift  rise of the diagonal, in units of it. @param dimensions 2 or 3: gives the mesh width from the number of rows.
    void factorise(SparseMatrix const& a, Real shift, int dimensions);

    std::vector<int> order; ///< Row of the matrix that is eliminated as i-th.
    Triangle lower;
    Triangle upper;
    std::vector<Real> scale;  ///< D^-1/2
    std::vector<Real> defect; ///< C = 2 - a_ii / D_i

private:
    /// What the pivot of a row is made of.
    struct Split
    {
        Real diagonal = 0;
        Real fill = 0;   // the dropped fill that the diagonal takes
        Real right = 0;  // sum of the couplings to later rows
        int balance = 0; // entries before the diagonal less those behind it
    };

    Split splitRow(SparseMatrix const& a, int i, Real share);

    std::vector<int> rank_; // the inverse of order
    std::vector<Real> right_;
    std::vector<Real> inverse_; // 1 / D
};

} // namespace mpsDem
