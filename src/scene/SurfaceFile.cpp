#include "scene/SurfaceFile.h"

#include <algorithm>

#include "core/Errors.h"
#include "io/RasterFile.h"
#include "io/StlFile.h"
#include "scene/EntryText.h"

namespace mpsDem {

namespace {

std::filesystem::path pathOf(Dictionary const& dict, std::filesystem::path const& caseFolder)
{
    std::filesystem::path const file = dict.get<std::string>("file");
    bool const leaves = file.is_absolute() || std::find(file.begin(), file.end(), "..") != file.end();
    require(!file.empty() && !leaves, dict.where("file"), "file \"" + file.string() + "\" lies outside of the case",
            "a path beneath constant/triSurface");
    return caseFolder / "constant" / "triSurface" / file;
}

} // namespace

TriSurface readSurfaceFile(Dictionary const& dict, std::filesystem::path const& caseFolder, std::string const& name, Skin skin,
                           Real spacing)
{
    std::filesystem::path const file = pathOf(dict, caseFolder);
    StlOptions options;
    options.scale = dict.getInRangeOr("scale", 1, 1e-9, 1e9);
    options.skin = skin;
    options.spacing = spacing;
    TriSurface surface = readStl(file, name, options);
    if (!dict.found("translate")) return surface;
    return surface.moved(Tensor::Identity(), readPoint(dict, "translate", 3));
}

TriSurface readRasterSurface(Dictionary const& dict, std::filesystem::path const& caseFolder, std::string const& name)
{
    RasterOptions options;
    options.up = dict.getWordOr("up", "y", {"y", "z"}, "axes") == "y" ? RasterOptions::Up::Y : RasterOptions::Up::Z;
    options.origin = dict.getOr<Vector>("origin", Vector::Zero());
    options.scale = dict.getInRangeOr("scale", 1, 1e-9, 1e9);
    options.every = static_cast<int>(dict.getInRangeOr("every", 1, 1, 1e6));
    return readRaster(pathOf(dict, caseFolder), name, options);
}

} // namespace mpsDem
