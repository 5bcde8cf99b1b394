#include "postGauges/PostCase.h"

#include "core/Log.h"
#include "core/dictionary/Reader.h"
#include "io/OutputFile.h"

namespace mpsDem::postGauges {

namespace fs = std::filesystem;

PostCase PostCase::read(fs::path root, TimeOptions times, Dictionary const& dict)
{
    PostCase result;
    result.root = std::move(root);
    result.times = std::move(times);
    result.pictures = PictureSettings::read(dict, {});
    fs::path const properties = result.root / "constant" / "particleProperties";
    if (fs::exists(properties))
    {
        auto const particles = Dictionary::fromFile(properties, result.root);
        result.spacing = particles.getInRangeOr("spacing", 0, 1e-12, 1e12);
        result.dimensions = particles.getOr("dimensions", 2);
    }
    fs::path const gravity = result.root / "constant" / "g";
    Vector g = Vector::Zero();
    if (fs::exists(gravity)) g = Dictionary::fromFile(gravity, result.root).getDimensionedVector("value", {0, 1, -2, 0, 0, 0, 0});
    if (g.norm() > 0) result.up = -g.normalized();
    result.spacing = dict.getInRangeOr("spacing", result.spacing, result.spacing > 0 ? 1e-12 : 0, 1e12);
    result.dimensions = dict.getOr("dimensions", result.dimensions);
    require(result.dimensions == 2 || result.dimensions == 3, dict.where("dimensions"), "dimensions must be 2 or 3");
    return result;
}

Real PostCase::requireSpacing() const
{
    require(spacing > 0, Location{(root / "constant" / "particleProperties").string(), 0, {}}, "the particle spacing is not known",
            "spacing <m>; here or in system/postGaugesDict");
    return spacing;
}

std::string PostCase::shown(fs::path const& path) const
{
    fs::path const relative = path.lexically_normal().lexically_relative(root.lexically_normal());
    bool const inside = !relative.empty() && *relative.begin() != "..";
    return inside ? relative.string() : path.lexically_normal().string();
}

fs::path findTable(fs::path const& root, std::string const& path)
{
    fs::path const given = root / path;
    fs::path below;
    bool leaves = false;
    for (fs::path const& part : fs::path(path).lexically_normal())
        if (below.empty() && part == "..")
            leaves = true;
        else
            below /= part;
    fs::path const etc = dictionary::etcFolder();
    std::error_code error;
    if (!leaves) return given;
    if (fs::is_regular_file(root / below, error)) return root / below;
    if (fs::is_regular_file(given, error) || etc.empty()) return given;
    fs::path const shipped = etc.parent_path() / "tutorials" / below;
    return fs::is_regular_file(shipped, error) ? shipped : given;
}

void writeTable(PostCase const& postCase, std::string const& fileName, std::string const& contents)
{
    fs::path const path = postCase.plots() / fileName;
    atomicWrite(path, contents, Durability::Process);
    info() << "    " << postCase.shown(path) << '\n';
}

void render(PostCase const& postCase, Picture& picture)
{
    for (fs::path const& path : picture.render()) info() << "    " << postCase.shown(path) << '\n';
    info() << std::flush;
}

} // namespace mpsDem::postGauges
