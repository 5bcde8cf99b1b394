#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "io/StlFile.h"
#include "support/Measured.h"
#include "support/StlSample.h"

namespace mpsDem {
namespace {

using namespace mpsDem::test;

class StlFile : public StlSample
{};

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
    expectRefused("", "empty");
    expectRefused("hello", "do not begin with the word solid");
    expectRefused(good.substr(0, 83), "no STL file");
    expectRefused(good.substr(0, good.size() - 1), "no STL file: 683 bytes, but the 12 facets that it announces need 684");
    expectRefused(good + "x", "no STL file: 685 bytes");
    expectRefused(binaryOf({}), "holds no facet");
    std::string many = good;
    std::memset(many.data() + 80, 0xff, 4);
    expectRefused(many, "4294967295 facets that it announces need 214748364834");
    expectRefused(binaryOf(boxFacets(), "solid").substr(0, 500), "no STL file: 500 bytes");
    expectRefused("solid empty\nendsolid empty\n", "holds no facet");
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
    expectRefused(changed("vertex", "vertx", 5), "\"vertx\" in facet 2", Skin::Open, 12);
    expectRefused(changed("endloop", "vertex 0 0 0 endloop", 3), "\"vertex\" in facet 3", Skin::Open, 21);
    expectRefused(changed("vertex 0 ", "vertex O ", 4), "\"O\" in facet 2", Skin::Open, 11);
    expectRefused(changed("vertex 0 ", "vertex 0,5 ", 4), "a number", Skin::Open, 11);
    expectRefused(changed("vertex 0 ", "vertex 1e999 ", 4), "a number", Skin::Open, 11);
    expectRefused(changed("vertex 0 ", "vertex nan ", 4), "facet 2 has a corner that is not finite", Skin::Open, 9);
    expectRefused(changed("vertex 0 ", "vertex 1e30 ", 4), "facet 2 has a corner at (1e+30", Skin::Open, 9);
    expectRefused(changed("endsolid box\n", ""), "the file ends in facet 13", Skin::Open, 86);
    expectRefused(text.substr(0, text.size() / 2), "\"endf\" in facet 6", Skin::Open, 43);
    expectRefused(text + "rubbish", "\"rubbish\" in facet 13", Skin::Open, 87);
}

TEST_F(StlFile, CornersThatAreNotNumbersAreRefusedWithTheFacet)
{
    for (Real const bad : {std::nan(""), std::numeric_limits<Real>::infinity(), 3e9})
    {
        Facets facets = boxFacets();
        facets[6][1].y() = bad;
        expectRefused(binaryOf(facets), "facet 7 has a corner");
    }
    expectRefused(binaryOf(Facets(3, {Vector(1, 1, 1), Vector(1, 1, 1), Vector(1, 1, 1)})), "measures 0 m");
    expectRefused(binaryOf(Facets(1, {Vector(0, 0, 0), Vector(0, 0, 0), Vector(1, 1, 1)})), "no facet with an area");
    expectRefused(binaryOf(Facets(1, {Vector(0, 0, 0), Vector(0.5, 0.5, 0.5), Vector(1, 1, 1)})), "no facet with an area");
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

TEST_F(StlFile, SeveralSolidsOfAFileAreTakenAsOneSurfaceWithANote)
{
    std::string const two = textOf(boxFacets()) + textOf(boxFacets({5, 0, 0}, {6, 1, 1}));
    EXPECT_NE(notesOf(two, {1, Skin::Closed, 0}).find("the 2 solids of this file are taken as one surface, \"box\""), std::string::npos);
    EXPECT_EQ(read(two).triangles().size(), 24u);
    EXPECT_EQ(notesOf(textOf(boxFacets()), {1, Skin::Closed, 0}).find("solids"), std::string::npos);
}

TEST_F(StlFile, ShellsThatDoNotTouchAreTakenAsOneSolidWithANote)
{
    Facets facets = boxFacets();
    Facets const other = boxFacets({5, 0, 0}, {6, 1, 1});
    facets.insert(facets.end(), other.begin(), other.end());
    EXPECT_NE(notesOf(binaryOf(facets), {1, Skin::Closed, 0}).find("its 2 shells, which do not touch, are taken as one solid"),
              std::string::npos);
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
