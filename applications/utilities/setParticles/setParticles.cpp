#include <filesystem>

#include "common/CommandLine.h"
#include "core/Log.h"
#include "io/CaseLock.h"
#include "io/OutputFile.h"
#include "scene/InitialFiles.h"
#include "scene/InitialReport.h"
#include "scene/InitialState.h"
#include "scene/ScaleCheck.h"

namespace {

using namespace mpsDem;

ApplicationDescription const description{
    "setParticles",
    "Lays out the particles of a case: walls from `geometry` and `walls`, fluid from `regions` of system/setParticlesDict, bodies from\n"
    "constant/rigidBodyProperties. Writes the folder of the start time and reports counts, volumes and what the bodies can do.",
    {{"dict", "file", "dictionary to read instead of system/setParticlesDict"},
     {"overwrite", "", "go on though checkpoints of a run exist: they are removed, for they would not fit"}}};

/// Results of an earlier run continue another initial state: refused, or removed on demand.
void clearCheckpoints(std::filesystem::path const& checkpoints, bool overwrite)
{
    if (!std::filesystem::exists(checkpoints) || std::filesystem::is_empty(checkpoints)) return;
    require(overwrite, Location{}, "\"" + checkpoints.string() + "\" holds the state of a run: it would not fit new particles",
            "option -overwrite, which removes it, or another copy of the case");
    removeTree(checkpoints);
    info() << "Removed the checkpoints of the earlier run\n\n";
}

int setParticles(CommandLine const& line)
{
    CaseFolder const caseFolder(line.caseRoot());
    CaseLock const lock(caseFolder.root());
    std::filesystem::path const checkpoints = caseFolder.root() / "checkpoint";
    bool const overwrite = line.found("overwrite");
    if (!overwrite) clearCheckpoints(checkpoints, false);

    std::filesystem::path const dictionary = line.valueOr("dict", "system/setParticlesDict");
    info() << "Reading " << dictionary.string() << "\n\n";
    std::string const fingerprint = inputFingerprint(caseFolder, dictionary);
    SceneDefinition const definition = readSceneDefinition(caseFolder, dictionary);
    InitialScene const scene = makeInitialScene(definition);
    std::string const report = initialReport(definition, scene, caseFolder.readIfPresent("constant/contactProperties"));
    info() << report << '\n';
    std::string const doubt = doubtfulScale(scene);
    if (!doubt.empty()) warn(doubt);

    requireRunnable(caseFolder, definition, scene);
    if (overwrite) clearCheckpoints(checkpoints, true);
    writeInitialFiles(caseFolder, definition, scene, report, fingerprint);
    info() << "Wrote " << timeName(definition.startTime) << "/\n\nEnd\n\n";
    return 0;
}

} // namespace

int main(int argc, char** argv) { return runApplication(description, argc, argv, setParticles); }
