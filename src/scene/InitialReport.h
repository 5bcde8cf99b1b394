#pragma once

#include <optional>
#include <string>

#include "core/Dictionary.h"
#include "scene/InitialChecks.h"
#include "scene/InitialState.h"

namespace mpsDem {

/// What the bodies of a case can do at the start, for one of them.
struct BodyOutlook
{
    Real submergedWeight = 0; ///< W' = (m - rho V) |g| [N]: negative where the body floats.
    Gap support;              ///< Nearest wall.
    Real slope = 0;           ///< Angle of the wall below it against the horizontal [rad].
    Real friction = -1;       ///< Coefficient of the pair; -1 where none is known.
    Real drive = 0;           ///< W' sin(slope) [N].
    Real resistance = 0;      ///< mu W' cos(slope) [N].
};

/// @param contactProperties  Of the case, for mu; none where the case has no contact.
BodyOutlook bodyOutlook(SceneDefinition const& definition, InitialScene const& scene, std::size_t body,
                        std::optional<Dictionary> const& contactProperties);

/// The report of setParticles: counts, volume and mass of the fluid against the geometry, and each body with its submerged weight, whether it
/// floats or can slide, and its gaps. Warnings go through warn() as well.
std::string initialReport(SceneDefinition const& definition, InitialScene const& scene, std::optional<Dictionary> const& contactProperties);

} // namespace mpsDem
