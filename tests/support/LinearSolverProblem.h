#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "core/Types.h"
#include "pressure/SparseMatrix.h"

namespace mpsDem::test {

/// A tank of moving points whose pressure equation the tests and the benchmark of the linear solvers solve.
///
/// Points on a lattice of spacing 1, displaced at random; the top layer has p = 0 and is eliminated, the other sides are walls without
/// particles (Neumann). Row i is always the same point. Weights w = r_e / (0.85 r + 0.15 r_e) - 1 for r < r_e.
/// The right-hand side is that of the hydrostatic pressure plus noise, of which 80 % stays from one step to the next.
class MovingTank
{
public:
    MovingTank(int dimensions, int rows, Real radius, Real jitter = 0.2, std::uint32_t seed = 1)
        : dimensions_(dimensions),
          radius_(radius),
          random_(seed)
    {
        Real const target = static_cast<Real>(rows);
        width_ = std::max(2, static_cast<int>(std::lround(dimensions == 2 ? std::sqrt(target) : std::cbrt(target))));
        int const depth = dimensions == 3 ? width_ : 1;
        for (int i = 0; i < width_; ++i)
        {
            for (int k = 0; k < depth; ++k)
            {
                for (int j = 0; j <= width_; ++j)
                {
                    Vector x(i + 0.5 + uniform(jitter), j + 0.5 + uniform(jitter), dimensions == 3 ? k + 0.5 + uniform(jitter) : 0);
                    points_.push_back(x);
                    unknown_.push_back(j < width_ ? rows_++ : -1);
                }
            }
        }
    }

    [[nodiscard]] int rows() const { return rows_; }

    /// Moves all points by a swirl of at most `distance` spacings and a random share of a tenth of it.
    void advance(Real distance)
    {
        Real const pi = std::numbers::pi;
        for (Vector& x : points_)
        {
            Vector const s = x / width_;
            Vector u(std::sin(pi * s.x()) * std::cos(pi * s.y()), -std::cos(pi * s.x()) * std::sin(pi * s.y()), 0);
            if (dimensions_ == 3) u.z() = 0.3 * std::sin(pi * s.z()) * std::cos(pi * s.x());
            for (int d = 0; d < dimensions_; ++d) x[d] += distance * u[d] + uniform(0.1 * distance);
        }
    }

    /// Matrix and right-hand side at the present positions. @param pinned false: the top layer is left out altogether (pure Neumann).
    void assemble(SparseMatrix& a, std::vector<Real>& b, Real noise = 0.1, bool pinned = true)
    {
        sortIntoCells();
        a.rows = rows_;
        a.rowStart.assign(1, 0);
        a.column.clear();
        a.value.clear();
        b.assign(static_cast<std::size_t>(rows_), 0);
        for (std::size_t i = 0; i < points_.size(); ++i)
        {
            if (unknown_[i] >= 0) addRow(i, a, b, pinned);
        }
        addNoise(b, noise);
    }

private:
    Real uniform(Real amplitude) { return amplitude * (2 * (static_cast<Real>(random_()) / 4294967296.0) - 1); }

    Real normal()
    {
        Real sum = 0;
        for (int k = 0; k < 12; ++k) sum += uniform(0.5);
        return sum;
    }

    [[nodiscard]] std::size_t cellOf(Vector const& x, int dx, int dy, int dz) const
    {
        int const side = cells_;
        auto const clip = [side](Real s, int shift) { return std::clamp(static_cast<int>(s) + shift, 0, side - 1); };
        int const cx = clip(x.x() / radius_ + 1, dx);
        int const cy = clip(x.y() / radius_ + 1, dy);
        int const cz = dimensions_ == 3 ? clip(x.z() / radius_ + 1, dz) : 0;
        return (static_cast<std::size_t>(cx) * static_cast<std::size_t>(dimensions_ == 3 ? side : 1) + static_cast<std::size_t>(cz)) *
                   static_cast<std::size_t>(side) +
               static_cast<std::size_t>(cy);
    }

    void sortIntoCells()
    {
        cells_ = static_cast<int>((width_ + 2) / radius_) + 4;
        auto const side = static_cast<std::size_t>(cells_);
        head_.assign(side * side * (dimensions_ == 3 ? side : 1) + 1, 0);
        for (Vector const& x : points_) ++head_[cellOf(x, 0, 0, 0) + 1];
        for (std::size_t c = 1; c < head_.size(); ++c) head_[c] += head_[c - 1];
        member_.resize(points_.size());
        std::vector<int> next = head_;
        for (std::size_t i = 0; i < points_.size(); ++i) member_[next[cellOf(points_[i], 0, 0, 0)]++] = static_cast<int>(i);
    }

    void addRow(std::size_t i, SparseMatrix& a, std::vector<Real>& b, bool pinned)
    {
        Vector const& x = points_[i];
        Real const top = width_ + 0.5;
        Real diagonal = 0;
        row_.clear();
        for (int dx = -1; dx <= 1; ++dx)
        {
            for (int dz = dimensions_ == 3 ? -1 : 0; dz <= (dimensions_ == 3 ? 1 : 0); ++dz)
            {
                for (int dy = -1; dy <= 1; ++dy)
                {
                    std::size_t const cell = cellOf(x, dx, dy, dz);
                    for (int m = head_[cell]; m < head_[cell + 1]; ++m)
                    {
                        auto const j = static_cast<std::size_t>(member_[m]);
                        Real const r = (points_[j] - x).norm();
                        if (j == i || r >= radius_ || (!pinned && unknown_[j] < 0)) continue;
                        Real const w = radius_ / (0.85 * r + 0.15 * radius_) - 1;
                        diagonal += w;
                        Real const pj = unknown_[j] >= 0 ? top - points_[j].y() : 0;
                        b[unknown_[i]] += w * (top - x.y() - pj);
                        if (unknown_[j] >= 0) row_.emplace_back(unknown_[j], -w);
                    }
                }
            }
        }
        row_.emplace_back(unknown_[i], diagonal);
        std::sort(row_.begin(), row_.end());
        for (auto const& [column, value] : row_)
        {
            a.column.push_back(column);
            a.value.push_back(value);
        }
        a.rowStart.push_back(static_cast<int>(a.value.size()));
    }

    void addNoise(std::vector<Real>& b, Real amplitude)
    {
        if (noise_.size() != b.size())
        {
            noise_.resize(b.size());
            for (Real& v : noise_) v = normal();
        }
        else
        {
            for (Real& v : noise_) v = 0.8 * v + 0.6 * normal();
        }
        Real const rms = norm(b) / std::sqrt(static_cast<Real>(b.size()));
        for (std::size_t i = 0; i < b.size(); ++i) b[i] += amplitude * rms * noise_[i];
    }

    int dimensions_;
    Real radius_;
    std::mt19937 random_;
    int width_ = 0;
    int rows_ = 0;
    int cells_ = 0;
    std::vector<Vector> points_;
    std::vector<int> unknown_; // row, or -1 for the top layer
    std::vector<Real> noise_;
    std::vector<int> head_;
    std::vector<int> member_;
    std::vector<std::pair<int, Real>> row_;
};

} // namespace mpsDem::test
