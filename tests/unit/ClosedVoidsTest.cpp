#include <cmath>
#include <functional>
#include <random>
#include <span>

#include <gtest/gtest.h>

#include "boundaries/BoundaryRows.h"
#include "core/Log.h"
#include "functionObjects/VoidSearch.h"
#include "support/FunctionObjectScene.h"
#include "support/RunCase.h"

namespace mpsDem {
namespace {

using test::expectBelow;
using Scene = FunctionObjectScene;
using Inside = std::function<bool(Vector const&)>;

constexpr Real spacing = 0.05;
Real const particle = spacing * spacing; ///< Area for a thickness of 1 m.

bool nowhere(Vector const&) { return false; }

/// A block of n x n (x n) fluid particles at (0, 0, 0), each moved by up to `jitter` spacings along each axis, without those that lie in a hole.
std::vector<Scene::Point> water(int n, Real jitter, Inside const& hole, int dimensions = 2, unsigned seed = 1)
{
    std::mt19937 random(seed);
    auto const shift = [&] { return jitter * (static_cast<Real>(random()) / 2147483648.0 - 1); };
    std::vector<Scene::Point> points;
    for (int k = 0; k < (dimensions == 3 ? n : 1); ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
            {
                Vector const site = spacing * Vector(i + 0.5, j + 0.5, dimensions == 3 ? k + 0.5 : 0);
                if (hole(site)) continue;
                Vector const moved = site + spacing * Vector(shift(), shift(), dimensions == 3 ? shift() : 0);
                points.push_back({moved});
            }
    return points;
}

std::vector<VoidSearch::Void> voidsIn(std::vector<Scene::Point> const& points, int dimensions = 2,
                                      VoidSearch::Controls const* controls = nullptr)
{
    Scene scene({dimensions, spacing, 1});
    scene.place(points);
    VoidSearch search(controls ? *controls : VoidSearch::Controls::defaults(dimensions));
    search.find(scene.particles);
    return search.find(scene.particles); // the second search uses the memory of the first
}

/// Number of sites of `water` that a hole takes out.
int missing(int n, Inside const& hole, int dimensions = 2)
{
    return static_cast<int>(water(n, 0, nowhere, dimensions).size() - water(n, 0, hole, dimensions).size());
}

Inside disc(Vector const& centre, Real radius)
{
    return [=](Vector const& r) { return (r - centre).norm() < radius; };
}

/// Particles of a body and the water around it.
std::vector<Scene::Point> bodyInWater(Polyline const& outline)
{
    int const ghostRows = 3;
    BoundaryRows const rows = boundaryRows(std::span(&outline, 1), std::span(&ghostRows, 1), spacing);
    std::vector<Scene::Point> points =
        water(50, 0, [&](Vector const& r) { return outline.encloses(r) || outline.closest(r).distance < 0.45 * spacing; });
    for (std::size_t i = 0; i < rows.position.size(); ++i) points.push_back({rows.position[i], rows.type[i], rows.normal[i]});
    return points;
}

TEST(ClosedVoids, DisorderedWaterHasNone)
{
    std::size_t found = 0;
    for (unsigned seed = 1; seed <= 4; ++seed)
        for (Real const jitter : {0.0, 0.1, 0.2, 0.3}) found += voidsIn(water(100, jitter, nowhere, 2, seed)).size();
    expectBelow("voids in 4 x 1e4 particles, jitter 0..0.3", static_cast<Real>(found), 0.5);
    found = voidsIn(water(25, 0.3, nowhere, 3), 3).size();
    expectBelow("voids in 1.6e4 particles in 3-D, jitter 0.3", static_cast<Real>(found), 0.5);
}

TEST(ClosedVoids, OneMissingParticleIsFoundWhereAskedFor)
{
    VoidSearch::Controls controls = VoidSearch::Controls::defaults(2);
    controls.smallest = 0.75;
    Vector const site = spacing * Vector(10.5, 8.5, 0);
    for (Real const offset : {0.0, 0.3, 0.7}) // against the cells: one more particle moves the corner of the grid
    {
        auto points = water(20, 0, disc(site, 0.5 * spacing));
        points.push_back({spacing * Vector(-3 - offset, -3 - 0.6 * offset, 0)});
        auto const voids = voidsIn(points, 2, &controls);
        ASSERT_EQ(voids.size(), 1u);
        EXPECT_NEAR(voids[0].volume, particle, 0.02 * particle);
        EXPECT_LT((voids[0].centre - site).norm(), 0.25 * spacing);
    }
    EXPECT_TRUE(voidsIn(water(20, 0, disc(site, 0.5 * spacing))).empty());
}

TEST(ClosedVoids, PocketHasItsAreaAndPlace)
{
    Vector const centre = spacing * Vector(20.5, 17.5, 0);
    for (Real const radius : {1.2, 2.6, 5.2})
        for (Real const jitter : {0.0, 0.15})
        {
            Inside const pocket = disc(centre, radius * spacing);
            auto const voids = voidsIn(water(40, jitter, pocket));
            ASSERT_EQ(voids.size(), 1u);
            Real const area = missing(40, pocket) * particle;
            std::string const what = std::to_string(missing(40, pocket)) + " missing, jitter " + std::to_string(jitter).substr(0, 4);
            expectBelow("void's area, relative error, " + what, std::abs(voids[0].volume / area - 1), 0.15);
            expectBelow("void's centre [spacings], " + what, (voids[0].centre - centre).norm() / spacing, 0.5);
        }
}

TEST(ClosedVoids, PocketInThreeDimensionsIsFound)
{
    Vector const centre = spacing * Vector(8, 7, 8);
    Inside const pocket = disc(centre, 2.2 * spacing);
    auto const voids = voidsIn(water(16, 0.1, pocket, 3), 3);
    ASSERT_EQ(voids.size(), 1u);
    Real const volume = missing(16, pocket, 3) * particle * spacing;
    expectBelow("void's volume in 3-D, relative error", std::abs(voids[0].volume / volume - 1), 0.15);
    expectBelow("void's centre in 3-D [spacings]", (voids[0].centre - centre).norm() / spacing, 0.5);
}

TEST(ClosedVoids, PocketWithChannelToTheAirIsOpen)
{
    Vector const centre = spacing * Vector(20, 17, 0);
    Inside const pocket = disc(centre, 4 * spacing);
    Inside const withChannel = [&](Vector const& r) {
        return pocket(r) || (r.y() > centre.y() && std::abs(r.x() - centre.x()) < spacing); // two columns of particles
    };
    for (Real const jitter : {0.0, 0.15})
    {
        EXPECT_EQ(voidsIn(water(40, jitter, pocket)).size(), 1u);
        EXPECT_TRUE(voidsIn(water(40, jitter, withChannel)).empty());
    }
}

TEST(ClosedVoids, InsideOfABodyIsNone)
{
    Polyline const wedge = Polyline::outline("wedge", {{0.4, 1.9, 0}, {1.9, 0.4, 0}, {1.9, 1.9, 0}});
    Polyline const box = Polyline::outline("box", {{1.2, 0.5, 0}, {2.0, 1.1, 0}, {1.4, 1.9, 0}, {0.6, 1.3, 0}});
    EXPECT_TRUE(voidsIn(bodyInWater(wedge)).empty());
    EXPECT_TRUE(voidsIn(bodyInWater(box)).empty());
}

TEST(ClosedVoids, PocketAtABodyIsOne)
{
    Polyline const box = Polyline::outline("box", {{0.8, 0.8, 0}, {1.7, 0.8, 0}, {1.7, 1.7, 0}, {0.8, 1.7, 0}});
    std::vector<Scene::Point> points = bodyInWater(box);
    std::size_t const before = points.size();
    std::erase_if(points, [](Scene::Point const& p) { return p.r.y() > 1.7 && p.r.y() < 1.85 && p.r.x() > 0.9 && p.r.x() < 1.6; });
    auto const voids = voidsIn(points);
    ASSERT_EQ(voids.size(), 1u);
    Real const area = static_cast<Real>(before - points.size()) * particle;
    expectBelow("void's area on a body, relative error", std::abs(voids[0].volume / area - 1), 0.15);
    EXPECT_NEAR(voids[0].centre.y(), 1.775, 0.5 * spacing);
}

TEST(ClosedVoids, TwoPocketsAreTwoLargestFirst)
{
    Vector const small = spacing * Vector(14, 18, 0), large = spacing * Vector(24, 18, 0);
    Inside const first = disc(small, 3 * spacing), second = disc(large, 5 * spacing);
    auto const voids = voidsIn(water(40, 0.1, [&](Vector const& r) { return first(r) || second(r); }));
    ASSERT_EQ(voids.size(), 2u); // two rows of water between them
    EXPECT_GT(voids[0].volume, voids[1].volume);
    EXPECT_LT((voids[0].centre - large).norm(), 0.5 * spacing);
    EXPECT_LT((voids[1].centre - small).norm(), 0.5 * spacing);
}

TEST(ClosedVoids, AirOfAClosedBoxIsOpenWhereThePointSaysSo)
{
    std::vector<Scene::Point> points = water(30, 0, [](Vector const& r) { return r.y() > 0.9 || disc({0.7, 0.5, 0}, 0.2)(r); });
    for (Scene::Point const& wall :
         water(34, 0, [](Vector const& r) { return r.minCoeff() > -1 && r.x() > 0.1 && r.x() < 1.6 && r.y() > 0.1 && r.y() < 1.6; }))
        points.push_back({wall.r - Vector(0.1, 0.1, 0), ParticleType::Wall});
    VoidSearch::Controls controls = VoidSearch::Controls::defaults(2);
    auto const closed = voidsIn(points, 2, &controls);
    ASSERT_EQ(closed.size(), 2u);
    EXPECT_NEAR(closed[0].volume, 0.6 * 1.5, 0.02);
    controls.openAt = Vector(0.75, 1.45, 0);
    auto const open = voidsIn(points, 2, &controls);
    ASSERT_EQ(open.size(), 1u);
    EXPECT_LT((open[0].centre - Vector(0.7, 0.5, 0)).norm(), 0.5 * spacing);
}

TEST(ClosedVoids, WritesItsTableAndTellsOfLargeVoids)
{
    Scene scene({2, spacing, 1});
    RunContext const context = scene.context();
    Vector const centre = spacing * Vector(20, 17, 0);
    scene.place(water(40, 0, nowhere));
    auto const object = makeFunctionObject("type closedVoids;", context);
    muteLog(true);
    int const before = warningCount();
    object->write({1, 0.1, 0.1, false});
    EXPECT_EQ(warningCount(), before);
    scene.place(water(40, 0, disc(centre, 4 * spacing)));
    object->write({2, 0.2, 0.1, false});
    object->write({3, 0.3, 0.1, false});
    EXPECT_EQ(warningCount(), before + 1);
    scene.place(water(40, 0, disc(centre, 1.2 * spacing)));
    object->write({4, 0.4, 0.1, false});
    EXPECT_EQ(warningCount(), before + 2);
    muteLog(false);
    Table const table = scene.table("watch/0/closedVoids.dat");
    EXPECT_EQ(table.names, (std::vector<std::string>{"Time", "voids", "volume", "largest", "largest_x", "largest_y", "largest_z"}));
    EXPECT_EQ(table.column("voids")[0], 0);
    EXPECT_TRUE(std::isnan(table.column("largest_x")[0]));
    EXPECT_EQ(table.column("voids")[1], 1);
    EXPECT_NEAR(table.column("volume")[1], missing(40, disc(centre, 4 * spacing)) * particle, 0.05 * table.column("volume")[1]);
    EXPECT_NEAR(table.column("largest_x")[1], centre.x(), 0.5 * spacing);
}

TEST(ClosedVoids, RefusesWhatCannotBe)
{
    Scene dry({2, spacing, 1});
    RunContext const dryContext = dry.context();
    EXPECT_THROW(makeFunctionObject("type closedVoids;", dryContext), CaseError);
    Scene scene({2, spacing, 1});
    scene.place(water(10, 0, nowhere));
    RunContext const context = scene.context();
    EXPECT_THROW(makeFunctionObject("type closedVoids; resolution 1;", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type closedVoids; reach 0.5;", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type closedVoids; warnVolume -1;", context), CaseError);
    EXPECT_THROW(makeFunctionObject("type closedVoids; opnAt (0 0 0);", context), CaseError);
}

} // namespace
} // namespace mpsDem
