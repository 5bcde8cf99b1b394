// A block and a ball on inclined planes of triangles, against closed forms and against the same in 2-D.

#include "io/StlFile.h"
#include "support/SolidScene.h"
#include "support/TemporaryFolder.h"

namespace mpsDem::test {

namespace {

constexpr Real g = 9.81;
constexpr Real pi = std::numbers::pi;
constexpr Real density = 2700;
Vector const size(0.3, 0.2, 0.1);

std::string linear(Real mu, Real stiffness = 1e9)
{
    return "mu " + std::to_string(mu) + "; e 0.2; stiffness constant; normalStiffness " + std::to_string(stiffness) + ";";
}

/// A block lies with the overlap that carries it on the plane z = 0, under gravity that leans by `angle` towards x: an incline in its own
/// axes. @param yaw  Turn of the block about z. @param turn  Of everything.
std::unique_ptr<SolidScene> blockOnPlane(Real mu, Real angle, Real spacing, TriSurface const& plane, Real stiffness = 1e9, Real yaw = 0,
                                         Quaternion const& turn = Quaternion::Identity())
{
    auto scene = std::make_unique<SolidScene>();
    scene->gravity = g * (turn * Vector(std::sin(angle), 0, -std::cos(angle)));
    scene->spacing = spacing;
    scene->walls = {plane.moved(turn.toRotationMatrix(), Vector::Zero())};
    Real const overlap = density * size.z() * g * std::cos(angle) / stiffness;
    scene->addCuboid("block", size, density, turn * Vector(0, 0, 0.5 * size.z() - overlap),
                     turn * Quaternion(Eigen::AngleAxisd(yaw, Vector::UnitZ())));
    scene->build(linear(mu, stiffness));
    return scene;
}

void run(SolidScene& scene, int steps)
{
    for (int i = 0; i < steps; ++i) scene.step(0.002);
}

} // namespace

TEST(SolidIncline, slidesAsCoulombSays)
{
    for (auto const& [mu, yaw] : {std::pair(0.0105, 0.0), std::pair(0.3, 0.5), std::pair(0.9, 0.0)})
    {
        auto scene = blockOnPlane(mu, pi / 4, 0.05, floorMesh(), mu > 0.5 ? 2e11 : 1e9, yaw);
        run(*scene, 200);
        Real const exact = 0.5 * g * (1 - mu) / std::numbers::sqrt2 * 0.16;
        expectBelow("block on 45 deg, mu " + std::to_string(mu) + ", yaw " + std::to_string(yaw) + ", relative error of path",
                    scene->pointers[0]->centre().x() / exact - 1, 1e-3);
        expectBelow("  sideways [m]", scene->pointers[0]->centre().y(), 1e-5);
    }
}

TEST(SolidIncline, sticksBelowTheFrictionAngle)
{
    auto scene = blockOnPlane(1.1, pi / 4, 0.04, floorMesh());
    run(*scene, 250);
    Vector const there = scene->pointers[0]->centre();
    expectBelow("block on 45 deg, mu 1.1, slip [m]", there.head<2>().norm(), 1e-4);
    run(*scene, 250);
    expectBelow("block on 45 deg, mu 1.1, creep in 0.5 s more [m]", (scene->pointers[0]->centre() - there).norm(), 1e-9);
    expectBelow("block on 45 deg, mu 1.1, speed at the end [m/s]", scene->pointers[0]->velocity().norm(), 1e-9);
}

// The same incline in world axes, as triangles and as a polyline of the x-y plane.
TEST(SolidIncline, agreesWithTwoDimensions)
{
    Vector const down = Vector(1, -1, 0).normalized(), up = Vector(1, 1, 0).normalized();
    Real const overlap = density * 0.1 * g / std::numbers::sqrt2 / 1e9;
    Vector const start = Vector(0.5, 4.5, 0) + (0.05 - overlap) * up;
    ContactScene flat;
    flat.gravity = Vector(0, -g, 0);
    flat.surfaces = {Polyline("ramp", {{0, 5, 0}, {5, 0, 0}}, false, Polyline::FluidSide::Left)};
    flat.addBox("block", 0.3, 0.1, density, start, -pi / 4);
    flat.build(linear(0.3));

    SolidScene solid;
    solid.gravity = flat.gravity;
    solid.walls = {TriSurface::extruded("ramp", {{0, 5, 0}, {5, 0, 0}}, false, -1, 1, true)};
    solid.addCuboid("block", {0.3, 0.1, 0.2}, density, start, Quaternion(Eigen::AngleAxisd(-pi / 4, Vector::UnitZ())));
    solid.build(linear(0.3));
    for (int i = 0; i < 100; ++i)
    {
        flat.step(0.002);
        solid.step(0.002);
    }
    Real const path = (flat.pointers[0]->centre() - start).dot(down);
    expectBelow("incline in 3-D against 2-D, relative difference of path", (solid.pointers[0]->centre() - start).dot(down) / path - 1,
                1e-4);
    expectBelow("incline in 3-D, out of the plane [m]", solid.pointers[0]->centre().z(), 1e-9);
}

TEST(SolidIncline, frictionDoesNotDependOnTheSpacing)
{
    for (Real const spacing : {0.1, 0.05, 0.025})
    {
        auto scene = blockOnPlane(0.3, pi / 4, spacing, floorMesh());
        run(*scene, 100);
        Real const effective = 1 - scene->pointers[0]->centre().x() * std::numbers::sqrt2 / (0.5 * g * 0.04);
        expectBelow("friction from the path at spacing " + std::to_string(spacing) + ", relative error", effective / 0.3 - 1, 0.01);
    }
}

// A block that slides and turns on a leaning plane of 2, 200 and 20 000 triangles at random takes the same path, and no joint is felt.
TEST(SolidIncline, cutsOfThePlaneAreNotFelt)
{
    Vector const low(-1, -1, 0), high(2, 1, 0);
    Quaternion const lean(Eigen::AngleAxisd(0.7, Vector(1, 2, 3).normalized()));
    Vector const up = lean * Vector::UnitZ();
    Vector end = Vector::Zero();
    Vector turn = Vector::Zero();
    for (int const cuts : {0, 99, 9999})
    {
        auto scene = blockOnPlane(0.3, pi / 6, 0.04, cutPlane("plane", low, high, cuts), 1e9, 0, lean);
        RigidBody& block = *scene->pointers[0];
        block.setVelocity(lean * Vector(1, 0.3, -1e-5), 4 * up); // it approaches: rounding does not decide whether it does
        Real const weight = block.mass() * g * std::cos(pi / 6);
        Real least = 1e300, most = 0;
        run(*scene, 20); // friction presses the front down at first
        for (int i = 0; i < 40; ++i)
            scene->step(0.002, 1, [&] {
                least = std::min(least, block.contactNormal.force.dot(up));
                most = std::max(most, block.contactNormal.force.dot(up));
            });
        std::string const name = "plane of " + std::to_string(2 + 2 * cuts) + " triangles, ";
        expectBetween(name + "least normal force / weight", least / weight, 0.999, 1.001);
        expectBetween(name + "largest normal force / weight", most / weight, 0.999, 1.001);
        EXPECT_GT(block.centre().dot(lean * Vector::UnitX()), 0.1);
        if (cuts == 0)
        {
            end = block.centre();
            turn = block.rotation().col(0);
            continue;
        }
        expectBelow(name + "difference of place [m]", (block.centre() - end).norm(), 1e-9);
        expectBelow(name + "difference of attitude [rad]", (block.rotation().col(0) - turn).norm(), 1e-9);
    }
}

// The same block slides for 1 s down a leaning plane: an endless one (a stopper), and 2000 triangles at random read from an STL file.
TEST(SolidInclineGate, slidesOnAPlaneFromAFileAsOnAnEndlessOne)
{
    Real const mu = 0.3, angle = pi / 6, exact = 0.5 * g * (std::sin(angle) - mu * std::cos(angle));
    Quaternion const turn(Eigen::AngleAxisd(0.7, Vector(1, 2, 3).normalized()));
    Vector const down = turn * Vector::UnitX(), up = turn * Vector::UnitZ();
    TemporaryFolder const folder;
    TriSurface const cut = cutPlane("plane", {-1, -1, 0}, {3, 1, 0}, 999).moved(turn.toRotationMatrix(), {0, 0, 0});
    writeStl(folder / "plane.stl", cut);
    TriSurface const read = readStl(folder / "plane.stl", "plane");
    ASSERT_EQ(read.triangles().size(), 2000u);
    std::array<Real, 2> path{};
    for (bool const fromFile : {false, true})
    {
        auto scene = blockOnPlane(mu, angle, 0.05, floorMesh(), 1e9, 0.4, turn);
        std::ostringstream plane;
        plane.precision(17);
        plane << "stoppers { plane { type stopper; body block; point (0 0 0); normal (" << up.transpose() << "); " << linear(mu) << " } }";
        scene->walls.clear();
        if (fromFile) scene->walls = {read};
        scene->build(linear(mu) + (fromFile ? "" : plane.str()));
        RigidBody const& block = *scene->pointers[0];
        Vector const start = block.centre();
        run(*scene, 500);
        Vector const way = block.centre() - start;
        std::string const name = fromFile ? "plane of 2000 triangles from an STL file" : "endless plane";
        path[fromFile] = way.dot(down);
        std::printf("%s: way after 1 s %.7f m, closed form %.7f m\n", name.c_str(), path[fromFile], exact);
        expectBelow(name + ", way after 1 s over the closed form - 1", path[fromFile] / exact - 1, 1e-3);
        expectBelow(name + ", off the plane [m]", way.dot(up), 1e-5);
    }
    expectBelow("way on the plane from the file over that on the endless one - 1", path[1] / path[0] - 1, 1e-3);
}

// A ball rolls where tan(theta) <= 3.5 mu: a = 5/7 g sin(theta); else it slips: a = g (sin - mu cos). Its plane has 402 triangles.
TEST(SolidIncline, ballRollsOrSlips)
{
    for (Real const mu : {0.2, 0.5})
    {
        SolidScene scene;
        scene.gravity = g / std::numbers::sqrt2 * Vector(1, 0, -1);
        scene.walls = {cutPlane("plane", {-1, -1, 0}, {3, 1, 0}, 200)};
        RigidBody& ball = scene.addSphere("ball", 0.1, 2000, {0, 0, 0.1 - 1e-6});
        scene.build("mu " + std::to_string(mu) + "; e 0.2;");
        Real const rolling = 5.0 / 7.0 * g / std::numbers::sqrt2;
        Real const slipping = g * (1 - mu) / std::numbers::sqrt2;
        Real const exact = 0.5 * 0.25 * (1 > 3.5 * mu ? slipping : rolling);
        for (int i = 0; i < 50; ++i) scene.step(0.01);
        expectBelow("ball on 45 deg, mu " + std::to_string(mu) + ", relative error of path", ball.centre().x() / exact - 1, 2e-3);
        expectBelow("  sideways [m]", ball.centre().y(), 1e-9);
    }
}

// A ball rolls over a ridge of 2 degrees between two facets: it stays on the bed, its energy stays, and the force stays smooth.
TEST(SolidIncline, ballRollsOverAFacetJoint)
{
    Real const angle = 2 * pi / 180, rise = std::tan(angle);
    SolidScene scene;
    scene.gravity = Vector(0, 0, -g);
    scene.walls = {TriSurface("bed", {{-1, -1, 0}, {0, -1, 0}, {1, -1, -rise}, {-1, 1, 0}, {0, 1, 0}, {1, 1, -rise}},
                              {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}})};
    RigidBody& ball = scene.addSphere("ball", 0.1, 2000, {-0.1, 0, 0.1});
    ball.setVelocity({0.5, 0.1, 0}, {-1, 5, 0});
    scene.build("mu 0.5; e 0.2;");
    Real const before = scene.energy();
    Real const weight = ball.mass() * g;
    Real most = 0;
    for (int i = 0; i < 250; ++i) scene.step(0.002, 1, [&] { most = std::max(most, ball.contactNormal.force.norm()); });
    EXPECT_GT(ball.centre().x(), 0.1);
    Vector const normal(std::sin(angle), 0, std::cos(angle));
    expectBelow("ball past a ridge, height over the facet [m]", ball.centre().dot(normal) - 0.1, 1e-4);
    expectBelow("ball past a ridge, energy budget, relative", scene.energy() / before - 1, 1e-3);
    expectBelow("ball past a ridge, largest normal force / weight", most / weight, 1.5);
}

} // namespace mpsDem::test
