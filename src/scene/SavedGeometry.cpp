#include "scene/SavedGeometry.h"

#include <charconv>
#include <map>

#include "core/Errors.h"

namespace mpsDem {

namespace {

using Side = Polyline::FluidSide;

std::string const surfacePrefix = "surface/";
std::string const pointsSuffix = "/points";
std::string const trianglesSuffix = "/triangles";

[[noreturn]] void refuse(std::string const& what)
{
    throw CaseError(ExitCode::InputOutput, "saved state: " + what, "run setParticles again");
}

/// Left where the normal is the tangent turned by +90 degrees.
std::int64_t sideNumber(Polyline const& surface)
{
    auto const& s = surface.segments().front();
    return s.tangent.x() * s.normal.y() - s.tangent.y() * s.normal.x() > 0 ? 0 : 1;
}

void saveTriangles(State& state, std::string const& block, TriSurface const& surface)
{
    std::vector<std::int64_t> corners;
    for (auto const& triangle : surface.triangles()) corners.insert(corners.end(), triangle.corner.begin(), triangle.corner.end());
    state.set(block, std::span<std::int64_t const>(corners));
}

TriSurface loadTriangles(State const& state, std::string const& name, std::string const& points, std::string const& block)
{
    auto const& corners = state.integers(block);
    if (corners.size() % 3 != 0) refuse("block \"" + block + "\" holds no triangles");
    std::vector<TriSurface::Corners> triangles;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        triangles.push_back({static_cast<int>(corners[i]), static_cast<int>(corners[i + 1]), static_cast<int>(corners[i + 2])});
    return TriSurface(name, state.vectors(points), triangles);
}

/// Number and name in "surface/3:ramp/points".
struct BlockName
{
    int number = 0;
    std::string name;
};

BlockName parseBlockName(std::string const& block)
{
    std::string const text = block.substr(surfacePrefix.size(), block.size() - surfacePrefix.size() - pointsSuffix.size());
    auto const colon = text.find(':');
    BlockName result;
    char const* const end = text.data() + (colon == std::string::npos ? 0 : colon);
    auto const parsed = std::from_chars(text.data(), end, result.number);
    if (parsed.ec != std::errc{} || parsed.ptr != end) refuse("block \"" + block + "\" names no surface");
    result.name = text.substr(colon + 1);
    return result;
}

} // namespace

void saveSurfaces(State& state, std::vector<Surface> const& surfaces)
{
    for (std::size_t k = 0; k < surfaces.size(); ++k)
    {
        std::string const root = surfacePrefix + std::to_string(k) + ":" + surfaces[k].name();
        state.set(root + pointsSuffix, std::span<Vector const>(surfaces[k].points()));
        if (!surfaces[k].flat())
        {
            saveTriangles(state, root + trianglesSuffix, surfaces[k].triangles());
            continue;
        }
        state.set(root + "/closed", std::int64_t{surfaces[k].closed() ? 1 : 0});
        state.set(root + "/fluidSide", sideNumber(surfaces[k].line()));
    }
}

void saveOutline(State& state, std::string const& body, int index, BodyOutline const& outline)
{
    std::string const root = "body/" + body + "/";
    state.set(root + "outline", std::span<Vector const>(outline.outline.points()));
    if (!outline.outline.flat()) saveTriangles(state, root + "triangles", outline.outline.triangles());
    state.set(root + "radius", outline.radius);
    state.set(root + "index", std::int64_t{index});
}

void saveWallOf(State& state, Field<int> const& wallOf)
{
    std::vector<std::int64_t> const numbers(wallOf.begin(), wallOf.end());
    state.set("particles/wallOf", std::span<std::int64_t const>(numbers));
}

std::vector<Surface> loadSurfaces(State const& state)
{
    std::map<int, Surface> byNumber;
    for (auto const& [block, values] : state.blocks())
    {
        if (!block.starts_with(surfacePrefix) || !block.ends_with(pointsSuffix)) continue;
        BlockName const id = parseBlockName(block);
        std::string const root = block.substr(0, block.size() - pointsSuffix.size());
        if (state.has(root + trianglesSuffix))
        {
            byNumber.emplace(id.number, loadTriangles(state, id.name, block, root + trianglesSuffix));
            continue;
        }
        bool const closed = state.integer(root + "/closed") != 0;
        Side const side = state.integer(root + "/fluidSide") == 0 ? Side::Left : Side::Right;
        byNumber.emplace(id.number, Polyline(id.name, state.vectors(block), closed, side));
    }
    std::vector<Surface> surfaces;
    for (auto& [number, surface] : byNumber)
    {
        if (number != static_cast<int>(surfaces.size())) refuse("surface " + std::to_string(surfaces.size()) + " is missing");
        surfaces.push_back(std::move(surface));
    }
    return surfaces;
}

BodyOutline loadOutline(State const& state, std::string const& body)
{
    std::string const root = "body/" + body + "/";
    Real const radius = state.real(root + "radius");
    if (state.has(root + "triangles")) return {loadTriangles(state, body, root + "outline", root + "triangles"), radius};
    return {Polyline::outline(body, state.vectors(root + "outline")), radius};
}

Field<int> loadWallOf(State const& state, std::size_t boundaryParticles, std::size_t surfaces)
{
    auto const& numbers = state.integers("particles/wallOf");
    if (numbers.size() != boundaryParticles) refuse("block \"particles/wallOf\" has another length than the boundary particles");
    Field<int> wallOf;
    for (std::int64_t const k : numbers)
    {
        if (k < -1 || k >= static_cast<std::int64_t>(surfaces)) refuse("block \"particles/wallOf\" names a surface that does not exist");
        wallOf.push_back(static_cast<int>(k));
    }
    return wallOf;
}

} // namespace mpsDem
