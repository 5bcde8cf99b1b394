/// mpsDemFoam: resolved MPS-DEM solver for fluid, rigid bodies and their contacts.

#include <chrono>
#include <ctime>
#include <optional>

#include "common/CommandLine.h"
#include "core/Log.h"
#include "core/Timers.h"
#include "io/CaseLock.h"
#include "io/MachineMemory.h"
#include "mpsDemFoam/Progress.h"
#include "mpsDemFoam/StopRequest.h"
#include "scene/Scene.h"

namespace {

using namespace mpsDem;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// One step of the paper's method, t^m -> t^{m+1}. A stage whose effect the case does not name does nothing.
/// It may be undone and taken again with half its length: see Scene::takeStep.
void advance(Scene& scene, Step const& step)
{
    scene.moveBoundaries();       // wall particles of bodies follow their body
    scene.updateNeighbours(step); // cell grid, neighbours at r^m
    scene.label();                // number density, free surface, DBL (Fig 2)
    scene.predict(step);          // eq 2 without grad p: u*
    scene.solvePressure(step);    // eq 8: p^{m+1}
    scene.loadBodies(step);       // eqs 15-16, added mass
    scene.advanceBodies(step);    // eqs 11-12 in sub-steps of eqs 13-14
    scene.correctFluid(step);     // eq 4: u^{m+1}, r^{m+1}; collision, shifting
}

int run(CommandLine const& line)
{
    Clock::time_point const begin = Clock::now(); // of both times that the log tells
    std::clock_t const clockBegin = std::clock();
    CaseFolder const folder(line.caseRoot());
    std::optional<CaseLock> lock; // a dry run writes nothing, and the case may be read-only
    if (!line.found("dry-run")) lock.emplace(folder.root());
    info() << "Create time\n" << std::endl;
    returnLargeBlocks();
    Scene scene(folder, {.functionObjects = !line.found("noFunctionObjects")});
    if (line.found("dry-run"))
    {
        info() << "The case is valid; nothing was run (-dry-run)\n\nEnd\n" << std::endl;
        return 0;
    }
    StopRequest requests(folder.root());
    Progress progress(scene.time().time(), scene.time().endTime());
    Clock::time_point const loopBegin = Clock::now(); // with the first output, which is in the bill as well
    double const processorBegin = Timers::processorTime();
    scene.writeStart();

    info() << "Starting time loop\n" << std::endl;
    while (scene.time().running())
    {
        Step const step = scene.takeStep([&scene](Step const& wanted) { advance(scene, wanted); });
        scene.logStep(step, static_cast<double>(std::clock() - clockBegin) / CLOCKS_PER_SEC, secondsSince(begin));
        scene.observe(step); // function objects; what they tell stands behind the step in the log
        scene.writeIfDue(step);
        requests.serve(scene, secondsSince(begin));
        progress.show(scene.time().time());
    }
    progress.end();
    if (scene.time().stopping())
        scene.logStop();
    else
        scene.writeEnd();
    scene.logEnd({secondsSince(loopBegin), Timers::processorTime() - processorBegin});
    info() << "End\n" << std::endl;
    return static_cast<int>(scene.time().stopping() ? ExitCode::Stopped : ExitCode::Done);
}

} // namespace

int main(int argc, char** argv)
{
    return mpsDem::runApplication(
        {"mpsDemFoam",
         "Solves fluid flow with free surface (MPS), rigid bodies and their contacts (DEM). Runs the case from its newest state.",
         {{"noFunctionObjects", "", "run without the function objects of controlDict"},
          {"dry-run", "", "read and check the case, run nothing"}}},
        argc, argv, run);
}
