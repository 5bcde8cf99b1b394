#include "scene/SurfaceFile.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "core/Errors.h"
#include "io/RasterFile.h"
#include "io/StlFile.h"
#include "scene/EntryText.h"

namespace mpsDem {

namespace {

/// Names of the files of a folder in alphabetical order, for a message.
std::string filesIn(std::filesystem::path const& folder)
{
    std::vector<std::string> names;
    std::error_code error;
    for (auto const& entry : std::filesystem::directory_iterator(folder, error)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    std::string text;
    for (std::string const& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "no files" : text;
}

std::filesystem::path pathOf(Dictionary const& dict, std::filesystem::path const& caseFolder)
{
    std::filesystem::path const file = dict.get<std::string>("file");
    bool const leaves = file.is_absolute() || std::find(file.begin(), file.end(), "..") != file.end();
    require(!file.empty() && !leaves, dict.where("file"), "file \"" + file.string() + "\" lies outside of the case",
            "a path beneath constant/triSurface");
    return caseFolder / "constant" / "triSurface" / file;
}

void requirePresent(Dictionary const& dict, std::filesystem::path const& file)
{
    std::error_code error;
    require(std::filesystem::exists(file, error), dict.where("file"),
            "file \"" + dict.get<std::string>("file") + "\" is not in constant/triSurface", "there are: " + filesIn(file.parent_path()));
}

RasterOptions readRasterOptions(Dictionary const& dict)
{
    RasterOptions options;
    options.up = dict.getWordOr("up", "y", {"y", "z"}, "axes") == "y" ? RasterOptions::Up::Y : RasterOptions::Up::Z;
    options.origin = dict.getOr<Vector>("origin", Vector::Zero());
    require(options.origin.allFinite(), dict.where("origin"), "origin is not finite", "three numbers");
    options.every = dict.getOr<int>("every", 1);
    require(options.every >= 1, dict.where("every"), "every " + std::to_string(options.every), "1 or more");
    return options;
}

std::string endingOf(std::filesystem::path const& file)
{
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

} // namespace

TriSurface readSurfaceFile(Dictionary const& dict, std::filesystem::path const& caseFolder, std::string const& name, Skin skin,
                           Real spacing)
{
    std::filesystem::path const file = pathOf(dict, caseFolder);
    std::string const ending = endingOf(file);
    require(ending == ".stl" || ending == ".asc", dict.where("file"), "file \"" + file.filename().string() + "\" of an unknown kind",
            "a name that ends in .stl (triangles) or .asc (ESRI grid of heights)");
    require(ending == ".stl" || skin == Skin::Open, dict.where("file"), "a raster of heights is no closed surface", "an STL file");
    requirePresent(dict, file);
    Real const scale = dict.getInRangeOr("scale", 1, 1e-9, 1e9);
    if (ending == ".stl")
    {
        TriSurface surface = readStl(file, name, {scale, skin, spacing});
        if (!dict.found("translate")) return surface;
        return surface.moved(Tensor::Identity(), readPoint(dict, "translate", 3));
    }
    RasterOptions options = readRasterOptions(dict);
    options.scale = scale;
    return readRaster(file, name, options);
}

} // namespace mpsDem
