#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/OutputFile.h"
#include "io/StlFile.h"
#include "support/Measured.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

using Facets = std::vector<FacetSoup::Facet>;

Facets facetsOf(TriSurface const& surface)
{
    Facets facets;
    for (auto const& t : surface.triangles()) facets.push_back({surface.point(t, 0), surface.point(t, 1), surface.point(t, 2)});
    return facets;
}

Facets boxFacets(Vector const& low = {0, 0, 0}, Vector const& high = {1, 2, 3}) { return facetsOf(TriSurface::box("box", low, high)); }

std::string binaryOf(Facets const& facets, std::string head = "box")
{
    head.resize(80, ' ');
    auto const count = static_cast<std::uint32_t>(facets.size());
    head.append(reinterpret_cast<char const*>(&count), 4);
    for (auto const& facet : facets)
    {
        head.append(12, '\0');
        for (Vector const& r : facet)
        {
            Eigen::Vector3f const single = r.cast<float>();
            head.append(reinterpret_cast<char const*>(single.data()), 12);
        }
        head.append(2, '\0');
    }
    return head;
}

std::string textOf(Facets const& facets)
{
    std::ostringstream out;
    out.precision(17);
    out << "solid box of the test\n";
    for (auto const& facet : facets)
    {
        out << "  facet normal 0 0 0\n    outer loop\n";
        for (Vector const& r : facet) out << "      vertex " << r.x() << ' ' << r.y() << ' ' << r.z() << '\n';
        out << "    endloop\n  endfacet\n";
    }
    out << "endsolid box\n";
    return out.str();
}

