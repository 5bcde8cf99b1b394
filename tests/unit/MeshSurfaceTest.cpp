// Which features of a triangle surface touch a sphere.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dem/MeshSurface.h"
#include "support/SolidScene.h"

namespace mpsDem::test {

namespace {

constexpr Real depth = 0.02;

std::vector<ContactFeature> touch(ContactSurface const& surface, Vector const& centre, Real radius, Real reach = 0)
{
    std::vector<ContactFeature> features;
    std::vector<Sphere> const spheres = {{centre, radius}};
    surface.collect(spheres, reach, features);
    return features;
}

/// Room [0, 1]^3 seen from within: floor, two walls that meet at the origin, and their counterparts.
TriSurface room() { return TriSurface::box("room", Vector::Zero(), Vector::Ones()).flipped(); }
TriSurface cube() { return TriSurface::box("cube", -Vector::Ones(), Vector::Zero()); }

} // namespace

TEST(MeshSurface, faceGivesOverlapAndNormal)
{
    MeshSurface const surface(room(), depth);
    auto const found = touch(surface, {0.5, 0.3, 0.009}, 0.01);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].gap, -0.001, 1e-15);
    EXPECT_NEAR((found[0].normal - Vector::UnitZ()).norm(), 0, 1e-15);
    EXPECT_EQ(touch(surface, {0.5, 0.3, 0.011}, 0.01).size(), 0u);
    EXPECT_EQ(touch(surface, {0.5, 0.3, 0.011}, 0.01, 0.002).size(), 1u);
}

// On the diagonals of the faces, and all over a plane of 402 triangles, there is one contact of one patch.
TEST(MeshSurface, jointsOfAPlaneAreNotFelt)
{
    TriSurface const plane = cutPlane("plane", {-1, -1, 0}, {1, 1, 0}, 200)
                                 .moved(Quaternion(Eigen::AngleAxisd(0.7, Vector(1, 2, 3).normalized())).toRotationMatrix(), {10, -20, 3});
    MeshSurface const surface(plane, depth);
    Vector const up = plane.triangles()[0].normal;
    Real worst = 0;
    auto const check = [&](Vector const& foot) {
        auto const found = touch(surface, foot + 0.009 * up, 0.01);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].patch, 0);
        worst = std::max(worst, std::abs(found[0].gap + 0.001));
    };
    for (auto const& edge : plane.edges())
        for (Real const s : {0.0, 1e-9, 0.25, 0.5, 1.0})
            if (!edge.rim()) check((1 - s) * plane.points()[edge.a] + s * plane.points()[edge.b]);
    expectBelow("joints of a plane, error of the overlap [m]", worst, 1e-13);
}

TEST(MeshSurface, valleysKeepAllTheirFaces)
{
    MeshSurface const surface(room(), depth);
    EXPECT_EQ(touch(surface, {0.5, 0.0095, 0.009}, 0.01).size(), 2u);
    EXPECT_EQ(touch(surface, {0.008, 0.0095, 0.009}, 0.01).size(), 3u);
    // A corner of a body, radius 0, that has sunk into two or three faces: beyond the end of each.
    for (Real const x : {0.5, 1e-3, 0.37})
    {
        auto const corner = touch(surface, {x, -1e-5, -2e-5}, 0);
        ASSERT_EQ(corner.size(), 2u) << x;
        EXPECT_NEAR(corner[0].gap + corner[1].gap, -3e-5, 1e-15);
    }
    EXPECT_EQ(touch(surface, {-3e-5, -1e-5, -2e-5}, 0).size(), 3u);
    EXPECT_EQ(touch(surface, {1e-5, 1e-5, -2e-5}, 0).size(), 1u);
    EXPECT_EQ(touch(surface, {1e-5, 1e-9, 1e-9}, 0).size(), 0u);
}

