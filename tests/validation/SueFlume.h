#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/Dictionary.h"
#include "support/Curve.h"

namespace mpsDem::test {

/// Way of the trailing edge along x since the release [m], run SG5 or SG1: cubic B-spline whose control points are the measured ways less
/// a sixth of their second difference, so that the acceleration is continuous, as in Allrun-prescribed of the case. Then the last speed.
class MeasuredWay
{
public:
    explicit MeasuredWay(std::string const& run)
    {
        Curve const table = reference("slideSue2006_" + run + ".dat", "t", "way"); // rows at even times
        for (auto const& [time, way] : table.points()) way_.push_back(way);
        step_ = table.points().at(1).first;
    }

    [[nodiscard]] Real operator()(Real t) const { return t <= 0 ? 0 : spline(t) - spline(0); }

private:
    /// Beyond the ends mirrored and on a straight line.
    [[nodiscard]] Real row(int k) const
    {
        int const n = static_cast<int>(way_.size()) - 1;
        if (k < 0) return at(-k);
        return k <= n ? at(k) : at(n) + (k - n) * (at(n) - at(n - 1));
    }
    [[nodiscard]] Real at(int k) const { return way_.at(static_cast<std::size_t>(k)); }
    [[nodiscard]] Real control(int k) const { return row(k) - (row(k - 1) - 2 * row(k) + row(k + 1)) / 6; }

    [[nodiscard]] Real spline(Real t) const
    {
        int const k = static_cast<int>(t / step_ + 1e-9);
        Real const s = t / step_ - k, r = 1 - s, s2 = s * s, s3 = s2 * s;
        return (r * r * r * control(k - 1) + (4 - 6 * s2 + 3 * s3) * control(k) + (1 + 3 * s + 3 * s2 - 3 * s3) * control(k + 1) +
                s3 * control(k + 2)) /
               6;
    }

    std::vector<Real> way_; ///< [m].
    Real step_ = 0;         ///< [s].
};

/// What is in the gap that the bend leaves below the middle of the block: nothing that moves (the block displaces the water of the gap,
/// too), or water (it displaces its own volume only).
enum class Gap
{
    displaced,
    filled
};

/// Bed of the flume of Sue, Nokes and Walters (2006) with the block on it, measures from constant/geometry of sueEllipse2D in
/// tutorials/landslide; x = 0 is the still-water shoreline, z = 0 the water at rest. Leading and trailing edge of the block are on the bed,
/// the trailing one goes as measured.
///
/// Departures: the slope is cut off 0.04 m below the water at rest, so that there is water at x = 0 and over the block; the profile of the
/// block is its mean over 0.02 m of the chord, as the ends of an ellipse are upright; the cubic of the bend goes on until it meets the
/// floor, which it would reach with a step of 0.2 mm otherwise.
class SueFlume
{
public:
    /// @param scale  Factor of the block's height.
    SueFlume(std::string const& run, Gap gap, Real scale = 1) : way_(run), gap_(gap)
    {
        namespace fs = std::filesystem;
        fs::path const tutorial = fs::path(MPSDEM_TEST_DATA).parent_path() / "tutorials" / "landslide" / "sueEllipse2D";
        Dictionary const geometry = Dictionary::fromFile(tutorial / "constant" / "geometry", tutorial);
        Dictionary const flume = geometry.subDict("flume"), block = geometry.subDict("block");
        depth_ = flume.get<Real>("depth");
        slope_ = std::tan(flume.get<Real>("slope"));
        bendStart_ = flume.get<Real>("bendStart");
        a_ = flume.get<Real>("a");
        b_ = flume.get<Real>("b");
        c_ = flume.get<Real>("c");
        d_ = flume.get<Real>("d");
        lowest_ = (std::sqrt(b_ * b_ - 3 * a_ * c_) - b_) / (3 * a_);
        halfLength_ = block.get<Real>("halfLength");
        start_ = block.get<Real>("edgeX");
        height_ = scale * 2 * block.get<Real>("volume") / (block.get<Real>("width") * halfLength_ * std::numbers::pi);
    }