/// A file of its own, and what reading it says.
class StlFile : public ::testing::Test
{
protected:
    TriSurface read(std::string const& bytes, StlOptions const& options = {})
    {
        std::ofstream(path_, std::ios::binary) << bytes;
        return readStl(path_, "box", options);
    }
    TriSurface readClosed(std::string const& bytes)
    {
        StlOptions options;
        options.skin = Skin::Closed;
        return read(bytes, options);
    }
    /// What the log says while a surface is read.
    std::string notesOf(std::string const& bytes, StlOptions const& options = {})
    {
        ::testing::internal::CaptureStdout();
        ::testing::internal::CaptureStderr();
        static_cast<void>(read(bytes, options));
        std::string const warnings = ::testing::internal::GetCapturedStderr();
        return ::testing::internal::GetCapturedStdout() + warnings;
    }
    void refuses(std::string const& bytes, std::string const& fragment, Skin skin = Skin::Open, int line = 0)
    {
        try
        {
            StlOptions options;
            options.skin = skin;
            static_cast<void>(read(bytes, options));
            ADD_FAILURE() << "accepted, wanted: " << fragment;
        }
        catch (CaseError const& error)
        {
            EXPECT_EQ(error.code(), ExitCode::BadInput);
            EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
            EXPECT_EQ(error.where().file, path_.string());
            EXPECT_EQ(error.where().line, line) << error.what();
        }
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "box.stl";
};

TEST_F(StlFile, WrittenSurfaceReadsBackAsItWas)
{
    TriSurface const box = TriSurface::box("crate", {-1, 0.5, 0}, {1, 2, 3});
    writeStl(path_, box);
    EXPECT_EQ(std::filesystem::file_size(path_), 84u + 50u * 12u);
    TriSurface const again = readStl(path_, "crate");
    EXPECT_EQ(again.points().size(), 8u);
    EXPECT_EQ(again.triangles().size(), 12u);
    EXPECT_TRUE(again.closed());
    EXPECT_EQ(again.volume(), box.volume());
    EXPECT_EQ(again.patches(), 6);
    TriSurface const ball = TriSurface::sphere("ball", {10, 0, 0}, 0.5, 0.05);
    writeStl(path_, ball);
    TriSurface const same = readStl(path_, "ball", {1, Skin::Closed, 0.05});
    EXPECT_EQ(same.triangles().size(), ball.triangles().size());
    EXPECT_EQ(same.points().size(), ball.points().size());
    test::expectBelow("sphere through a file of floats, volume", same.volume() / ball.volume() - 1, 1e-6);
}

TEST_F(StlFile, TextKeepsAllDigitsOfMapCoordinates)
{
    Vector const away(500000.123456789, 4500000.987654321, 12.5);
    TriSurface const box = readClosed(textOf(boxFacets(away, away + Vector(1, 2, 3))));
    EXPECT_EQ(box.low(), away);
    test::expectBelow("volume at map coordinates", box.volume() / 6 - 1, 1e-8);
}

TEST_F(StlFile, TextMayHaveCapitalsMarksCrlfAndSeveralSolids)
{
    std::string text = textOf(boxFacets());
    std::string capitals = "\xEF\xBB\xBF  ";
    for (char const c : text) capitals += c == '\n' ? std::string("\r\n") : std::string(1, static_cast<char>(std::toupper(c)));
    EXPECT_TRUE(read(capitals).closed());
    std::string const two = text + textOf(boxFacets({5, 0, 0}, {6, 1, 1}));
    EXPECT_EQ(read(two).triangles().size(), 24u);
    EXPECT_NEAR(readClosed(two).volume(), 7, 1e-12);
}

TEST_F(StlFile, SizeDecidesThatAFileIsBinaryEvenWhereItBeginsWithSolid)
{
    EXPECT_TRUE(read(binaryOf(boxFacets(), "solid box\nfacet normal 0 0 1")).closed());
}

TEST_F(StlFile, ScaleTurnsMillimetresIntoMetres)
{
    EXPECT_NEAR(read(binaryOf(boxFacets({0, 0, 0}, {1000, 2000, 3000})), {0.001, Skin::Closed, 0}).volume(), 6, 1e-12);
    EXPECT_THROW(read(binaryOf(boxFacets()), {0, Skin::Open, 0}), CaseError);
    EXPECT_THROW(read(binaryOf(boxFacets()), {std::nan(""), Skin::Open, 0}), CaseError);
}

TEST_F(StlFile, WhatIsNoStlIsRefused)
{
    std::string const good = binaryOf(boxFacets());
    refuses("", "empty");
    refuses("hello", "do not begin with the word solid");
    refuses(good.substr(0, 83), "no STL file");
    refuses(good.substr(0, good.size() - 1), "no STL file: 683 bytes, but the 12 facets that it announces need 684");
    refuses(good + "x", "no STL file: 685 bytes");
    refuses(binaryOf({}), "holds no facet");
    std::string many = good;
    std::memset(many.data() + 80, 0xff, 4);
    refuses(many, "4294967295 facets that it announces need 214748364834");
    refuses(binaryOf(boxFacets(), "solid").substr(0, 500), "no STL file: 500 bytes");
    refuses("solid empty\nendsolid empty\n", "holds no facet");
}

TEST_F(StlFile, BadTextIsRefusedWithLineAndFacet)
{
    std::string const text = textOf(boxFacets());
    auto const changed = [&](std::string const& from, std::string const& to, std::size_t nth = 1) {
        std::size_t at = std::string::npos;
        for (std::size_t k = 0; k < nth; ++k) at = text.find(from, at + 1);
        std::string copy = text;
        return copy.replace(at, from.size(), to);
    };
    refuses(changed("vertex", "vertx", 5), "\"vertx\" in facet 2", Skin::Open, 12);
    refuses(changed("endloop", "vertex 0 0 0 endloop", 3), "\"vertex\" in facet 3", Skin::Open, 21);
    refuses(changed("vertex 0 ", "vertex O ", 4), "\"O\" in facet 2", Skin::Open, 11);
    refuses(changed("vertex 0 ", "vertex 0,5 ", 4), "a number", Skin::Open, 11);
    refuses(changed("vertex 0 ", "vertex 1e999 ", 4), "a number", Skin::Open, 11);
    refuses(changed("vertex 0 ", "vertex nan ", 4), "facet 2 has a corner that is not finite", Skin::Open, 9);
    refuses(changed("vertex 0 ", "vertex 1e30 ", 4), "facet 2 has a corner at (1e+30", Skin::Open, 9);
    refuses(changed("endsolid box\n", ""), "the file ends in facet 13", Skin::Open, 86);
    refuses(text.substr(0, text.size() / 2), "\"endf\" in facet 6", Skin::Open, 43);
    refuses(text + "rubbish", "\"rubbish\" in facet 13", Skin::Open, 87);
}

TEST_F(StlFile, CornersThatAreNotNumbersAreRefusedWithTheFacet)
{
    for (Real const bad : {std::nan(""), std::numeric_limits<Real>::infinity(), 3e9})
    {
        Facets facets = boxFacets();
        facets[6][1].y() = bad;
        refuses(binaryOf(facets), "facet 7 has a corner");
    }
    refuses(binaryOf(Facets(3, {Vector(1, 1, 1), Vector(1, 1, 1), Vector(1, 1, 1)})), "measures 0 m");
    refuses(binaryOf(Facets(1, {Vector(0, 0, 0), Vector(0, 0, 0), Vector(1, 1, 1)})), "no facet with an area");
    refuses(binaryOf(Facets(1, {Vector(0, 0, 0), Vector(0.5, 0.5, 0.5), Vector(1, 1, 1)})), "no facet with an area");
}

TEST_F(StlFile, MissingFilesAreInputOutputErrors)
{
    try
    {
        static_cast<void>(readStl(folder_ / "no.stl", "no"));
        ADD_FAILURE();
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::InputOutput);
        EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
    }
    EXPECT_THROW(static_cast<void>(readStl(folder_.path(), "folder")), CaseError);
}

