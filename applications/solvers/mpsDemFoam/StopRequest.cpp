#include "mpsDemFoam/StopRequest.h"

#include <csignal>

#include "core/Log.h"
#include "scene/Scene.h"

namespace mpsDem {

namespace {

std::sig_atomic_t volatile writeSignal = 0; // the number of the signal, 0: none
std::sig_atomic_t volatile stopSignal = 0;

extern "C" void askWrite(int number) { writeSignal = number; }
extern "C" void askStop(int number) { stopSignal = number; }

std::string signalName(int number)
{
    char const* const name = number == SIGUSR1 ? "USR1" : number == SIGUSR2 ? "USR2" : number == SIGTERM ? "TERM" : "INT";
    return std::string("signal ") + name;
}

} // namespace

StopRequest::StopRequest(std::filesystem::path caseRoot)
    : root_(std::move(caseRoot)),
      stopFile_(root_ / "stop"),
      controlFile_(root_ / "system" / "controlDict")
{
    std::signal(SIGUSR1, askWrite);
    for (int const signal : {SIGUSR2, SIGTERM, SIGINT}) std::signal(signal, askStop);
    std::error_code ignored;
    read_ = seen_ = stampOfControl(ignored);
}

StopRequest::Stamp StopRequest::stampOfControl(std::error_code& error) const
{
    auto const time = std::filesystem::last_write_time(controlFile_, error);
    if (error) return {};
    return {time, std::filesystem::file_size(controlFile_, error)};
}

void StopRequest::serve(Scene& scene, double clockSeconds)
{
    if (writeSignal)
    {
        scene.writeFields();
        scene.askCheckpoint(signalName(writeSignal));
        writeSignal = 0;
    }
    if (stopSignal) scene.askStop(signalName(stopSignal));
    if (std::filesystem::remove(stopFile_)) scene.askStop("the file stop");
    Real const budget = scene.time().maxClockTime();
    if (budget > 0 && clockSeconds > budget) scene.askStop("maxClockTime");
    rereadControl(scene);
    if (scene.time().stopAsked()) scene.askStop("stopAt writeNow");
    scene.serveCheckpoint();
}

void StopRequest::rereadControl(Scene& scene)
{
    if (!scene.time().modifiable()) return;
    std::error_code error;
    Stamp const now = stampOfControl(error);
    if (error || now == read_) return;
    bool const still = now == seen_;
    seen_ = now;
    if (!still) return;
    read_ = now;
    try
    {
        Dictionary const dict = Dictionary::fromFile(controlFile_, root_);
        dict.requireHeader();
        scene.takeOver(dict);
    }
    catch (CaseError const& wrong)
    {
        warn(std::string("system/controlDict was edited but is not valid, so nothing is changed: ") + wrong.what());
    }
}

} // namespace mpsDem
