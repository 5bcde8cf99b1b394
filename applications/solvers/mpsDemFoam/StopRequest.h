#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>

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
    /// By which an edited file is known.
    struct Stamp
    {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(Stamp const&) const = default;
    };
    /// @param error  Set where the file cannot be looked at.
    [[nodiscard]] Stamp stampOfControl(std::error_code& error) const;
    void rereadControl(Scene& scene);

    std::filesystem::path root_, stopFile_, controlFile_;
    Stamp read_, seen_; ///< Of controlDict when it was read, and at the last look: a file that is still being written is left alone.
};

} // namespace mpsDem
