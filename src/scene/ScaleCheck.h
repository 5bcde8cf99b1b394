#pragma once

#include <string>

#include "scene/InitialState.h"

namespace mpsDem {

/// What looks as if walls and regions were given in different units, such as millimetres among metres: more than 30 wall and ghost particles
/// for each of the fluid, or walls that are 100 times as large as the fluid or a hundredth of it. Empty where nothing does, and for a case
/// without walls or fluid.
[[nodiscard]] std::string doubtfulScale(InitialScene const& scene);

} // namespace mpsDem
