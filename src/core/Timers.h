#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace mpsDem {

/// Cost of each stage of the time loop, so that the bill at the end sums to the whole: time that went by on the clock, and time that this thread
/// was computing, which is less where others want the processor.
class Timers
{
public:
    /// Cost of one stage so far.
    struct Stage
    {
        std::string name;            ///< e.g. "pressure: solve".
        std::string effect;          ///< Effect that asked for it, e.g. "pressure", "contact".
        double seconds = 0;          ///< On the clock.
        double processorSeconds = 0; ///< Of this thread.
        std::int64_t calls = 0;
    };

    /// Adds the time between its construction and its end to one stage. Scopes must not nest.
    class Scope
    {
    public:
        explicit Scope(Stage& stage) : stage_(stage), begin_(Clock::now()), processorBegin_(processorTime()) {}
        ~Scope()
        {
            stage_.seconds += std::chrono::duration<double>(Clock::now() - begin_).count();
            stage_.processorSeconds += processorTime() - processorBegin_;
            ++stage_.calls;
        }
        Scope(Scope const&) = delete;
        Scope& operator=(Scope const&) = delete;

    private:
        using Clock = std::chrono::steady_clock;
        Stage& stage_;
        Clock::time_point begin_;
        double processorBegin_;
    };

    /// Processor time of the calling thread so far [s].
    [[nodiscard]] static double processorTime();

    /// Number of a new stage. Stages are made by constructors only: an effect that is off has none.
    static int add(std::string const& name, std::string const& effect);
    static Stage& stage(int number);
    static std::vector<Stage> const& all();
    /// Forgets all stages (tests).
    static void clear();
};

} // namespace mpsDem
