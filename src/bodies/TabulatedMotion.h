#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bodies/PrescribedMotion.h"

namespace mpsDem {

/// Motion through given displacements and angles (tabulated6DoFMotion; keys in PrescribedMotion.h).
/// OpenFOAM reads its table from timeDataFileName; here it stands in the dictionary, column by column.
///
/// Displacement and angles are interpolated component by component: straight lines, or cubic Hermite pieces whose slope at a
/// time is that of the parabola through it and its neighbours. Angles turn about x, then the turned y, then the turned z.
/// Before the first and after the last time the body rests in the first and last pose.
class TabulatedMotion : public PrescribedMotion
{
public:
    /// One line of the table.
    struct Row
    {
        Real time = 0;                        ///< [s].
        Vector displacement = Vector::Zero(); ///< [m].
        Vector angles = Vector::Zero();       ///< [rad].
    };

    enum class Interpolation
    {
        Linear,
        Spline
    };

    explicit TabulatedMotion(Dictionary const& dict);

    /// @param rows     Times must rise.
    /// @param centre   Point about which the angles turn; without it, the centre of mass.
    TabulatedMotion(std::vector<Row> rows, Interpolation interpolation, std::optional<Vector> centre = {});

    [[nodiscard]] RigidMotion at(Real t, Vector const& centre, Quaternion const& orientation) const override;
    [[nodiscard]] bool leavesPlane() const override;

private:
    struct Sample
    {
        Row value;
        Row rate; ///< Its time is not used.
    };

    void findSlopes();
    [[nodiscard]] Sample sample(Real t) const;

    std::vector<Row> rows_;
    std::vector<Row> slopes_; ///< Rates at the rows; empty for straight lines.
    Interpolation interpolation_;
    std::optional<Vector> centreOfRotation_;
};

} // namespace mpsDem
