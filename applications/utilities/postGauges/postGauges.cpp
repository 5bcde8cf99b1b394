#include <algorithm>

#include "common/CommandLine.h"
#include "core/Dictionary.h"
#include "core/Log.h"
#include "postGauges/Plot.h"
#include "postGauges/TimeSelection.h"

// postGauges: gauges, curves and pictures from what the solver wrote, as system/postGaugesDict asks for.

namespace {

using namespace mpsDem;
using namespace mpsDem::postGauges;

ApplicationDescription description()
{
    return {"postGauges",
            "Makes gauges, profiles, x-y plots and particle pictures in <case>/postProcessing/plots from the output of a run, as\n"
            "system/postGaugesDict asks for. Needs gnuplot (Debian package gnuplot-nox), but no screen.",
            {{"dict", "file", "dictionary, instead of system/postGaugesDict"},
             {"latestTime", "", "use the latest written time only"},
             {"only", "name", "make only this entry of plots"},
             {"time", "ranges", "use these written times only: '0.5,1:2,4:'"}}};
}

int work(CommandLine const& line)
{
    std::filesystem::path const root = line.caseRoot();
    require(std::filesystem::is_directory(root), Location{}, "the case folder \"" + root.string() + "\" does not exist");
    requireRanges(line.valueOr("time", ""));
    std::filesystem::path const file = root / line.valueOr("dict", "system/postGaugesDict");
    auto const dict = Dictionary::fromFile(file, root);
    dict.requireHeader();
    auto const postCase = PostCase::read(root, {line.valueOr("time", ""), line.found("latestTime")}, dict);
    auto plots = readPlots(dict, postCase.pictures);
    auto const only = line.value("only");
    std::vector<std::string> names;
    for (auto const& plot : plots) names.push_back(plot->name());
    require(!only || std::find(names.begin(), names.end(), *only) != names.end(), dict.where("plots"),
            "there is no plot \"" + only.value_or("") + "\"", knownWords("plots", only.value_or(""), names));
    if (only) std::erase_if(plots, [&](auto const& plot) { return plot->name() != *only; });
    drawPlots(plots, postCase);
    info() << "\nEnd\n" << std::flush;
    return 0;
}

} // namespace

int main(int argc, char** argv) { return mpsDem::runApplication(description(), argc, argv, work); }