    /// Bed with block [m]: PotentialFlow::Bed.
    [[nodiscard]] Eigen::ArrayXd operator()(Eigen::ArrayXd const& x, Real t) const
    {
        Block const block = blockAt(t);
        return x.unaryExpr([&](Real place) { return std::min(std::min(bed(place), -shelf) + rise(place, block), 0.0); });
    }

private:
    static constexpr Real shelf = 0.04, rounding = 0.02; ///< Cut-off of the slope and length of the mean over the ends [m].

    struct Block
    {
        Real x = 0, z = 0;            ///< Middle of the chord between the edges [m].
        Real cosine = 0, tangent = 0; ///< Of the chord's angle below the horizontal.
    };

    /// Without block [m].
    [[nodiscard]] Real bed(Real x) const
    {
        Real const s = x - bendStart_;
        if (s <= 0) return -x * slope_;
        return s >= lowest_ ? -depth_ : std::max(-depth_, ((a_ * s + b_) * s + c_) * s + d_);
    }

    [[nodiscard]] Block blockAt(Real t) const
    {
        Real const x = start_ + way_(t);
        Real low = x, high = x + 2 * halfLength_; // the leading edge is between them
        for (int k = 0; k < 50; ++k)
        {
            Real const middle = 0.5 * (low + high);
            (std::hypot(middle - x, bed(middle) - bed(x)) < 2 * halfLength_ ? low : high) = middle;
        }
        return {0.5 * (x + low), 0.5 * (bed(x) + bed(low)), (low - x) / (2 * halfLength_), (bed(x) - bed(low)) / (low - x)};
    }

    /// Of the half ellipse from its middle to this place on the chord [m2].
    [[nodiscard]] Real area(Real along) const
    {
        Real const s = std::clamp(along / halfLength_, -1.0, 1.0);
        return 0.5 * height_ * halfLength_ * (s * std::sqrt(1 - s * s) + std::asin(s));
    }

    /// At right angles to the chord [m].
    [[nodiscard]] Real thickness(Real along) const { return (area(along + 0.5 * rounding) - area(along - 0.5 * rounding)) / rounding; }

    /// By which the block raises the bed [m].
    [[nodiscard]] Real rise(Real x, Block const& block) const
    {
        Real const fromMiddle = (x - block.x) / block.cosine;
        if (std::abs(fromMiddle) > halfLength_ + rounding) return 0;
        Real along = fromMiddle; // of the point of the upper side at x: the chord's normal leans towards +x
        for (int k = 0; k < 40; ++k) along = fromMiddle - block.tangent * thickness(along);
        Real const overChord = thickness(along) / block.cosine;
        if (gap_ == Gap::filled) return overChord;
        return std::max(0.0, block.z - block.tangent * (x - block.x) + overChord - bed(x));
    }

    MeasuredWay way_;
    Gap gap_;
    Real depth_ = 0, slope_ = 0, bendStart_ = 0, a_ = 0, b_ = 0, c_ = 0,
         d_ = 0;                                   ///< Of the flume as in constant/geometry; the slope is a tangent.
    Real lowest_ = 0;                              ///< Lowest point of the bend's cubic from its start [m].
    Real halfLength_ = 0, start_ = 0, height_ = 0; ///< Of the block; trailing edge at the release [m].
};

/// First crest and trough at a gauge.
struct FirstWave
{
    Real crest = 0, crestTime = 0, trough = 0, troughTime = 0; ///< [m], [s].
};

/// As `extremes` in system/measures of the case: the first trough is the lowest level that nothing within 0.25 s after it undercuts and
/// that is half as deep at least as the deepest; the crest is before it. @param elevation  Over time [m], [s].
inline FirstWave firstWave(Curve const& elevation)
{
    auto const& points = elevation.points();
    auto const lower = [](auto const& a, auto const& b) { return a.second < b.second; };
    Real const deepest = std::min_element(points.begin(), points.end(), lower)->second;
    auto const isTrough = [&](std::pair<Real, Real> const& point) {
        auto const undercuts = [&](auto const& other) {
            return other.first > point.first && other.first <= point.first + 0.25 && other.second < point.second;
        };
        return point.second < 0.5 * deepest && std::none_of(points.begin(), points.end(), undercuts);
    };
    auto const trough = std::find_if(points.begin(), points.end(), isTrough);
    auto const crest = std::max_element(points.begin(), trough, lower);
    return {crest->second, crest->first, trough->second, trough->first};
}

} // namespace mpsDem::test
