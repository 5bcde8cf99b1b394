#include "pressure/IncompleteCholesky.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// A pivot below this share of the diagonal is replaced by the diagonal: the last row of a singular system, or one without later neighbours.
constexpr Real smallestPivot = 0.02;
/// Rows without any coupling to a later row, as share of all: above it the rows are eliminated in an order of our own.
constexpr Real disorderLimit = 0.0015;

int padded(int count) { return (count + Triangle::unit - 1) / Triangle::unit * Triangle::unit; }

/// How the dropped fill enters the pivots. The mesh width is h = N^(-1/d).
struct FillRule
{
    /// Share m of the fill that is moved to the diagonal, m = 1 - c h^2. With m = 1 a few tiny pivots spoil the condition number, with a
    /// constant m < 1 the iterations grow as without modification.
    Real share;
    /// Least pivot, in units of the sum of the couplings to later rows: 1 + e h. It bounds the largest eigenvalue of M^-1 A by about
    /// 1 / (e h), also where rows come in bad order (Notay, DRIC, Numer. Linear Algebra Appl. 1 (1994) 511).
    Real floor;
};

/// c and e are the best of a scan over 1e3 .. 1e5 rows (etc/doc/linear-solvers.md).
FillRule fillRule(int rows, int dimensions)
{
    Real const h = 1 / (dimensions == 2 ? std::sqrt(Real(rows)) : std::cbrt(Real(rows)));
    Real const loss = dimensions == 2 ? 20 : 6;
    Real const rise = dimensions == 2 ? 2 : 1;
    return {std::max(Real(0), 1 - loss * h * h), 1 + rise * h};
}

} // namespace

void IncompleteCholesky::chooseOrder(SparseMatrix const& a)
{
    order.resize(static_cast<std::size_t>(a.rows));
    rank_.resize(order.size());
    int last = 0;
    for (int i = 0; i < a.rows; ++i)
    {
        bool const coupled = a.rowStart[i + 1] - a.rowStart[i] > 1;
        last += coupled && a.column[a.rowStart[i + 1] - 1] == i;
    }
    if (last <= disorderLimit * a.rows + 1)
    {
        std::iota(order.begin(), order.end(), 0);
        std::iota(rank_.begin(), rank_.end(), 0);
        return;
    }
    std::fill(rank_.begin(), rank_.end(), -1);
    int head = 0;
    int tail = 0;
    for (int seed = 0; seed < a.rows; ++seed)
    {
        if (rank_[seed] >= 0) continue;
        rank_[seed] = 0;
        order[tail++] = seed;
        for (; head < tail; ++head)
        {
            int const row = order[head];
            for (int k = a.rowStart[row]; k < a.rowStart[row + 1]; ++k)
            {
                int const next = a.column[k];
                if (rank_[next] >= 0) continue;
                rank_[next] = 0;
                order[tail++] = next;
            }
        }
    }
    std::reverse(order.begin(), order.end());
    for (int i = 0; i < a.rows; ++i) rank_[order[i]] = i;
}

/// D_i = a_ii - sum_{k<i} a_ik / D_k (m U_k + (1 - m) a_ki), U_k = sum of row k right of its diagonal, m = FillRule::share.
void IncompleteCholesky::factorise(SparseMatrix const& a, Real shift, int dimensions)
{
    auto const n = static_cast<std::size_t>(a.rows);
    std::size_t const room = a.entries() / 2 + Triangle::unit * n;
    for (auto* const work : {&scale, &defect, &right_, &inverse_}) work->resize(n);
    for (Triangle* const triangle : {&lower, &upper})
    {
        triangle->start.resize(n + 1);
        triangle->reserve(room);
    }
    lower.start[0] = 0;
    upper.start[0] = 0;
    FillRule const rule = fillRule(a.rows, dimensions);
    int balance = 0;
    for (int i = 0; i < a.rows; ++i)
    {
        Split const split = splitRow(a, i, rule.share);
        Real pivot = std::max((1 + shift) * split.diagonal - split.fill, -rule.floor * split.right);
        if (!(pivot >= smallestPivot * split.diagonal)) pivot = split.diagonal;
        balance += split.balance;
        right_[i] = split.right;
        inverse_[i] = 1 / pivot;
        scale[i] = 1 / std::sqrt(pivot);
        defect[i] = 2 - split.diagonal / pivot;
    }
    expect(balance == 0, "IncompleteCholesky: the matrix is not symmetric");
    for (Triangle* const triangle : {&lower, &upper})
    {
        for (int i = 0; i < a.rows; ++i)
        {
            Real const own = scale[i];
            for (int k = triangle->start[i]; k < triangle->start[i + 1]; ++k) triangle->value[k] *= own * scale[triangle->column[k]];
        }
    }
}

/// Sorts the entries of row i (of the elimination) into both triangles and sums up what its pivot needs.
IncompleteCholesky::Split IncompleteCholesky::splitRow(SparseMatrix const& a, int i, Real share)
{
    int const row = order[i];
    Split split;
    int l = lower.start[i];
    int u = upper.start[i];
    int const length = padded(a.rowStart[row + 1] - a.rowStart[row]);
    lower.makeRoom(static_cast<std::size_t>(l + length));
    upper.makeRoom(static_cast<std::size_t>(u + length));
    for (int k = a.rowStart[row]; k < a.rowStart[row + 1]; ++k)
    {
        int const j = rank_[a.column[k]];
        Real const value = a.value[k];
        if (j < i)
        {
            split.fill += value * inverse_[j] * (share * right_[j] + (1 - share) * value);
            lower.column[l] = j;
            lower.value[l++] = value;
        }
        else if (j > i)
        {
            split.right += value;
            upper.column[u] = j;
            upper.value[u++] = value;
        }
        else
        {
            split.diagonal = value;
        }
    }
    split.balance = (l - lower.start[i]) - (u - upper.start[i]);
    lower.closeRow(i, l, true);
    upper.closeRow(i, u, false);
    return split;
}

void Triangle::reserve(std::size_t entries)
{
    if (entries <= column.capacity()) return;
    column = {}; // nothing of the old entries is wanted: both at once would be the peak of a run's memory
    value = {};
    column.reserve(entries + entries / 4);
    value.reserve(entries + entries / 4);
}

void Triangle::makeRoom(std::size_t entries)
{
    if (entries <= column.size()) return;
    column.resize(std::max(entries, std::min(column.capacity(), entries + entries / 64)));
    value.resize(column.size());
}

void Triangle::closeRow(int i, int last, bool isLower)
{
    int const first = start[i];
    int const end = first + padded(last - first);
    start[i + 1] = end;
    if (first == end) return;
    int const filler = column[first];
    for (int k = last; k < end; ++k)
    {
        column[k] = filler;
        value[k] = 0;
    }
    int const place = isLower ? end - 1 : first;
    int nearest = first;
    for (int k = first; k < last; ++k)
    {
        if (isLower ? column[k] > column[nearest] : column[k] < column[nearest]) nearest = k;
    }
    std::swap(column[place], column[nearest]);
    std::swap(value[place], value[nearest]);
}

} // namespace mpsDem
