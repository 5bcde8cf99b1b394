#pragma once

#include <optional>
#include <string>

#include "core/Dictionary.h"
#include "core/State.h"
#include "particles/Lattice.h"
#include "scene/CaseConstants.h"
#include "scene/SurfaceShapes.h"

namespace mpsDem {

/// Whether what a run reads from the dictionaries of its case fits the state that it starts from. All throw CaseError (BadInput) with the
/// place of the entry and what to do: put the entry back, or run setParticles again.
///
/// | entry                                     | start from the initial state | restart from a checkpoint        |
/// |-------------------------------------------|------------------------------|----------------------------------|
/// | shape, centreOfMass                       | must be the same             | must be the same                 |
/// | mass, density, momentOfInertia, thickness | must give the same body      | taken over, with a warning       |
/// | orientation, velocity, angularVelocity    | must be the same             | of no effect: the state has them |
/// | releaseTime                               | must be there or not, as was | taken over                       |
/// | constraints, restraints, prescribedMotion | taken over where the pose and velocity at the start stay | taken over |
/// | walls of setParticlesDict                 | must be the same             | of no effect: the state has them |
/// | effective radii of mpsSchemes             | no larger than the rows of wall particles were made for | the same |
///
/// Lengths count as the same within 1e-9 of the size of the body or wall.

/// Fluid particles and bodies of the state have their dictionaries, and the bodies are those of the state.
/// @param transport, bodies  Null where the case has none.
void requireSameScene(Dictionary const* transport, Dictionary const* bodies, State const& start, GeometryContext const& context);

/// Walls of the setParticlesDict that an initial state was made from, where it says something else today. Regions are not compared.
/// @param fingerprint  Of the state (InputFingerprint.h).
void requireSameWalls(CaseFolder const& caseFolder, std::string const& fingerprint, State const& start, Lattice const& lattice);

/// Number of dimensions, spacing and thickness of the state are those of the case: other particles would explode, seem to be lost, or weigh
/// something else.
void requireSameLattice(State const& start, Lattice const& now);

/// The rows of wall and ghost particles are deep enough for the effective radii of today.
void requireDeepWalls(Dictionary const* mpsSchemes, State const& start, Lattice const& lattice);

/// The block that tells for which effective radius (over the spacing) the rows were made; absent in states of older versions.
void saveKernelRadius(State& state, std::optional<Real> overSpacing);
[[nodiscard]] std::optional<Real> loadKernelRadius(State const& state);

} // namespace mpsDem
