#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/Types.h"

namespace mpsDem::test {

/// Zero crossings upwards and the peaks between crossings of a signal.
class Oscillation
{
public:
    void add(Real time, Real value)
    {
        if (begun_ && last_ < 0 && value >= 0) crossings_.push_back(lastTime_ - last_ * (time - lastTime_) / (value - last_));
        if (begun_ && (last_ < 0) != (value < 0))
        {
            if (largest_ > 0) peaks_.push_back(largest_);
            largest_ = 0;
        }
        largest_ = std::max(largest_, std::abs(value));
        begun_ = true;
        last_ = value;
        lastTime_ = time;
    }
    /// Mean time from one crossing upwards to the next; 0 for fewer than two.
    [[nodiscard]] Real period() const
    {
        return crossings_.size() < 2 ? 0 : (crossings_.back() - crossings_.front()) / static_cast<Real>(crossings_.size() - 1);
    }
    [[nodiscard]] std::vector<Real> const& crossings() const { return crossings_; }
    /// Largest |value| of each half oscillation that is complete.
    [[nodiscard]] std::vector<Real> const& peaks() const { return peaks_; }

private:
    bool begun_ = false;
    Real last_ = 0, lastTime_ = 0, largest_ = 0;
    std::vector<Real> crossings_, peaks_;
};

} // namespace mpsDem::test
