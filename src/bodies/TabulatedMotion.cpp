#include "bodies/TabulatedMotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/Entries.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

using Row = TabulatedMotion::Row;

/// The vectors of a list, one a time; zeros where the keyword is absent.
std::vector<Vector> readColumn(Dictionary const& dict, std::string const& key, std::size_t count)
{
    if (!dict.found(key)) return std::vector<Vector>(count, Vector::Zero());
    auto column = dict.get<std::vector<Vector>>(key);
    bool const finite = std::all_of(column.begin(), column.end(), [](Vector const& v) { return v.allFinite(); });
    require(column.size() == count && finite, dict.where(key),
            key + " has " + std::to_string(column.size()) + " values for " + std::to_string(count) + " times", "one finite (x y z) a time");
    return column;
}

std::vector<Row> readTable(Dictionary const& dict)
{
    auto const times = dict.get<std::vector<Real>>("times");
    bool rising = times.size() >= 2 && std::isfinite(times.front()) && std::isfinite(times.back());
    for (std::size_t i = 1; i < times.size(); ++i) rising = rising && times[i] > times[i - 1];
    require(rising, dict.where("times"), "times of the table do not rise, or are less than two", "two times or more, each above the last");
    require(dict.found("translations") || dict.found("rotations"), dict.where(),
            "tabulated6DoFMotion has neither translations nor rotations", "one of them or both, a list of (x y z) as long as times");
    std::vector<Vector> const translations = readColumn(dict, "translations", times.size());
    std::vector<Vector> const rotations = readColumn(dict, "rotations", times.size());

    Real constexpr degree = std::numbers::pi / 180;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < times.size(); ++i) rows.push_back({times[i], translations[i], degree * rotations[i]});
    return rows;
}

TabulatedMotion::Interpolation readInterpolation(Dictionary const& dict)
{
    std::string const word = dict.getWordOr("interpolationScheme", "spline", {"linear", "spline"}, "interpolation schemes");
    return word == "linear" ? TabulatedMotion::Interpolation::Linear : TabulatedMotion::Interpolation::Spline;
}

std::optional<Vector> readCentre(Dictionary const& dict)
{
    if (!dict.found("CofG")) return {};
    return readVector(dict, "CofG");
}

Row combination(Real p, Row const& a, Real q, Row const& b)
{
    return {p * a.time + q * b.time, p * a.displacement + q * b.displacement, p * a.angles + q * b.angles};
}

Quaternion about(int axis, Real angle) { return Quaternion(Eigen::AngleAxisd(angle, Vector::Unit(axis))); }

} // namespace

TabulatedMotion::TabulatedMotion(Dictionary const& dict) : TabulatedMotion(readTable(dict), readInterpolation(dict), readCentre(dict)) {}

TabulatedMotion::TabulatedMotion(std::vector<Row> rows, Interpolation interpolation, std::optional<Vector> centre)
    : rows_(std::move(rows)),
      interpolation_(interpolation),
      centreOfRotation_(centre)
{
    expect(rows_.size() >= 2, "a table of motion has two rows or more");
    if (interpolation_ == Interpolation::Spline) findSlopes();
}

/// Slope at a row of the parabola through it and its neighbours (at an end: through the three rows nearest to it).
void TabulatedMotion::findSlopes()
{
    std::size_t const count = rows_.size();
    auto const chord = [&](std::size_t i) {
        Real const inverse = 1 / (rows_[i + 1].time - rows_[i].time);
        return combination(inverse, rows_[i + 1], -inverse, rows_[i]);
    };
    slopes_.assign(count, chord(0));
    if (count == 2) return;
    for (std::size_t i = 1; i + 1 < count; ++i)
    {
        Real const before = rows_[i].time - rows_[i - 1].time;
        Real const after = rows_[i + 1].time - rows_[i].time;
        slopes_[i] = combination(after / (before + after), chord(i - 1), before / (before + after), chord(i));
    }
    slopes_.front() = combination(2, chord(0), -1, slopes_[1]);
    slopes_.back() = combination(2, chord(count - 2), -1, slopes_[count - 2]);
}

bool TabulatedMotion::leavesPlane() const
{
    return std::any_of(rows_.begin(), rows_.end(),
                       [](Row const& row) { return row.displacement.z() != 0 || row.angles.x() != 0 || row.angles.y() != 0; });
}

TabulatedMotion::Sample TabulatedMotion::sample(Real t) const
{
    if (t < rows_.front().time) return {rows_.front(), {}};
    if (t > rows_.back().time) return {rows_.back(), {}};
    auto const above = std::upper_bound(rows_.begin(), rows_.end(), t, [](Real value, Row const& row) { return value < row.time; });
    std::size_t const last = rows_.size() - 2;
    std::size_t const i = std::min(last, static_cast<std::size_t>(above - rows_.begin()) - 1);

    Row const& a = rows_[i];
    Row const& b = rows_[i + 1];
    Real const length = b.time - a.time;
    Real const s = (t - a.time) / length;
    Row const chord = combination(1 / length, b, -1 / length, a);
    if (interpolation_ == Interpolation::Linear) return {combination(1 - s, a, s, b), chord};

    // Cubic Hermite: straight line plus what the slopes differ from it.
    Row const atStart = combination(1, slopes_[i], -1, chord);
    Row const atEnd = combination(1, slopes_[i + 1], -1, chord);
    Row const bend = combination(length * s * (1 - s) * (1 - s), atStart, -length * s * s * (1 - s), atEnd);
    Row const bendRate = combination((1 - s) * (1 - 3 * s), atStart, s * (3 * s - 2), atEnd);
    return {combination(1, combination(1 - s, a, s, b), 1, bend), combination(1, chord, 1, bendRate)};
}

RigidMotion TabulatedMotion::at(Real t, Vector const& centre, Quaternion const& orientation) const
{
    Sample const now = sample(t);
    Vector const& angles = now.value.angles;
    Quaternion const aboutX = about(0, angles.x());
    Quaternion const aboutXY = aboutX * about(1, angles.y());
    Quaternion const turn = aboutXY * about(2, angles.z());
    Vector const& rate = now.rate.angles;
    Vector const angularVelocity =
        rate.x() * Vector::UnitX() + rate.y() * (aboutX * Vector::UnitY()) + rate.z() * (aboutXY * Vector::UnitZ());

    Vector const pivot = centreOfRotation_.value_or(centre);
    Vector const arm = turn * (centre - pivot);
    return {pivot + now.value.displacement + arm, turn * orientation, now.rate.displacement + angularVelocity.cross(arm), angularVelocity};
}

} // namespace mpsDem
