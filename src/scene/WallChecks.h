#pragma once

#include <string>
#include <vector>

#include "scene/InitialState.h"

namespace mpsDem {

/// What is doubtful about the walls of a scene with fluid, a sentence for each finding; none where walls and fluid go together.
///
/// - More than two fluid particles below which, along gravity, there is neither wall nor body: they will fall out. Not asked without gravity or walls, or where a
///   periodic box lets fluid fall for ever. @throw CaseError BadInput where that is all of the fluid.
/// - The same beside them, across gravity.
/// - Open walls that face down although more of the regions lies above than below them: a floor with its normals on the wrong side.
/// - Walls of which the two sides, both in the fluid's reach, are nearer to each other than two spacings.
std::vector<std::string> doubtfulWalls(SceneDefinition const& definition, InitialScene const& scene);

} // namespace mpsDem
