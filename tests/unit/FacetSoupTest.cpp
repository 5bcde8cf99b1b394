#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "support/Measured.h"
#include "support/StlSample.h"

namespace mpsDem {
namespace {

using namespace mpsDem::test;

class FacetSoupJoining : public StlSample
{};

TEST_F(FacetSoupJoining, CornersThatAlmostMeetBecomeOnePoint)
{
    Facets facets = boxFacets();
    std::mt19937_64 generator(3);
    for (auto& facet : facets)
        for (Vector& r : facet)
            for (Real& x : r) x += 1e-9 * (static_cast<Real>(generator() >> 11) * 0x1p-53 - 0.5);
    TriSurface const box = readClosed(textOf(facets)); // 1.5e-9 of 3 m apart at most
    EXPECT_EQ(box.points().size(), 8u);
    Facets apart = boxFacets();
    apart[0][0].x() += 1e-5;
    expectRefused(textOf(apart), "open: 4 edges belong to one facet only", Skin::Closed, 2);
}

TEST_F(FacetSoupJoining, FacetsWithoutAreaGoWithANoteAndLeaveNoCrack)
{
    Facets facets = boxFacets();
    facets.insert(facets.begin() + 4, {Vector(0, 0, 0), Vector(1, 2, 3), Vector(0, 0, 0)});
    EXPECT_NE(notesOf(binaryOf(facets)).find("1 of 13 facets without area left out or joined to their neighbours, the first one facet 5"),
              std::string::npos);
    EXPECT_TRUE(readClosed(binaryOf(facets)).closed());

    // The first facet's side from a to b is broken at its middle, towards a facet whose corners lie in a line.
    facets = boxFacets();
    Vector const a = facets[0][0], b = facets[0][1], c = facets[0][2], middle = (a + b) / 2;
    facets[0] = {a, middle, c};
    facets.push_back({middle, b, c});
    facets.push_back({a, b, middle});
    TriSurface const box = readClosed(binaryOf(facets));
    EXPECT_EQ(box.points().size(), 9u);
    EXPECT_EQ(box.triangles().size(), 14u);
    EXPECT_EQ(box.patches(), 6);
    EXPECT_NEAR(box.volume(), 6, 1e-12);
    // Two of them beside each other.
    Vector const quarter = (3 * a + b) / 4;
    facets[0] = {a, quarter, c};
    facets.back() = {a, b, middle};
    facets.push_back({a, middle, quarter});
    facets.push_back({quarter, middle, c});
    TriSurface const again = readClosed(binaryOf(facets));
    EXPECT_EQ(again.points().size(), 10u);
    EXPECT_EQ(again.triangles().size(), 16u);
    EXPECT_NEAR(again.volume(), 6, 1e-12);
}

TEST_F(FacetSoupJoining, FacetsGivenTwiceGoWithANoteAndPlatesWithoutThicknessAreRefused)
{
    Facets facets = boxFacets();
    facets.push_back({facets[2][1], facets[2][2], facets[2][0]});
    std::string const notes = notesOf(binaryOf(facets));
    EXPECT_NE(notes.find("1 of 13 facets given twice left out, the first one facet 13"), std::string::npos) << notes;
    EXPECT_NEAR(readClosed(binaryOf(facets)).volume(), 6, 1e-12);
    std::swap(facets[12][0], facets[12][1]);
    expectRefused(binaryOf(facets), "facet 13 lies on the back of facet 3");
}

TEST_F(FacetSoupJoining, OpenBodiesAreRefusedWithTheirRim)
{
    Facets facets = boxFacets();
    facets.erase(facets.begin() + 8, facets.begin() + 10);
    EXPECT_FALSE(read(binaryOf(facets)).closed());
    expectRefused(binaryOf(facets), "open: 4 edges belong to one facet only, the first one at (0 1 0) m to facet 2", Skin::Closed);
}

TEST_F(FacetSoupJoining, EdgesOfMoreThanTwoFacetsAreRefused)
{
    Facets facets = boxFacets();
    facets.push_back({Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, -1, -1)});
    expectRefused(binaryOf(facets), "the edge at (0.5 0 0) m belongs to 3 facets");
}

TEST_F(FacetSoupJoining, MixedWindingsAreRefused)
{
    Facets facets = boxFacets();
    for (std::size_t const k : {1, 6, 7}) std::swap(facets[k][0], facets[k][2]);
    expectRefused(binaryOf(facets), "3 of 12 facets wind the other way than their neighbours, the first one facet 2");
    expectRefused(textOf(facets), "3 of 12 facets wind the other way", Skin::Closed, 9);
    for (std::size_t k = 0; k < facets.size(); ++k)
        if (k != 1 && k != 6 && k != 7) std::swap(facets[k][0], facets[k][2]);
    EXPECT_NEAR(read(binaryOf(facets)).volume(), -6, 1e-12);
    EXPECT_NEAR(readClosed(binaryOf(facets)).volume(), 6, 1e-12);
}

TEST_F(FacetSoupJoining, SkinsThatCutThroughThemselvesAreRefused)
{
    Facets two = boxFacets({0, 0, 0}, {1, 1, 1}), other = boxFacets({0.5, 0.25, 0.3}, {1.5, 1.25, 1.3});
    two.insert(two.end(), other.begin(), other.end());
    expectRefused(binaryOf(two), " cut through each other at (", Skin::Body);
    EXPECT_NO_THROW(static_cast<void>(read(binaryOf(two)))) << "walls may cut each other";
    Facets touching = boxFacets({0, 0, 0}, {1, 1, 1});
    other = boxFacets({0.25, 1, 0.125}, {1.5, 2, 0.5});
    touching.insert(touching.end(), other.begin(), other.end());
    EXPECT_NEAR(read(binaryOf(touching), {1, Skin::Body, 0}).volume(), 1 + 1.25 * 0.375, 1e-6) << "solids may stand on each other";
    Facets twisted = boxFacets({0, 0, 0}, {1, 1, 1});
    for (auto& facet : twisted)
        for (Vector& r : facet)
            if (r.z() > 0.5) r = {1 - r.x(), 1 - r.y(), r.z()};
    EXPECT_THROW(static_cast<void>(read(binaryOf(twisted), {1, Skin::Body, 0})), CaseError);
}

TEST_F(FacetSoupJoining, AHundredThousandFacetsAreSearchedForCutsInTwoSeconds)
{
    Facets const ball = facetsOf(TriSurface::sphere("ball", {0, 0, 0}, 1, 0.0155));
    expectBetween("facets", static_cast<Real>(ball.size()), 5e4, 5e5);
    auto const start = std::chrono::steady_clock::now();
    EXPECT_TRUE(read(binaryOf(ball), {1, Skin::Body, 0}).closed());
    std::chrono::duration<Real> const time = std::chrono::steady_clock::now() - start;
    expectBelow("time to read, join and search 1e5 facets [s]", time.count() * 1e5 / static_cast<Real>(ball.size()), 2);
}

TEST_F(FacetSoupJoining, BodiesInsideOutAreTurnedWithANoteAndWallsAreNot)
{
    Facets facets = facetsOf(TriSurface::box("box", {0, 0, 0}, {1, 2, 3}).flipped());
    EXPECT_NEAR(read(binaryOf(facets)).volume(), -6, 1e-12);
    EXPECT_EQ(notesOf(binaryOf(facets)), "");
    EXPECT_NEAR(readClosed(binaryOf(facets)).volume(), 6, 1e-12);
    EXPECT_NE(notesOf(binaryOf(facets), {1, Skin::Closed, 0}).find("1 of 1 shells had their normals on the inside and are turned"),
              std::string::npos);
}

TEST_F(FacetSoupJoining, ASurfaceWithOneSideOnlyIsRefused)
{
    Facets strip; // Moebius
    int const count = 12;
    auto const point = [&](int k, int side) -> Vector {
        Real const angle = 2 * std::numbers::pi * k / count, twist = angle / 2;
        Real const w = side == 0 ? -0.3 : 0.3;
        return {(1 + w * std::cos(twist)) * std::cos(angle), (1 + w * std::cos(twist)) * std::sin(angle), w * std::sin(twist)};
    };
    for (int k = 0; k < count; ++k)
    {
        bool const last = k + 1 == count;
        Vector const a = point(k, 0), b = point(k, 1), c = last ? point(0, 1) : point(k + 1, 0), d = last ? point(0, 0) : point(k + 1, 1);
        strip.push_back({a, c, d});
        strip.push_back({a, d, b});
    }
    expectRefused(textOf(strip), "has no two sides: facet", Skin::Open, 86);
}

TEST_F(FacetSoupJoining, SeveralShellsAreOneBodyUnlessTheyLieWithinEachOther)
{
    Facets two = boxFacets(), other = boxFacets({4, 0, 0}, {5, 1, 1});
    for (auto& facet : other) std::swap(facet[0], facet[1]);
    two.insert(two.end(), other.begin(), other.end());
    EXPECT_NEAR(readClosed(binaryOf(two)).volume(), 7, 1e-12);
    Facets hollow = boxFacets(), inner = boxFacets({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
    hollow.insert(hollow.end(), inner.begin(), inner.end());
    expectRefused(binaryOf(hollow), "the shell of facet 13 at (0.25 0.25 0.25) m lies within that of facet 1", Skin::Closed);
    EXPECT_NO_THROW(static_cast<void>(read(binaryOf(hollow)))) << "walls may lie within walls";
}

} // namespace
} // namespace mpsDem