TEST_F(StlFile, CornersThatAlmostMeetBecomeOnePoint)
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
    refuses(textOf(apart), "open: 4 edges belong to one facet only", Skin::Closed, 2);
}

TEST_F(StlFile, FacetsWithoutAreaGoWithANoteAndLeaveNoCrack)
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

TEST_F(StlFile, FacetsGivenTwiceGoWithANoteAndPlatesWithoutThicknessAreRefused)
{
    Facets facets = boxFacets();
    facets.push_back({facets[2][1], facets[2][2], facets[2][0]});
    std::string const notes = notesOf(binaryOf(facets));
    EXPECT_NE(notes.find("1 of 13 facets given twice left out, the first one facet 13"), std::string::npos) << notes;
    EXPECT_NEAR(readClosed(binaryOf(facets)).volume(), 6, 1e-12);
    std::swap(facets[12][0], facets[12][1]);
    refuses(binaryOf(facets), "facet 13 lies on the back of facet 3");
}

TEST_F(StlFile, OpenBodiesAreRefusedWithTheirRim)
{
    Facets facets = boxFacets();
    facets.erase(facets.begin() + 8, facets.begin() + 10);
    EXPECT_FALSE(read(binaryOf(facets)).closed());
    refuses(binaryOf(facets), "open: 4 edges belong to one facet only, the first one at (0 1 0) m to facet 2", Skin::Closed);
}

TEST_F(StlFile, EdgesOfMoreThanTwoFacetsAreRefused)
{
    Facets facets = boxFacets();
    facets.push_back({Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, -1, -1)});
    refuses(binaryOf(facets), "the edge at (0.5 0 0) m belongs to 3 facets");
}

TEST_F(StlFile, MixedWindingsAreTurnedToAgreeWithANote)
{
    Facets facets = boxFacets();
    for (std::size_t const k : {1, 6, 7}) std::swap(facets[k][0], facets[k][2]);
    std::string const notes = notesOf(binaryOf(facets));
    EXPECT_NE(notes.find("3 of 12 facets turned to agree with the others, the first one facet 2"), std::string::npos) << notes;
    EXPECT_NEAR(read(binaryOf(facets)).volume(), 6, 1e-12);
    for (auto& facet : facets) std::swap(facet[0], facet[2]); // now most of them face inwards
    EXPECT_NEAR(read(binaryOf(facets)).volume(), -6, 1e-12) << "the majority decides for a wall";
    EXPECT_NEAR(readClosed(binaryOf(facets)).volume(), 6, 1e-12);
}

TEST_F(StlFile, BodiesInsideOutAreTurnedWithANoteAndWallsAreNot)
{
    Facets facets = facetsOf(TriSurface::box("box", {0, 0, 0}, {1, 2, 3}).flipped());
    EXPECT_NEAR(read(binaryOf(facets)).volume(), -6, 1e-12);
    EXPECT_EQ(notesOf(binaryOf(facets)), "");
    EXPECT_NEAR(readClosed(binaryOf(facets)).volume(), 6, 1e-12);
    EXPECT_NE(notesOf(binaryOf(facets), {1, Skin::Closed, 0}).find("1 of 1 shells had their normals on the inside and are turned"),
              std::string::npos);
}

TEST_F(StlFile, ASurfaceWithOneSideOnlyIsRefused)
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
    refuses(textOf(strip), "has no two sides: facet", Skin::Open, 86);
}