// Around the corner of a cube each direction is touched once, and the gap is the distance to the cube.
TEST(MeshSurface, ridgesAndVerticesTouchOnce)
{
    MeshSurface const surface(cube(), depth);
    int faces = 0, edges = 0, vertices = 0;
    for (int i = 0; i < 400; ++i)
    {
        Real const z = -1 + (i + 0.5) / 200, angle = 2.399963 * i;
        Vector const centre = 0.009 * Vector(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
        Vector const out = centre.cwiseMax(0);
        if (out.norm() == 0) continue;
        auto const found = touch(surface, centre, 0.01);
        ASSERT_EQ(found.size(), 1u) << centre.transpose();
        EXPECT_NEAR(found[0].gap, out.norm() - 0.01, 1e-15);
        EXPECT_NEAR((found[0].normal - out.normalized()).norm(), 0, 1e-12);
        auto const kinds = (out.array() > 0).count();
        (kinds == 1 ? faces : (kinds == 2 ? edges : vertices)) += 1;
    }
    EXPECT_GT(faces, 20);
    EXPECT_GT(edges, 20);
    EXPECT_GT(vertices, 20);
}

TEST(MeshSurface, pointBehindARidgeTouchesOnce)
{
    MeshSurface const surface(cube(), depth);
    auto const found = touch(surface, {-1e-4, -2e-4, -3e-4}, 0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].gap, -1e-4, 1e-15);
    EXPECT_NEAR((found[0].normal - Vector::UnitX()).norm(), 0, 1e-15);
}

TEST(MeshSurface, thinPlateHasNoFarSide)
{
    MeshSurface const plate(TriSurface::box("plate", {-1, -1, -0.01}, {1, 1, 0}), depth);
    auto const found = touch(plate, {0.3, 0.2, -1e-4}, 0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(found[0].normal.z(), 0.99);
    EXPECT_EQ(touch(plate, {0.3, 0.2, 1e-4}, 0).size(), 0u);
    EXPECT_EQ(touch(plate, {0.3, 0.2, 0.009}, 0.01).size(), 1u);
}

// On a mesh of a ball the gap is continuous in place, over faces, edges and vertices, from outside (a ball on a ball).
TEST(MeshSurface, gapIsContinuousOverACurvedMesh)
{
    MeshSurface const ball(TriSurface::sphere("ball", Vector::Zero(), 1, 0.1), 0.05);
    Real last = 0, jump = 0, turn = 0;
    Vector lastNormal = Vector::Zero();
    int const steps = 20000;
    for (int i = 0; i < steps; ++i)
    {
        Real const a = 2 * std::numbers::pi * i / steps;
        Vector const centre = 1.048 * Vector(std::cos(a), std::sin(a) * std::cos(0.4), std::sin(a) * std::sin(0.4));
        auto const found = touch(ball, centre, 0.05);
        ASSERT_EQ(found.size(), 1u) << i;
        if (i > 0)
        {
            jump = std::max(jump, std::abs(found[0].gap - last));
            turn = std::max(turn, (found[0].normal - lastNormal).norm());
        }
        last = found[0].gap;
        lastNormal = found[0].normal;
    }
    Real const step = 1.048 * 2 * std::numbers::pi / steps;
    expectBelow("ball over a mesh of a ball, change of the gap per step / step", jump / step, 0.1);
    expectBelow("ball over a mesh of a ball, turn of the normal per step / (step / gap to the edge)", turn / (step / 0.05), 1.5);
}

// A floor and a ramp, a floor beside a floor, and a plate that stands on a floor: rims that lie on another surface push nothing.
TEST(MeshSurface, rimsOnOtherSurfacesAreSilent)
{
    TriSurface const left = cutPlane("left", {-1, -1, 0}, {0, 1, 0}, 3), right = cutPlane("right", {0, -1.5, 0}, {1, 1.5, 0}, 5, 2);
    Real const c = std::numbers::sqrt2 / 2;
    TriSurface const ramp("ramp", {{0.5, -0.5, 0}, {0.5, 0.5, 0}, {1, 0.5, 0.5}, {1, -0.5, 0.5}}, {{0, 2, 1}, {0, 3, 2}});
    std::vector<TriSurface> const all{left, right, ramp};
    auto const count = [&](Vector const& centre, Real radius) {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < all.size(); ++i) sum += touch(MeshSurface(all, i, depth), centre, radius).size();
        return sum;
    };
    ASSERT_LT(ramp.triangles()[0].normal.x(), 0);
    for (Real const y : {-0.8, 0.1, 0.33})
        for (Real const x : {-0.004, -1e-7, 1e-7, 0.003})
        {
            EXPECT_EQ(count({x, y, 0.0095}, 0.01), 1u) << x; // overlap 5e-4
            EXPECT_EQ(count({x, y, -1e-6}, 0), 1u) << x;
        }
    // In the valley between floor and ramp: the sphere that touches both.
    Vector const foot(0.5, 0.1, 0);
    Real const back = 0.00995 * std::tan(std::numbers::pi / 8);
    EXPECT_EQ(count(foot + Vector(-back, 0, 0.00995), 0.01), 2u);
    EXPECT_EQ(count(foot + Vector(1e-6, 0, -1e-6), 0), 2u); // sunk into both
    EXPECT_EQ(count(foot + Vector(-2e-2, 0, 0.0099), 0.01), 1u);
    EXPECT_EQ(count(foot + 0.2 * Vector(c, 0, c) + 0.0099 * Vector(-c, 0, c), 0.01), 1u);
    // Beside the ramp its rim is free.
    EXPECT_EQ(count({0.799, 0.505, 0.301}, 0.01), 1u);
}

