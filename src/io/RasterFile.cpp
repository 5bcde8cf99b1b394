#include "io/RasterFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/Errors.h"
#include "io/OutputFile.h"
#include "io/RasterSamples.h"
#include "io/TextWords.h"

namespace mpsDem {

namespace {

constexpr Real farthest = 1e9; ///< Coordinates and heights, magnitude.

/// Words of the header, as they are written in messages.
std::vector<std::string> const keys{"ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "nodata_value"};

struct Header
{
    int columns = 0, rows = 0;
    Real west = 0, south = 0; ///< Middle of the lowest, leftmost cell.
    Real cell = 0;
    Real missing = -9999;
};

class Reader
{
public:
    Reader(std::string_view text, std::filesystem::path const& file) : words_(text), size_(text.size()), file_(file.string()) {}

    Header readHeader()
    {
        for (words_.next(); !words_.done() && !words_.number(); words_.next()) readEntry();
        Header header;
        header.columns = count("ncols");
        header.rows = count("nrows");
        Real const cells = static_cast<Real>(header.columns) * header.rows;
        check(2 * cells <= static_cast<Real>(size_) + 1, at("nrows"),
              shortNumber(cells) + " heights are announced in a file of " + std::to_string(size_) + " bytes", "ncols times nrows heights");
        header.cell = value("cellsize");
        check(header.cell > 0 && header.cell <= farthest, at("cellsize"), "cellsize " + shortNumber(header.cell), "a number above 0");
        header.west = lowest("xllcorner", "xllcenter", header.cell);
        header.south = lowest("yllcorner", "yllcenter", header.cell);
        if (auto const found = entries_.find("nodata_value"); found != entries_.end()) header.missing = found->second.value;
        return header;
    }

    /// The next height; none where it is missing.
    std::optional<Real> height(Header const& header, int row, int column)
    {
        auto const number = words_.number();
        if (!number)
            fail(words_.line(),
                 words_.shown() + " instead of the height in row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1),
                 words_.done() ? "ncols times nrows heights; the file is cut off" : "a number");
        bool const missing = *number == header.missing || (std::isnan(*number) && std::isnan(header.missing));
        check(missing || std::abs(*number) <= farthest, words_.line(),
              "height " + shortNumber(*number) + " in row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1),
              "a number within 1e9, or NODATA_value");
        words_.next();
        return missing ? std::optional<Real>() : number;
    }

    /// Of the next height.
    [[nodiscard]] int line() const { return words_.line(); }

    void finish() const { check(words_.done(), words_.line(), words_.shown() + " behind the last height", "ncols times nrows heights"); }

    [[noreturn]] void fail(int line, std::string const& what, std::string const& allowed) const
    {
        throw CaseError(ExitCode::BadInput, Location{file_, line, {}}, what, allowed);
    }
    void check(bool condition, int line, std::string const& what, std::string const& allowed) const
    {
        if (!condition) fail(line, what, allowed);
    }

private:
    struct Entry
    {
        Real value;
        int line;
    };

    void readEntry()
    {
        int const line = words_.line();
        std::string key;
        for (std::string const& known : keys)
            if (words_.is(known)) key = known;
        check(!key.empty(), line, words_.shown() + " in the header", knownWords("words", std::string(words_.word().substr(0, 30)), keys));
        words_.next();
        auto const number = words_.number();
        check(number.has_value(), words_.line(), words_.shown() + " behind " + key, "a number");
        bool const isNew = entries_.emplace(key, Entry{*number, line}).second;
        check(isNew, line, key + " is given twice", "once");
    }

    [[nodiscard]] int at(std::string const& key) const { return entries_.at(key).line; }

    [[nodiscard]] Real value(std::string const& key) const
    {
        auto const found = entries_.find(key);
        check(found != entries_.end(), words_.line(), "the header has no " + key,
              "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize and maybe NODATA_value before the heights");
        return found->second.value;
    }

    [[nodiscard]] int count(std::string const& key) const
    {
        Real const number = value(key);
        check(number >= 1 && number <= 1e6 && number == std::floor(number), at(key), key + " " + shortNumber(number),
              "a whole number from 1 to 1e6");
        return static_cast<int>(number);
    }

    [[nodiscard]] Real lowest(std::string const& corner, std::string const& centre, Real cell) const
    {
        bool const both = entries_.count(corner) + entries_.count(centre) == 2;
        check(!both, both ? at(centre) : 0, corner + " and " + centre + " are both given", "one of them");
        bool const atCentre = entries_.count(centre) > 0;
        std::string const& key = atCentre ? centre : corner;
        Real const number = value(key);
        check(std::abs(number) <= farthest, at(key), key + " " + shortNumber(number), "a number within 1e9");
        return atCentre ? number : number + cell / 2;
    }

    TextWords words_;
    std::size_t size_;
    std::string file_;
    std::map<std::string, Entry> entries_;
};

RasterSamples readSamples(Reader& reader, Header const& header, int every)
{
    RasterSamples samples;
    for (int row = 0; row < header.rows; row += every) samples.south.push_back(row);
    for (int column = 0; column < header.columns; column += every) samples.east.push_back(column);
    for (int row = 0; row < header.rows; ++row)
        for (int column = 0; column < header.columns; ++column)
        {
            int const line = reader.line();
            auto const height = reader.height(header, row, column);
            if (row % every != 0 || column % every != 0) continue;
            samples.height.push_back(height.value_or(std::numeric_limits<Real>::quiet_NaN()));
            samples.line.push_back(line);
        }
    reader.finish();
    return samples;
}

/// Triangles of the square whose north-western sample is (row, column), counter-clockwise from above, by the numbers of samples.
void addSquare(RasterSamples const& samples, int row, int column, std::vector<std::array<std::size_t, 3>>& triangles)
{
    std::array<std::size_t, 4> const corner{samples.index(row + 1, column), samples.index(row + 1, column + 1),
                                            samples.index(row, column + 1),
                                            samples.index(row, column)}; // south-west, south-east, north-east, north-west
    auto const height = [&](std::size_t k) { return samples.height[corner[k % 4]]; };
    int missing = 0;
    std::size_t last = 0;
    for (std::size_t k = 0; k < 4; ++k)
        if (std::isnan(height(k)))
        {
            ++missing;
            last = k;
        }
    if (missing > 1) return;
    if (missing == 1)
    {
        triangles.push_back({corner[(last + 1) % 4], corner[(last + 2) % 4], corner[(last + 3) % 4]});
        return;
    }
    std::size_t const from = std::abs(height(0) - height(2)) <= std::abs(height(1) - height(3)) ? 0 : 1;
    triangles.push_back({corner[from], corner[from + 1], corner[from + 2]});
    triangles.push_back({corner[from], corner[from + 2], corner[(from + 3) % 4]});
}

/// Place of a sample in the scene [m].
Vector placeOf(RasterSamples const& samples, std::size_t sample, Header const& header, RasterOptions const& options)
{
    Real const south = samples.south[sample / samples.east.size()], east = samples.east[sample % samples.east.size()];
    Vector const map(header.west + east * header.cell, header.south + (header.rows - 1 - south) * header.cell, samples.height[sample]);
    Vector const r = options.scale * (map - options.origin);
    return options.up == RasterOptions::Up::Z ? r : Vector(r.x(), r.z(), -r.y());
}

std::vector<std::array<std::size_t, 3>> squaresOf(RasterSamples const& samples)
{
    std::vector<std::array<std::size_t, 3>> triangles;
    for (int row = 0; row + 1 < samples.rows(); ++row)
        for (int column = 0; column + 1 < samples.columns(); ++column) addSquare(samples, row, column, triangles);
    return triangles;
}

/// The samples that triangles use become points.
TriSurface joined(RasterSamples const& samples, std::vector<std::array<std::size_t, 3>> const& squares, Header const& header,
                  RasterOptions const& options, std::string const& name)
{
    std::vector<int> number(samples.height.size(), -1);
    std::vector<Vector> points;
    std::vector<TriSurface::Corners> triangles;
    auto const point = [&](std::size_t sample) {
        int& own = number[sample];
        if (own >= 0) return own;
        own = static_cast<int>(points.size());
        points.push_back(placeOf(samples, sample, header, options));
        return own;
    };
    triangles.reserve(squares.size());
    for (auto const& t : squares) triangles.push_back({point(t[0]), point(t[1]), point(t[2])});
    return TriSurface(name, std::move(points), triangles);
}

} // namespace

TriSurface readRaster(std::filesystem::path const& file, std::string const& name, RasterOptions const& options)
{
    Location const where{file.string(), 0, {}};
    require(std::isfinite(options.scale) && options.scale > 0, where, "scale " + shortNumber(options.scale), "a number above 0");
    require(options.every >= 1, where, "every " + std::to_string(options.every), "1 or more");
    require(options.origin.allFinite(), where, "origin is not finite", "three numbers");
    std::string const text = readBytes(file);
    Reader reader(text, file);
    Header const header = reader.readHeader();
    RasterSamples const samples = readSamples(reader, header, options.every);
    require(samples.height.size() < 500'000'000, where, "the raster has too many samples", "fewer than 500 million; take every n-th");
    checkHeights(samples, {file.string(), header.missing, std::max(header.columns, header.rows) * header.cell});
    require(!squaresOf(samples).empty(), where, "the raster has no square of heights",
            "two rows and two columns or more with heights that are not NODATA_value");
    warnOfHoles(samples, file.string());
    warnOfRowsWithinLines(samples, file.string());

    RasterSamples const covering = continued(samples, header.columns, header.rows);
    return joined(covering, squaresOf(covering), header, options, name);
}

} // namespace mpsDem