TEST_F(StlFile, SeveralShellsAreOneBodyUnlessTheyLieWithinEachOther)
{
    Facets two = boxFacets(), other = boxFacets({4, 0, 0}, {5, 1, 1});
    for (auto& facet : other) std::swap(facet[0], facet[1]);
    two.insert(two.end(), other.begin(), other.end());
    EXPECT_NEAR(readClosed(binaryOf(two)).volume(), 7, 1e-12);
    Facets hollow = boxFacets(), inner = boxFacets({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
    hollow.insert(hollow.end(), inner.begin(), inner.end());
    refuses(binaryOf(hollow), "the shell of facet 13 at (0.25 0.25 0.25) m lies within that of facet 1", Skin::Closed);
    EXPECT_NO_THROW(static_cast<void>(read(binaryOf(hollow)))) << "walls may lie within walls";
}

TEST_F(StlFile, LikelySlipsOfTheUnitDrawAWarning)
{
    Facets const millimetres = boxFacets({0, 0, 0}, {500, 500, 550});
    EXPECT_NE(notesOf(binaryOf(millimetres), {1, Skin::Closed, 0.01}).find("measures 550 m, 5.5e+04 spacings: are its numbers millimetres"),
              std::string::npos);
    EXPECT_EQ(notesOf(binaryOf(millimetres), {0.001, Skin::Closed, 0.01}), "");
    EXPECT_NE(notesOf(binaryOf(boxFacets()), {0.001, Skin::Closed, 0.01}).find("another unit"), std::string::npos);
    Facets const map = boxFacets({5e5, 4.5e6, 0}, {5e5 + 400, 4.5e6 + 400, 100});
    EXPECT_NE(notesOf(binaryOf(map), {1, Skin::Closed, 5}).find("a binary file keeps no more than 0.27 m"), std::string::npos);
    EXPECT_EQ(notesOf(textOf(map), {1, Skin::Closed, 5}), "");
}

/// One change as a bad disk, transfer or editor makes it.
std::string mutated(std::string bytes, std::mt19937_64& generator)
{
    auto const below = [&](std::size_t n) { return static_cast<std::size_t>(generator() % n); };
    std::size_t const place = below(bytes.size()), length = std::min(1 + below(60), bytes.size() - place);
    switch (generator() % 7)
    {
    case 0:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
        break;
    case 1:
        bytes.resize(place);
        break;
    case 2:
        bytes.erase(place, length);
        break;
    case 3:
        bytes.insert(place, bytes.substr(below(bytes.size()), length));
        break;
    case 4:
        bytes.replace(place, length, bytes.substr(place / 2, length));
        break;
    case 5:
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(place), length, static_cast<char>(generator()));
        break;
    default:
        for (std::size_t k = 0; k < 20; ++k) bytes[below(bytes.size())] = static_cast<char>(generator());
    }
    return bytes;
}

TEST_F(StlFile, FiveHundredBrokenFilesEitherLoadOrAreRefused)
{
    std::array<std::string, 2> const good{binaryOf(boxFacets()), textOf(boxFacets())};
    std::mt19937_64 generator(11);
    int loaded = 0, refused = 0;
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    for (int k = 0; k < 500; ++k)
    {
        std::string bytes = mutated(good[static_cast<std::size_t>(k % 2)], generator);
        if (k % 3 == 0 && !bytes.empty()) bytes = mutated(bytes, generator);
        try
        {
            TriSurface const surface = read(bytes, {1, k % 5 < 2 ? Skin::Closed : Skin::Open, 0.1});
            EXPECT_FALSE(surface.triangles().empty());
            EXPECT_TRUE(std::isfinite(surface.area()) && surface.area() > 0);
            EXPECT_TRUE(k % 5 >= 2 || surface.volume() > 0);
            ++loaded;
        }
        catch (CaseError const& error)
        {
            EXPECT_EQ(error.code(), ExitCode::BadInput) << error.what();
            EXPECT_EQ(error.where().file, path_.string()) << error.what();
            ++refused;
        }
    }
    static_cast<void>(::testing::internal::GetCapturedStdout() + ::testing::internal::GetCapturedStderr());
    test::expectBetween("broken files refused, of 500", refused, 200, 480);
    EXPECT_EQ(loaded + refused, 500);
}

} // namespace
} // namespace mpsDem
