#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace mpsDem {

/// What a scene simulates and what not, and why: the list at the head of the log.
class Effects
{
public:
    /// Adds a line. @param why  What switched it on or off: an entry and what it says, a default, a file that is there or not. Not empty.
    void add(std::string const& name, bool on, std::string const& why) { entries_.push_back({name, on, why}); }
    /// Writes the list to the log.
    void print(std::ostream& os) const;
    /// "name on|off" of each, for the manifest of a checkpoint.
    [[nodiscard]] std::vector<std::string> lines() const;

private:
    struct Entry
    {
        std::string name;
        bool on;
        std::string why;
    };
    std::vector<Entry> entries_;
};

/// Time on the clock and of the processor [s].
struct Cost
{
    double clock = 0, processor = 0;
};

/// The bill at the end of the log: seconds on the clock and of the processor for every stage, then for every effect, and share and microseconds
/// per particle-step of the latter. The shares sum to 100 %: what no stage counted is the line "rest".
/// @param total          Of the time loop.
/// @param particleSteps  Particles times steps, summed.
void printBill(std::ostream& os, Cost const& total, double particleSteps);

} // namespace mpsDem
