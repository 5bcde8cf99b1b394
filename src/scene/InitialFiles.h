#pragma once

#include <filesystem>
#include <string>

#include "scene/InitialState.h"

namespace mpsDem {

/// Fingerprint (InputFingerprint.h) of the dictionaries that an initial state is made from.
std::string inputFingerprint(CaseFolder const& caseFolder, std::filesystem::path const& setParticlesDict);

/// Builds the scene of a run from the initial state, as mpsDemFoam will do, so that all dictionaries of the case are read with its strictness.
/// Writes nothing, neither files nor to the log.
/// @throw CaseError for whatever mpsDemFoam would refuse.
void requireRunnable(CaseFolder const& caseFolder, SceneDefinition const& definition, InitialScene const& scene);

/// Writes the folder of the start time: `state.0` and `MANIFEST` (what the solver reads), then `particles.vtp` and one `<body>.vtp` a body
/// for ParaView, and `report.txt`. Each appears whole or not at all; where one cannot be written, a folder that was not there before goes again.
/// Point arrays: U p id type (0 fluid, 2 wall row, 3 ghosts; the solver labels wetted wall particles 1) body wall.
/// @throw CaseError (InputOutput)
void writeInitialFiles(CaseFolder const& caseFolder, SceneDefinition const& definition, InitialScene const& scene,
                       std::string const& report, std::string const& fingerprint);

} // namespace mpsDem
