#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/State.h"
#include "core/Surface.h"
#include "particles/ParticleSet.h"
#include "scene/BodyReader.h"
#include "scene/CaseConstants.h"
#include "scene/FluidFilling.h"
#include "scene/GeometryReader.h"
#include "scene/Region.h"
#include "scene/SavedGeometry.h"

namespace mpsDem {

/// What a case's dictionaries say before any particle exists.
struct SceneDefinition
{
    Lattice lattice;
    Real kernelRadius = 2.1; ///< Largest effective radius over the spacing.
    PeriodicImages periodic; ///< The periodic box.
    Vector gravity = Vector::Zero();
    Real density = 0; ///< Of the fluid [kg/m3]; 0 without fluid.
    Real startTime = 0;
    std::vector<WallDefinition> walls;
    std::vector<BodyShape> shapes;
    std::vector<std::unique_ptr<RigidBody>> bodies;
    std::vector<std::unique_ptr<Region>> regions;
    LatticePlacement placement;
    bool hydrostatic = true;      ///< Pressure of the still fluid at the start; else 0.
    bool hasSurfaceLevel = false; ///< A free surface was given ...
    Real surfaceLevel = 0;        ///< ... at this height against gravity [m].
};

/// Reads all dictionaries that setParticles needs; refuses what is wrong with its place.
/// @param dictionary  setParticlesDict, relative to the case or absolute.
SceneDefinition readSceneDefinition(CaseFolder const& caseFolder, std::filesystem::path const& dictionary);

/// The particles of a case at its start, and all that goes with them.
struct InitialScene
{
    ParticleSet particles;
    Field<int> wallOf;                 ///< Number of the wall of each boundary particle; -1 on bodies.
    std::vector<Surface> surfaces;     ///< Walls.
    std::vector<BodyOutline> outlines; ///< In body axes.
    std::vector<Surface> placed;       ///< The same in space.
    FluidFilling fluid;

    /// All blocks of the initial state.
    [[nodiscard]] State state(SceneDefinition const& definition) const;
};

/// Lays out walls, bodies and fluid; refuses regions without a particle and bodies that cross walls or each other.
InitialScene makeInitialScene(SceneDefinition const& definition);

/// Pressure of still fluid, p = rho g h with the depth h below the free surface, measured against gravity [Pa]. The surface is the one given,
/// else the top of the regions above r. 0 without gravity, above the surface or outside of all regions.
Real hydrostaticPressure(SceneDefinition const& definition, Vector const& r);

} // namespace mpsDem
