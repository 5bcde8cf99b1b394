#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

#include "support/Curve.h"
#include "support/RunCase.h"

namespace mpsDem::test {

/// One coordinate of a body's centre over time [s], [m], as it was measured.
class MeasuredPath
{
public:
    /// @param points  Times rise.
    MeasuredPath(std::initializer_list<std::pair<Real, Real>> points)
    {
        for (auto const& [time, value] : points) curve_.add(time, value);
    }

    /// From the lowest to the highest value [m].
    [[nodiscard]] Real travel() const
    {
        auto const below = [](auto const& a, auto const& b) { return a.second < b.second; };
        auto const [low, high] = std::minmax_element(curve_.points().begin(), curve_.points().end(), below);
        return high->second - low->second;
    }

    /// Computed less measured value, as part of the travel: of all measured points the one that is largest in magnitude.
    /// @param late  By so much the clock of the measurement started before that of the computation [s].
    [[nodiscard]] Real difference(Curve const& computed, Real late = 0) const
    {
        Real worst = 0;
        for (auto const& [time, value] : curve_.points())
        {
            Real const part = (computed.at(time - late) - value) / travel();
            if (std::abs(part) > std::abs(worst)) worst = part;
        }
        return worst;
    }

    /// The start of the clock, in steps of 1 ms up to `most` on either side, that makes the largest difference smallest [s].
    [[nodiscard]] Real lateness(Curve const& computed, Real most = 0.1) const
    {
        Real best = 0;
        int const steps = static_cast<int>(std::lround(most * 1000));
        for (int k = -steps; k <= steps; ++k)
            if (std::abs(difference(computed, 0.001 * k)) < std::abs(difference(computed, best))) best = 0.001 * k;
        return best;
    }

    [[nodiscard]] Real end() const { return curve_.points().back().first; }

private:
    Curve curve_;
};

/// mpsDemFoam to the end. @param axis  0 for x, 1 for y. @returns This coordinate of the centre of the first body, a value a step.
inline Curve pathOfBody(RunCase& run, int axis)
{
    Curve path;
    path.add(0, run.start().bodies()[0]->centre()[axis]);
    run.run([&](Scene const& scene, Step const& step) { path.add(step.time, scene.bodies()[0]->centre()[axis]); });
    return path;
}

} // namespace mpsDem::test
