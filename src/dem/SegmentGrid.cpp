#include "dem/SegmentGrid.h"

#include <algorithm>
#include <cmath>

namespace mpsDem {

SegmentGrid::SegmentGrid(std::vector<Facet> const& facets, Real cell) : cell_(cell)
{
    for (Facet const& facet : facets)
    {
        box_.add(facet.a);
        box_.add(facet.b);
    }
    Vector const size = box_.high - box_.low;
    Real const most = 1000;
    cell_ = std::max({cell_, size.x() / most, size.y() / most});
    columns_ = 1 + static_cast<int>(size.x() / cell_);
    rows_ = 1 + static_cast<int>(size.y() / cell_);

    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (Facet const& facet : facets) visitCells(facet, [&](std::size_t c) { ++first_[c + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    entries_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<int> fill(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < facets.size(); ++i)
        visitCells(facets[i], [&](std::size_t c) { entries_[static_cast<std::size_t>(fill[c]++)] = static_cast<int>(i); });
}

int SegmentGrid::column(Real x) const
{
    return static_cast<int>(std::clamp(std::floor((x - box_.low.x()) / cell_), Real(0), Real(columns_ - 1)));
}

int SegmentGrid::row(Real y) const
{
    return static_cast<int>(std::clamp(std::floor((y - box_.low.y()) / cell_), Real(0), Real(rows_ - 1)));
}

template <class Visitor>
void SegmentGrid::visitCells(Facet const& facet, Visitor&& visit) const
{
    // Row by row: the part of the side within the row, one thousandth of a cell wider on each side.
    Real const margin = 1e-3 * cell_;
    Vector const low = facet.a.cwiseMin(facet.b);
    Vector const high = facet.a.cwiseMax(facet.b);
    Real const dy = facet.b.y() - facet.a.y();
    for (int j = row(low.y() - margin); j <= row(high.y() + margin); ++j)
    {
        Real left = low.x();
        Real right = high.x();
        if (std::abs(dy) > margin)
        {
            Real const bottom = box_.low.y() + j * cell_ - margin;
            Real const top = bottom + cell_ + 2 * margin;
            Real const s0 = std::clamp((bottom - facet.a.y()) / dy, Real(0), Real(1));
            Real const s1 = std::clamp((top - facet.a.y()) / dy, Real(0), Real(1));
            Real const x0 = facet.a.x() + s0 * (facet.b.x() - facet.a.x());
            Real const x1 = facet.a.x() + s1 * (facet.b.x() - facet.a.x());
            left = std::min(x0, x1);
            right = std::max(x0, x1);
        }
        for (int i = column(left - margin); i <= column(right + margin); ++i)
            visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i));
    }
}

void SegmentGrid::near(Vector const& r, Real reach, std::vector<int>& indices) const
{
    indices.clear();
    if (box_.distance({r.x(), r.y(), box_.low.z()}) > reach) return;
    for (int j = row(r.y() - reach); j <= row(r.y() + reach); ++j)
        for (int i = column(r.x() - reach); i <= column(r.x() + reach); ++i)
        {
            std::size_t const c = static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
            indices.insert(indices.end(), entries_.begin() + first_[c], entries_.begin() + first_[c + 1]);
        }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

} // namespace mpsDem
