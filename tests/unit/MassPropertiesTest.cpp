#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bodies/MassProperties.h"
#include "core/Errors.h"

namespace mpsDem {
namespace {

/// Right isosceles wedge of the landslide experiments: legs 0.5 m along x and y, 0.55 m wide.
MassProperties wedge(Vector const& corner, std::vector<int> const& order, Tensor const& rotation = Tensor::Identity())
{
    std::vector<Vector> const points = {Vector(0, 0, 0), Vector(0.5, 0, 0), Vector(0, 0.5, 0)};
    std::vector<Vector> moved;
    for (int i : order) moved.push_back(corner + rotation * points[static_cast<std::size_t>(i)]);
    return MassProperties::fromPolygon(Polyline::outline("wedge", moved), 0.55, 1000).withMass(140);
}

TEST(MassProperties, RightWedgeAgreesWithClosedForms)
{
    MassProperties const body = wedge(Vector::Zero(), {0, 1, 2});
    Real const m = 140, a = 0.5, t = 0.55;
    EXPECT_DOUBLE_EQ(body.mass, m);
    EXPECT_NEAR(body.volume, a * a / 2 * t, 1e-15);
    EXPECT_NEAR((body.centreOfMass - Vector(a / 3, a / 3, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR(body.inertia(2, 2), m * (a * a + a * a) / 18, 1e-13); // 3.8889 kg m2
    EXPECT_NEAR(body.inertia(0, 0), m * (a * a / 18 + t * t / 12), 1e-13);
    EXPECT_NEAR(body.inertia(1, 1), m * (a * a / 18 + t * t / 12), 1e-13);
    EXPECT_NEAR(body.inertia(0, 1), m * a * a / 36, 1e-13); // minus the product of inertia, which is -m a b / 36
    EXPECT_EQ(body.inertia(0, 2), 0);
    EXPECT_EQ(body.inertia(1, 2), 0);
    EXPECT_EQ(body.inertia(0, 1), body.inertia(1, 0));
}

TEST(MassProperties, PrincipalMomentsOfTheWedgeLieAlongItsDiagonals)
{
    // Along the hypotenuse 1/sqrt(2) (1, -1, 0): m a^2/18 - m a^2/36 + m t^2/12; across it m a^2/18 + m a^2/36 + m t^2/12.
    MassProperties const body = wedge(Vector::Zero(), {0, 1, 2});
    Vector const along = Vector(1, -1, 0).normalized(), across = Vector(1, 1, 0).normalized();
    EXPECT_NEAR(along.dot(body.inertia * along), 140 * (0.25 / 36 + 0.3025 / 12), 1e-12);
    EXPECT_NEAR(across.dot(body.inertia * across), 140 * (0.25 / 12 + 0.3025 / 12), 1e-12);
}

TEST(MassProperties, OrderOfPointsAndDistanceFromTheOriginDoNotMatter)
{
    MassProperties const near = wedge(Vector::Zero(), {0, 1, 2});
    MassProperties const clockwise = wedge(Vector::Zero(), {2, 1, 0});
    MassProperties const far = wedge(Vector(1e4, -2e4, 0), {1, 2, 0});
    EXPECT_NEAR((clockwise.inertia - near.inertia).norm(), 0, 1e-13);
    EXPECT_NEAR((clockwise.centreOfMass - near.centreOfMass).norm(), 0, 1e-15);
    EXPECT_NEAR((far.inertia - near.inertia).norm(), 0, 1e-9); // the points themselves carry round-off of 4e-12 m
    EXPECT_NEAR((far.centreOfMass - near.centreOfMass - Vector(1e4, -2e4, 0)).norm(), 0, 1e-11);
}

TEST(MassProperties, TurnedShapeHasTurnedInertia)
{
    Tensor const rotation = Eigen::AngleAxisd(0.7, Vector::UnitZ()).toRotationMatrix();
    MassProperties const straight = wedge(Vector::Zero(), {0, 1, 2});
    MassProperties const turned = wedge(Vector::Zero(), {0, 1, 2}, rotation);
    EXPECT_NEAR((turned.inertia - rotation * straight.inertia * rotation.transpose()).norm(), 0, 1e-13);
}

TEST(MassProperties, ConcaveOutlineIsTheSumOfItsRectangles)
{
    // L: 2 x 1 below, 1 x 1 on its left end; centroid (5/6, 5/6).
    std::vector<Vector> const points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    MassProperties const body = MassProperties::fromPolygon(Polyline::outline("L", points), 1, 10);
    EXPECT_NEAR(body.mass, 30, 1e-12);
    EXPECT_NEAR((body.centreOfMass - Vector(5.0 / 6, 5.0 / 6, 0)).norm(), 0, 1e-14);
    Real const below = 20 * (1.0 / 12 + std::pow(0.5 - 5.0 / 6, 2)), above = 10 * (1.0 / 12 + std::pow(1.5 - 5.0 / 6, 2));
    EXPECT_NEAR(body.inertia(0, 0), below + above + 30.0 / 12, 1e-12);
}

TEST(MassProperties, Disc)
{
    MassProperties const disc = MassProperties::fromCylinder2D(Vector(1, 2, 0), 0.2, 0.5, 2000);
    Real const m = 2000 * std::numbers::pi * 0.04 * 0.5;
    EXPECT_NEAR(disc.mass, m, 1e-12);
    EXPECT_NEAR(disc.inertia(2, 2), m * 0.04 / 2, 1e-13);
    EXPECT_NEAR(disc.inertia(0, 0), m * (3 * 0.04 + 0.25) / 12, 1e-13);
    EXPECT_EQ(disc.centreOfMass, Vector(1, 2, 0));
}

TEST(MassProperties, FinePolygonTendsToTheDisc)
{
    // Regular polygon of n corners: I_zz / (m R^2) = (2 + cos(2 pi / n)) / 6.
    int const n = 48;
    std::vector<Vector> points;
    for (int i = 0; i < n; ++i)
    {
        Real const angle = 2 * std::numbers::pi * i / n;
        points.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    MassProperties const body = MassProperties::fromPolygon(Polyline::outline("polygon", points), 1, 1);
    EXPECT_NEAR(body.inertia(2, 2) / body.mass, (2 + std::cos(2 * std::numbers::pi / n)) / 6, 1e-14);
}

TEST(MassProperties, WrongInputIsRefused)
{
    std::vector<Vector> const points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    Polyline const open("open", points, false, Polyline::FluidSide::Left);
    EXPECT_THROW((void)MassProperties::fromPolygon(open, 1, 1), CaseError);
    Polyline const closed = Polyline::outline("closed", points);
    EXPECT_THROW((void)MassProperties::fromPolygon(closed, 0, 1), CaseError);
    EXPECT_THROW((void)MassProperties::fromPolygon(closed, 1, -1), CaseError);
    EXPECT_THROW((void)MassProperties::fromPolygon(closed, 1, std::nan("")), CaseError);
    EXPECT_THROW((void)MassProperties::fromCylinder2D(Vector::Zero(), -1, 1, 1), CaseError);
    EXPECT_THROW((void)MassProperties::fromPolygon(closed, 1, 1).withMass(0), CaseError);
}

} // namespace
} // namespace mpsDem
