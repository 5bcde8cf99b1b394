#pragma once

#include <optional>
#include <string>

#include "postGauges/Particles.h"
#include "postGauges/SheetLayout.h"

namespace mpsDem::postGauges {

/// A plate of space seen face-on, from the side to which its normal points: what flat pictures show of particles. In 2-D all there is.
///
/// `slice (low high);` [m] along z, or `slice { normal (0 0 1); point (0 0 0); thickness 0.04; }`:
///
/// | key | meaning | unit | default in 3-D |
/// |---|---|---|---|
/// | normal | towards the viewer | - | (0 0 1) |
/// | point | in its middle | m | middle of all particles at the first time |
/// | thickness | | m | 2 spacings |
class Slice
{
public:
    /// The x-y plane without limits.
    Slice() = default;
    /// @throw CaseError (BadInput)
    static Slice read(Dictionary const& dict);

    /// Fills in what was not given.
    [[nodiscard]] Slice completed(PostCase const& postCase, ParticleFrame const& frame) const;

    [[nodiscard]] bool holds(Vector const& r) const { return !limited_ || std::abs(depth(r)) <= 0.5 * *thickness_; }
    /// Right, up and towards the viewer [m].
    [[nodiscard]] Vector place(Vector const& r) const { return {r.dot(right_), r.dot(upward_), r.dot(normal_)}; }
    /// Numbers of the particles it holds; in 3-D those far from the viewer first.
    [[nodiscard]] std::vector<std::size_t> particles(ParticleFrame const& frame) const;
    /// Outlines of a body in the picture: cut by the plane in the middle.
    [[nodiscard]] std::vector<std::vector<Vector>> outlines(std::vector<std::vector<Vector>> const& polygons) const;
    /// "x [m]" where the axis is one of space.
    [[nodiscard]] std::string xLabel() const { return label(right_); }
    [[nodiscard]] std::string yLabel() const { return label(upward_); }

    /// gnuplot's tics for axes that run against one of space: numbers are those of space.
    [[nodiscard]] std::string tics(Window const& window) const;

private:
    [[nodiscard]] Real depth(Vector const& r) const { return (r - *point_).dot(normal_); }
    [[nodiscard]] static std::string label(Vector const& axis);

    bool limited_ = false;
    Vector normal_ = Vector::UnitZ(), right_ = Vector::UnitX(), upward_ = Vector::UnitY();
    std::optional<Vector> point_;
    std::optional<Real> thickness_; ///< [m]
};

} // namespace mpsDem::postGauges
