#pragma once

#include <string>

#include "core/Dictionary.h"
#include "core/Step.h"

namespace mpsDem {

/// When a function object acts: `executeControl`/`executeInterval` and `writeControl`/`writeInterval`.
///
/// | word | meaning |
/// | timeStep | every `interval` steps (default, interval 1) |
/// | runTime | at the first step at or after each multiple of `interval` seconds |
/// | adjustable, adjustableRunTime | the same, and steps are shortened to meet these times |
/// | writeTime | whenever fields are written |
/// | none | never |
/// Multiples count from t = 0 and steps from the very start, so a restarted run acts at the same times.
class TimeControl
{
public:
    /// @param prefix  "execute" or "write".
    TimeControl(Dictionary const& dict, std::string const& prefix);

    /// Whether the object acts at the end of this step.
    [[nodiscard]] bool due(Step const& step) const;
    /// The next time after t that must be met exactly, or infinity [s].
    [[nodiscard]] Real nextTime(Real t) const;

private:
    enum class Type
    {
        TimeStep,
        RunTime,
        Adjustable,
        WriteTime,
        None
    };

    Type type_;
    Real interval_;
};

} // namespace mpsDem
