#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bodies/MassProperties.h"
#include "core/Errors.h"
#include "support/Measured.h"

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

TEST(MassProperties, BoxOfTrianglesAgreesWithClosedForms)
{
    MassProperties const body = MassProperties::fromTriSurface(TriSurface::box("box", {1, 2, 3}, {2, 4, 6}), 500);
    EXPECT_NEAR(body.volume, 6, 1e-13);
    EXPECT_NEAR(body.mass, 3000, 1e-10);
    EXPECT_NEAR((body.centreOfMass - Vector(1.5, 3, 4.5)).norm(), 0, 1e-14);
    Tensor const exact = (3000.0 / 12 * Vector(4 + 9, 1 + 9, 1 + 4)).asDiagonal();
    EXPECT_NEAR((body.inertia - exact).norm(), 0, 1e-10);
}

TEST(MassProperties, PrismOfTrianglesIsThatOverItsPolygon)
{
    std::vector<Vector> const corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0.4, 0}, {0, 2, 0}};
    MassProperties const flat = MassProperties::fromPolygon(Polyline::outline("outline", corners), 0.55, 1000);
    MassProperties const solid = MassProperties::fromTriSurface(TriSurface::prism("prism", corners, -0.275, 0.275), 1000);
    test::expectBelow("prism, mass", solid.mass / flat.mass - 1, 1e-14);
    test::expectBelow("prism, centre", (solid.centreOfMass - flat.centreOfMass).norm(), 1e-15);
    test::expectBelow("prism, inertia", (solid.inertia - flat.inertia).norm() / flat.inertia.norm(), 1e-14);
    EXPECT_EQ(solid.inertia, solid.inertia.transpose());
}

TEST(MassProperties, MovedAndTurnedTrianglesKeepTheirInertiaFarFromTheOrigin)
{
    std::vector<Vector> const corners = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
    TriSurface const wedgeSkin = TriSurface::prism("wedge", corners, 0, 0.55);
    Tensor const rotation = Eigen::AngleAxisd(0.7, Vector(1, 2, -1).normalized()).toRotationMatrix();
    Vector const away(5e5, 40, -4.5e6); // as maps count
    MassProperties const here = MassProperties::fromTriSurface(wedgeSkin, 1000);
    MassProperties const turned = MassProperties::fromTriSurface(wedgeSkin.moved(rotation, Vector::Zero()), 1000);
    MassProperties const there = MassProperties::fromTriSurface(wedgeSkin.moved(rotation, away), 1000);
    Tensor const exact = rotation * here.inertia * rotation.transpose();
    test::expectBelow("turned, inertia", (turned.inertia - exact).norm() / exact.norm(), 1e-14);
    test::expectBelow("turned, centre", (turned.centreOfMass - rotation * here.centreOfMass).norm(), 1e-15);
    // The points themselves carry round-off of half of 2^-30 m = 9e-10 m there, in a body of 0.5 m.
    test::expectBelow("4500 km away, inertia", (there.inertia - exact).norm() / exact.norm(), 1e-8);
    test::expectBelow("4500 km away, mass", there.mass / here.mass - 1, 1e-8);
    test::expectBelow("4500 km away, centre [m]", (there.centreOfMass - away - turned.centreOfMass).norm(), 2e-9);
}

TEST(MassProperties, SphereOfTrianglesTendsToTheBallWithSecondOrder)
{
    MassProperties const ball = MassProperties::fromSphere({1, 2, 3}, 0.5, 2000);
    Real const m = 2000 * 4 * std::numbers::pi / 3 * 0.125;
    EXPECT_NEAR(ball.mass, m, 1e-12 * m);
    EXPECT_NEAR(ball.inertia(1, 1), 0.4 * m * 0.25, 1e-12);
    EXPECT_EQ(ball.inertia(0, 1), 0);
    std::array<Real, 3> error{};
    for (int k = 0; k < 3; ++k)
    {
        auto const body = MassProperties::fromTriSurface(TriSurface::sphere("ball", {1, 2, 3}, 0.5, 0.2 / (1 << k)), 2000);
        error[static_cast<std::size_t>(k)] = (body.inertia - ball.inertia).norm() / ball.inertia.norm();
        EXPECT_NEAR((body.centreOfMass - Vector(1, 2, 3)).norm(), 0, 1e-14);
    }
    test::expectBetween("sphere, order of the inertia", std::log2(error[1] / error[2]), 1.95, 2.05);
    test::expectBelow("sphere, finest inertia", error[2], 5e-3);
}

TEST(MassProperties, CylinderAlongAnyAxis)
{
    Vector const end1(1, 0, 0), end2(1, 2, 1);
    MassProperties const rod = MassProperties::fromCylinder(end1, end2, 0.5, 100);
    Real const h = std::sqrt(5.0), m = 100 * std::numbers::pi * 0.25 * h;
    Vector const axis = (end2 - end1) / h, across = Vector(1, 0, 0);
    EXPECT_NEAR(rod.mass, m, 1e-12 * m);
    EXPECT_NEAR(axis.dot(rod.inertia * axis), m * 0.25 / 2, 1e-12 * m);
    EXPECT_NEAR(across.dot(rod.inertia * across), m * (3 * 0.25 + 5) / 12, 1e-12 * m);
    EXPECT_NEAR((rod.inertia * axis).cross(axis).norm(), 0, 1e-12 * m);
    EXPECT_EQ(rod.centreOfMass, Vector(1, 1, 0.5));
    MassProperties const disc = MassProperties::fromCylinder2D({0, 0, 0}, 0.2, 0.5, 2000);
    MassProperties const same = MassProperties::fromCylinder({0, 0, -0.25}, {0, 0, 0.25}, 0.2, 2000);
    EXPECT_NEAR((same.inertia - disc.inertia).norm(), 0, 1e-13);
    auto const skin = MassProperties::fromTriSurface(TriSurface::cylinder("rod", end1, end2, 0.5, 256), 100);
    test::expectBelow("cylinder of 256 sides, inertia", (skin.inertia - rod.inertia).norm() / rod.inertia.norm(), 3e-4);
}

TEST(MassProperties, SurfacesWithoutAnInsideAreRefused)
{
    auto const messageOf = [](TriSurface const& surface) -> std::string {
        try
        {
            static_cast<void>(MassProperties::fromTriSurface(surface, 1000));
        }
        catch (CaseError const& error)
        {
            EXPECT_EQ(error.code(), ExitCode::BadInput);
            return error.what();
        }
        return {};
    };
    TriSurface const box = TriSurface::box("box", {0, 0, 0}, {1, 1, 1});
    EXPECT_NE(messageOf(TriSurface::box("tank", {0, 0, 0}, {1, 1, 1}, {true})).find("open: it has a rim at"), std::string::npos);
    EXPECT_NE(messageOf(box.flipped()).find("normals on the inside"), std::string::npos);
    std::vector<Vector> const sheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_NE(messageOf(TriSurface("sheet", sheet, {{0, 1, 2}, {0, 2, 1}})).find("no volume"), std::string::npos);
    EXPECT_THROW((void)MassProperties::fromTriSurface(box, 0), CaseError);
    EXPECT_THROW((void)MassProperties::fromTriSurface(box, std::nan("")), CaseError);
    EXPECT_THROW((void)MassProperties::fromSphere({0, 0, 0}, 0, 1), CaseError);
    EXPECT_THROW((void)MassProperties::fromCylinder({0, 0, 0}, {0, 0, 0}, 1, 1), CaseError);
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
