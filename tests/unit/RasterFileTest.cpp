#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/RasterFile.h"
#include "support/Measured.h"
#include "support/TemporaryFolder.h"

namespace mpsDem {
namespace {

std::string const head = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -9999\n";
std::string const heights = "4 5 6\n1 2 3.5\n"; // the northern row first

class RasterFile : public ::testing::Test
{
protected:
    TriSurface read(std::string const& text, RasterOptions const& options = {})
    {
        std::ofstream(path_, std::ios::binary) << text;
        return readRaster(path_, "bed", options);
    }
    void refuses(std::string const& text, std::string const& fragment, int line)
    {
        try
        {
            static_cast<void>(read(text));
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
    static bool has(TriSurface const& surface, Vector const& r)
    {
        for (Vector const& q : surface.points())
            if ((q - r).norm() < 1e-12) return true;
        return false;
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "bed.asc";
};

TEST_F(RasterFile, HeightsStandInTheMiddlesOfTheirCellsNorthFirst)
{
    TriSurface const bed = read(head + heights);
    EXPECT_EQ(bed.points().size(), 20u) << "6 and 14 around them";
    EXPECT_EQ(bed.triangles().size(), 24u);
    EXPECT_TRUE(has(bed, {105, 205, 1}));
    EXPECT_TRUE(has(bed, {125, 205, 3.5}));
    EXPECT_TRUE(has(bed, {105, 215, 4}));
    EXPECT_TRUE(has(bed, {125, 215, 6}));
    for (auto const& t : bed.triangles()) EXPECT_GT(t.normal.z(), 0.8);
}

TEST_F(RasterFile, TheSurfaceCoversTheCellsInALineWithTheLastHeights)
{
    TriSurface const bed = read(head + heights);
    EXPECT_EQ(bed.low().head<2>(), Vector(100, 200, 0).head<2>());
    EXPECT_EQ(bed.high().head<2>(), Vector(130, 220, 0).head<2>());
    EXPECT_TRUE(has(bed, {100, 205, 0.5}));
    EXPECT_TRUE(has(bed, {130, 205, 4.25}));
    EXPECT_TRUE(has(bed, {115, 200, 0.5}));
    EXPECT_TRUE(has(bed, {100, 200, -1})) << "the corner";
    TriSurface const flat = read("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n1 -9 1\n1 1 1\n");
    EXPECT_EQ(flat.low(), Vector(0, 0, 1)) << "beside a missing height the last one is continued";
    EXPECT_EQ(flat.high(), Vector(3, 2, 1));
}

TEST_F(RasterFile, HeightsFarOffTheOthersAreRefusedOrWarnedOf)
{
    auto const grid = [](std::string const& none, std::string const& odd, Real slope) {
        std::ostringstream text;
        text << "ncols 10\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 100\nNODATA_value " << none << "\n";
        for (int row = 0; row < 6; ++row)
            for (int column = 0; column < 10; ++column)
                text << (row == 2 && column == 3 ? odd : std::to_string(5 + slope * column)) << (column == 9 ? '\n' : ' ');
        return text.str();
    };
    refuses(grid("-32768", "-9999", 1), "height -9999 in row 3, column 4 is far off the others", 9);
    refuses(grid("-9999", "-9999.0001", 0), "height -9999", 9);
    refuses(grid("-9999", "1e5", 0), "height 100000 in row 3, column 4", 9);
    auto const warnings = [&](std::string const& text) {
        int const before = warningCount();
        static_cast<void>(read(text));
        return warningCount() - before;
    };
    EXPECT_EQ(warnings(grid("-9999", "400", 1)), 1) << "a spike";
    EXPECT_EQ(warnings(grid("-9999", "400", 1)), 0) << "said once";
    EXPECT_EQ(warnings(grid("-9999", "50", 1)), 0) << "a rock";
    EXPECT_EQ(warnings(grid("-9999", "400", 0)), 0) << "a tower on flat ground";
    EXPECT_EQ(warnings(grid("-9999", "-9999", 1)), 1) << "a hole";
}

TEST_F(RasterFile, EntriesMayStandInAnyOrderAndNameCentres)
{
    TriSurface const bed = read("NROWS 2\r\nNCOLS 3\r\nCELLSIZE +1e1\r\nyllcenter 205\r\nxllcenter 105\r\n" + heights);
    EXPECT_EQ(bed.points(), read(head + heights).points());
    EXPECT_EQ(read(head + "4 5 6 1 2 3.5").points(), bed.points()) << "lines of any length";
}

TEST_F(RasterFile, AxesOriginAndScale)
{
    RasterOptions options;
    options.origin = {100, 200, 1};
    options.scale = 0.1;
    EXPECT_TRUE(has(read(head + heights, options), {2.5, 0.5, 0.25}));
    options.up = RasterOptions::Up::Y;
    TriSurface const bed = read(head + heights, options);
    EXPECT_TRUE(has(bed, {2.5, 0.25, -0.5})) << "x east, y up, z south";
    for (auto const& t : bed.triangles()) EXPECT_GT(t.normal.y(), 0.8);
    EXPECT_NEAR((bed.high() - bed.low()).z(), 2, 1e-12);
}

TEST_F(RasterFile, MissingHeightsLeaveHoles)
{
    std::string const grid = "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -1\n";
    EXPECT_EQ(read(grid + "0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n").triangles().size(), 50u);
    TriSurface const corner = read(grid + "-1 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n");
    EXPECT_EQ(corner.triangles().size(), 50u - 7u);
    EXPECT_EQ(corner.points().size(), 36u - 4u);
    test::expectBelow("area with a corner missing", corner.area() - (16 - 0.25 - 2 * 0.5 - 0.5), 1e-12);
    TriSurface const hole = read(grid + "0 0 0 0\n0 -1 -1 0\n0 0 0 0\n0 0 0 0\n");
    EXPECT_EQ(hole.triangles().size(), 50u - 6u * 2u + 4u);
    EXPECT_FALSE(hole.closed());
    std::string const nan = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value nan\n";
    EXPECT_EQ(read(nan + "0 nan 0 0").triangles().size(), 1u + 2u * 5u);
}

TEST_F(RasterFile, SquaresAreCutAlongTheFlatterDiagonal)
{
    std::string const grid = "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n";
    // A ridge from south-west to north-east, then one from south-east to north-west: both stay ridges.
    for (std::string const& text : {grid + "0 1\n1 0.2\n", grid + "1 0\n0.2 1\n"})
    {
        TriSurface const square = read(text);
        Real turn = 0; // of the edge between two samples
        auto const sample = [&](int k) {
            Vector const& r = square.points()[static_cast<std::size_t>(k)];
            return r.x() * (1 - r.x()) == 0 && r.y() * (1 - r.y()) == 0;
        };
        for (auto const& edge : square.edges())
            if (sample(edge.a) && sample(edge.b) && edge.turn > turn) turn = edge.turn;
        EXPECT_GT(turn, 0.5);
    }
}

TEST_F(RasterFile, EveryNthSample)
{
    std::ostringstream text;
    text << "ncols 11\nnrows 7\nxllcenter 0\nyllcenter 0\ncellsize 2\n";
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 11; ++column) text << 0.1 * column - 0.2 * row << ' ';
    RasterOptions options;
    options.every = 3;
    TriSurface const bed = read(text.str(), options);
    EXPECT_EQ(bed.points().size(), 6u * 5u);
    EXPECT_EQ(bed.patches(), 1) << "a plane stays one";
    EXPECT_EQ((bed.high() - bed.low()).x(), 22) << "all cells, also those behind the last sample";
    EXPECT_EQ((bed.high() - bed.low()).y(), 14);
    EXPECT_EQ(bed.low().y(), -1);
    EXPECT_NEAR(bed.high().z(), 0.1 * 10.5 + 0.2 * 0.5, 1e-12);
    options.every = 7;
    EXPECT_THROW(read(text.str(), options), CaseError) << "one row is left";
    options.every = 0;
    EXPECT_THROW(read(text.str(), options), CaseError);
}

TEST_F(RasterFile, WrongHeadersAreRefusedWithTheirLine)
{
    auto const with = [](std::string const& line, std::string const& other) {
        std::string text = head + heights;
        return text.replace(text.find(line), line.size(), other);
    };
    refuses(with("ncols 3", "ncol 3"), "did you mean ncols?", 1);
    refuses(with("ncols 3", "ncols three"), "\"three\" behind ncols", 1);
    refuses(with("ncols 3", "ncols 2.5"), "ncols 2.5", 1);
    refuses(with("nrows 2", "nrows -2"), "nrows -2", 2);
    refuses(with("nrows 2", "nrows 1000000"), "3e+06 heights are announced", 2);
    refuses(with("nrows 2", "nrows nan"), "nrows nan", 2);
    refuses(with("nrows 2\n", ""), "no nrows", 6);
    refuses(with("nrows 2", "ncols 2"), "ncols is given twice", 2);
    refuses(with("cellsize 10", "cellsize 0"), "cellsize 0", 5);
    refuses(with("cellsize 10", "cellsize inf"), "cellsize inf", 5);
    refuses(with("xllcorner 100", "xllcorner 1e99"), "xllcorner 1e+99", 3);
    refuses(with("xllcorner 100", "xllcorner 100 xllcenter 105"), "both given", 3);
    refuses(with("yllcorner 200\n", ""), "no yllcorner", 6);
    refuses("", "no ncols", 1);
}

// As many heights as are announced, but a row of the header is not a line of the file.
TEST_F(RasterFile, ExchangedCountsAreWarnedOf)
{
    auto const warnings = [&](std::string const& counts, std::string const& rows) {
        int const before = warningCount();
        static_cast<void>(read(counts + "xllcorner 0\nyllcorner 0\ncellsize 10\n" + rows));
        return warningCount() - before;
    };
    std::string const twoRows = "4 5 6\n1 2 3\n", oneLine = "4 5 6 1 2 3\n", wrapped = "4 5\n6\n1 2\n3\n";
    EXPECT_EQ(warnings("ncols 3\nnrows 2\n", twoRows), 0);
    EXPECT_EQ(warnings("ncols 2\nnrows 3\n", twoRows), 1);
    EXPECT_EQ(warnings("ncols 3\nnrows 2\n", oneLine), 0) << "the whole raster in one line";
    EXPECT_EQ(warnings("ncols 3\nnrows 2\n", wrapped), 0) << "rows that go on in the next line";
}

TEST_F(RasterFile, WrongHeightsAreRefusedWithTheirPlace)
{
    refuses(head + "4 5 6\n1 2\n", "the file ends instead of the height in row 2, column 3", 9);
    refuses(head + "4 5 6\n1 two 3\n", "\"two\" instead of the height in row 2, column 2", 8);
    refuses(head + "4 5 6\n1 nan 3\n", "height nan in row 2, column 2", 8);
    refuses(head + "4 5 6\n1 1e30 3\n", "height 1e+30 in row 2, column 2", 8);
    refuses(head + heights + "7\n", "\"7\" behind the last height", 9);
    refuses(head + "-9999 5 -9999\n-9999 2 -9999\n", "no square of heights", 0);
    try
    {
        static_cast<void>(readRaster(folder_ / "no.asc", "no"));
        ADD_FAILURE();
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::InputOutput);
    }
}

TEST_F(RasterFile, BrokenFilesEitherLoadOrAreRefused)
{
    std::mt19937_64 generator(3);
    std::string const good = head + heights;
    int refused = 0;
    for (int k = 0; k < 500; ++k)
    {
        std::string text = good;
        for (int n = 0; n < 1 + k % 3; ++n)
            text[generator() % text.size()] = static_cast<char>(k % 2 == 0 ? '0' + generator() % 12 : generator());
        if (k % 5 == 0) text.resize(generator() % text.size());
        try
        {
            EXPECT_FALSE(read(text).triangles().empty());
        }
        catch (CaseError const& error)
        {
            EXPECT_EQ(error.code(), ExitCode::BadInput) << error.what();
            ++refused;
        }
    }
    test::expectBetween("broken rasters refused, of 500", refused, 150, 499);
}

} // namespace
} // namespace mpsDem
