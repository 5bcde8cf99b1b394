#pragma once

#include <optional>

#include "core/Dictionary.h"
#include "postGauges/SheetLayout.h"

namespace mpsDem::postGauges {

/// Keys of `camera { }`:
///
/// | key | meaning | unit | default | range |
/// |---|---|---|---|---|
/// | azimuth | turn about the vertical; 0 looks along -z, 90 along -x | deg | 25 | -360 to 360 |
/// | elevation | above the horizon | deg | 22 | -90 to 90 |
/// | projection | perspective or orthographic | - | perspective | |
/// | fieldOfView | of perspective: larger is nearer | deg | 24 | 1 to 120 |
/// | zoom | above 1: closer | - | 1 | 0.01 to 100 |
/// | focus | point in the middle of the picture | m | middle of the scene | |
struct CameraControls
{
    Real azimuth = 25;
    Real elevation = 22;
    bool perspective = true;
    Real fieldOfView = 24;
    Real zoom = 1;
    std::optional<Vector> focus;

    static CameraControls read(Dictionary const& dict);
};

/// Box with edges along the axes.
struct SpaceBox
{
    Vector low;  ///< [m]
    Vector high; ///< [m]

    /// Corner 0 to 7: bit d set where it is the high one in direction d.
    [[nodiscard]] Vector corner(int i) const;
};

/// Maps space to the picture plane, that through the focus.
class Camera
{
public:
    /// A point of the picture.
    struct Point
    {
        Real u = 0, v = 0; ///< In the picture plane, right and up [m].
        Real nearness = 0; ///< The larger, the nearer; linear along any straight line of the picture.
    };

    /// @param up  Unit vector that stands upright in the picture. @param box  What must be in view.
    Camera(CameraControls const& controls, Vector const& up, SpaceBox const& box);

    [[nodiscard]] Point project(Vector const& r) const;
    /// Place in the camera's own axes (right, upward, backward) from the focus [m].
    [[nodiscard]] Vector place(Real u, Real v, Real nearness) const;
    /// Distance from the camera (orthographic: from the focus plane) along its axis [m].
    [[nodiscard]] Real depth(Real nearness) const { return perspective_ ? 1 / nearness : -nearness; }
    [[nodiscard]] Real nearness(Real depth) const { return perspective_ ? 1 / depth : -depth; }
    /// Length in the picture of one metre across the axis at this nearness.
    [[nodiscard]] Real magnification(Real nearness) const { return perspective_ ? distance_ * nearness : 1; }
    /// Unit vector from a point to the camera.
    [[nodiscard]] Vector toViewer(Vector const& r) const;

    [[nodiscard]] Vector const& right() const { return right_; }
    [[nodiscard]] Vector const& upward() const { return upward_; }
    /// Unit vector from the focus to the camera.
    [[nodiscard]] Vector const& backward() const { return backward_; }
    /// Part of the picture plane that holds the box.
    [[nodiscard]] Window const& window() const { return window_; }

private:
    bool perspective_;
    Vector right_, upward_, backward_, focus_;
    Real distance_ = 0; ///< Camera to focus [m].
    Window window_;
};

} // namespace mpsDem::postGauges
