#include "fluid/VelocitySystem.h"

#include <algorithm>
#include <limits>

namespace mpsDem {

void VelocitySystem::begin(int rows)
{
    rowStart_.assign(1, 0);
    column_.clear();
    value_.clear();
    entries_.clear();
    right_.resize(rows, 3);
    x_.resize(rows, 3);
    for (auto* const work : {&inverseDiagonal_, &residual_, &direction_, &image_, &scaled_}) work->resize(rows);
}

void VelocitySystem::endRow(Real diagonal, Vector const& right, Vector const& guess)
{
    int const row = static_cast<int>(rowStart_.size()) - 1;
    entries_.emplace_back(row, diagonal);
    std::sort(entries_.begin(), entries_.end());
    for (auto const& [column, value] : entries_)
    {
        column_.push_back(column);
        value_.push_back(value);
    }
    entries_.clear();
    rowStart_.push_back(static_cast<int>(column_.size()));
    inverseDiagonal_[row] = 1 / diagonal;
    right_.row(row) = right.transpose();
    x_.row(row) = guess.transpose();
}

void VelocitySystem::multiply(Eigen::Ref<Eigen::VectorXd const> const& v)
{
    for (int i = 0; i < static_cast<int>(image_.size()); ++i)
    {
        Real sum = 0;
        for (int k = rowStart_[i]; k < rowStart_[i + 1]; ++k) sum += value_[k] * v[column_[k]];
        image_[i] = sum;
    }
}

void VelocitySystem::solve(Real tolerance)
{
    for (int component = 0; component < 3; ++component) solveComponent(component, tolerance);
}

void VelocitySystem::solveComponent(int component, Real tolerance)
{
    auto const b = right_.col(component);
    auto x = x_.col(component);
    Real const square = b.squaredNorm();
    if (square == 0)
    {
        x.setZero();
        return;
    }
    multiply(x);
    residual_ = b - image_;
    Real const goal = std::max(tolerance * tolerance * square, std::numeric_limits<Real>::min());
    if (residual_.squaredNorm() < goal) return;
    direction_ = inverseDiagonal_.cwiseProduct(residual_);
    Real rho = residual_.dot(direction_);
    for (Eigen::Index iteration = 0; iteration < 2 * b.size(); ++iteration)
    {
        multiply(direction_);
        Real const alpha = rho / direction_.dot(image_);
        x += alpha * direction_;
        residual_ -= alpha * image_;
        if (residual_.squaredNorm() < goal) return;
        scaled_ = inverseDiagonal_.cwiseProduct(residual_);
        Real const next = residual_.dot(scaled_);
        direction_ = scaled_ + next / rho * direction_;
        rho = next;
    }
}

} // namespace mpsDem
