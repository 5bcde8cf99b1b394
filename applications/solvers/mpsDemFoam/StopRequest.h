#pragma once

#include <cstdint>
#include <filesystem>

namespace mpsDem {

class Scene;

/// What a user asks of a running case, served between two steps:
///   SIGUSR1                          writes fields and state, goes on
///   SIGUSR2, SIGTERM, SIGINT         writes the state and stops (exit code 3)
///   a file `stop` in the case folder the same; the file is removed
///   maxClockTime of controlDict      the same
///   an edited controlDict            is checked as at a start and taken over but for `functions` (Scene::takeOver); a wrong one is warned of
///                                    and changes nothing; with runTimeModifiable no it is not looked at
class StopRequest
{
public:
    /// Installs the signal handlers, which only set a flag.
    explicit StopRequest(std::filesystem::path caseRoot);
    void serve(Scene& scene, double clockSeconds);

private:
    void rereadControl(Scene& scene);

    std::filesystem::path root_, stopFile_, controlFile_;
    std::filesystem::file_time_type controlTime_;
    std::uintmax_t controlSize_;
};

} // namespace mpsDem