// A box of six single plates: each ridge and each vertex pushes once.
TEST(MeshSurface, ridgeBetweenTwoSurfacesTouchesOnce)
{
    std::vector<TriSurface> plates;
    for (std::size_t side = 0; side < 6; ++side)
    {
        std::array<bool, 6> open{true, true, true, true, true, true};
        open[side] = false;
        plates.push_back(TriSurface::box("plate" + std::to_string(side), -Vector::Ones(), Vector::Zero(), open));
    }
    auto const count = [&](Vector const& centre) {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < plates.size(); ++i) sum += touch(MeshSurface(plates, i, depth), centre, 0.01).size();
        return sum;
    };
    EXPECT_EQ(count({0.005, 0.006, -0.5}), 1u);
    EXPECT_EQ(count({0.005, -0.3, 0.006}), 1u);
    EXPECT_EQ(count({-0.3, -0.3, 0.006}), 1u);
    EXPECT_LE(count({0.005, 0.005, 0.006}), 1u);
}

// What findNear leaves out touches nothing wherever it is moved by the reach: faces, edges, valleys, and behind the surface.
TEST(MeshSurface, findNearMissesNothing)
{
    std::mt19937 random(3);
    auto const between = [&](Real low, Real high) { return low + (high - low) * static_cast<Real>(random()) / 4294967296.0; };
    auto const anywhere = [&](Real size) { return Vector(between(-size, size), between(-size, size), between(-size, size)); };
    Real const reach = 0.015;
    int touching = 0, leftOut = 0;
    for (TriSurface const& surface : {room(), cube(), TriSurface::sphere("ball", Vector::Zero(), 0.5, 0.05)})
    {
        MeshSurface const mesh(surface, depth);
        for (int i = 0; i < 20000; ++i)
        {
            Vector const foot = surface.centre(surface.triangles()[random() % surface.triangles().size()]);
            std::vector<Sphere> const sphere{
                {foot.cwiseProduct(anywhere(1).cwiseAbs()) + anywhere(0.1), i % 3 == 0 ? 0 : between(0, 0.05)}};
            std::vector<int> found;
            mesh.findNear(sphere, reach, found);
            Vector const moved = sphere[0].centre + between(0, reach) * anywhere(1).normalized();
            bool const touches = !touch(mesh, moved, sphere[0].radius).empty();
            touching += touches;
            leftOut += found.empty();
            EXPECT_FALSE(touches && found.empty()) << sphere[0].centre.transpose() << " r " << sphere[0].radius;
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(leftOut, 1000);
}

} // namespace mpsDem::test
