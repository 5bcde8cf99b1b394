#include "io/StlFile.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/OnceLog.h"
#include "io/OutputFile.h"
#include "io/StlText.h"

namespace mpsDem {

namespace {

constexpr std::size_t headSize = 84, facetSize = 50;
constexpr std::uintmax_t largestFile = 4'000'000'000;
constexpr Real mostSpacings = 2e4, fewestSpacings = 3; ///< Extents that need no second look.

static_assert(std::endian::native == std::endian::little, "STL files are little-endian");

float floatAt(std::string_view bytes, std::size_t at)
{
    float value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

std::size_t countIn(std::string_view bytes)
{
    std::uint32_t count;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

void readBinary(std::string_view bytes, FacetSoup& soup)
{
    soup.facets.resize(countIn(bytes));
    for (std::size_t f = 0; f < soup.facets.size(); ++f)
        for (std::size_t k = 0; k < 9; ++k)
            soup.facets[f][k / 3][static_cast<Eigen::Index>(k % 3)] = floatAt(bytes, headSize + facetSize * f + 12 + 4 * k);
}

/// "solid" first, blanks and a byte order mark aside, and nothing in the first bytes that text does not hold.
bool looksLikeText(std::string_view bytes)
{
    std::string_view const head = bytes.substr(0, 1024);
    for (char const c : head)
        if (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\v') return false;
    return startsAsStlText(bytes);
}

void readFacets(std::string_view bytes, FacetSoup& soup)
{
    std::size_t const size = bytes.size();
    require(size > 0, soup.file, "the file is empty", "an STL file");
    bool const hasHead = size >= headSize;
    if (hasHead && size == headSize + facetSize * countIn(bytes))
        readBinary(bytes, soup);
    else if (looksLikeText(bytes))
        readStlText(bytes, soup);
    else
        throw CaseError(ExitCode::BadInput, soup.file,
                        hasHead ? "no STL file: " + std::to_string(size) + " bytes, but the " + std::to_string(countIn(bytes)) +
                                      " facets that it announces need " + std::to_string(headSize + facetSize * countIn(bytes))
                                : "no STL file: " + std::to_string(size) + " bytes that do not begin with the word solid",
                        "84 bytes and 50 for each facet, or text that begins with solid; a file that was cut off: copy it again");
    require(!soup.facets.empty(), soup.file, "the file holds no facet", "one or more");
}

/// Millimetres taken for metres, and the digits of floats far from the origin.
void checkUnit(TriSurface const& surface, StlOptions const& options, Location const& where, bool floats)
{
    if (!(options.spacing > 0)) return;
    Real const extent = (surface.high() - surface.low()).maxCoeff() / options.spacing;
    std::string const self = where.str() + ": surface \"" + surface.name() + "\" ";
    std::string const measures = "measures " + shortNumber(extent * options.spacing, 3) + " m, " + shortNumber(extent, 3) + " spacings";
    if (extent > mostSpacings) warnOnce(self + measures + ": are its numbers millimetres (scale 0.001)?");
    if (extent < fewestSpacings) warnOnce(self + measures + ": are its numbers of another unit (scale)?");
    Real const largest = std::max(surface.low().cwiseAbs().maxCoeff(), surface.high().cwiseAbs().maxCoeff());
    Real const digit = std::ldexp(largest, -24);
    if (floats && digit > 0.01 * options.spacing)
        warnOnce(self + "lies " + shortNumber(largest, 3) + " m from the origin, where a binary file keeps no more than " +
                 shortNumber(digit, 2) + " m: move it before it is exported, or write ASCII");
}

void put(std::string& bytes, Vector const& v)
{
    Eigen::Vector3f const single = v.cast<float>();
    bytes.append(reinterpret_cast<char const*>(single.data()), 3 * sizeof(float));
}

} // namespace

TriSurface readStl(std::filesystem::path const& file, std::string const& name, StlOptions const& options)
{
    FacetSoup soup;
    soup.file = Location{file.string(), 0, {}};
    require(std::isfinite(options.scale) && options.scale > 0, soup.file, "scale " + shortNumber(options.scale), "a number above 0");
    std::error_code ignored;
    std::uintmax_t const size = std::filesystem::file_size(file, ignored);
    require(ignored || size <= largestFile, soup.file, "the file has " + std::to_string(size) + " bytes", "4 GB or less");
    {
        std::string const bytes = readBytes(file);
        readFacets(bytes, soup);
    }
    if (soup.solids > 1)
        infoOnce(soup.file.str() + ": the " + std::to_string(soup.solids) + " solids of this file are taken as one surface, \"" + name +
                 "\"");
    for (FacetSoup::Facet& facet : soup.facets)
        for (Vector& r : facet) r *= options.scale;
    TriSurface surface = joinFacets(soup, name, options.skin);
    checkUnit(surface, options, soup.file, soup.lines.empty());
    return surface;
}

void writeStl(std::filesystem::path const& file, TriSurface const& surface)
{
    std::string bytes = "binary STL of mpsDem: " + surface.name();
    bytes.resize(80, ' ');
    auto const count = static_cast<std::uint32_t>(surface.triangles().size());
    bytes.append(reinterpret_cast<char const*>(&count), sizeof count);
    bytes.reserve(headSize + facetSize * count);
    for (TriSurface::Triangle const& t : surface.triangles())
    {
        put(bytes, t.normal);
        for (int k = 0; k < 3; ++k) put(bytes, surface.point(t, k));
        bytes.append(2, '\0');
    }
    atomicWrite(file, bytes, Durability::Process);
}

} // namespace mpsDem
