#pragma once

#include <string>
#include <vector>

#include "core/State.h"
#include "core/Surface.h"
#include "core/Types.h"

namespace mpsDem {

/// What setParticles hands on beside particles and bodies: surfaces of walls and outlines of bodies, as blocks of the state.
///
/// | block                              | content                                                         |
/// |------------------------------------|-----------------------------------------------------------------|
/// | surface/<k>:<name>/points          | corners of wall k [m]                                           |
/// | surface/<k>:<name>/closed          | of a line: 1 for a closed chain                                 |
/// | surface/<k>:<name>/fluidSide       | of a line: 0 left, 1 right                                      |
/// | surface/<k>:<name>/triangles       | of a surface of triangles: three numbers of points each         |
/// | particles/wallOf                   | for each boundary particle the number k of its wall; -1: a body |
/// | body/<name>/outline                | corners in body axes from the centre of mass [m]                |
/// | body/<name>/triangles              | 3-D: three numbers of corners each                              |
/// | body/<name>/radius                 | of a cylinder in 2-D, a sphere in 3-D [m]; 0 for other shapes   |
/// | body/<name>/index                  | number of the body, as in particles/body                        |
/// | time/value, time/step              | [s] and number of steps done                                    |

/// Outline of a body in body axes.
struct BodyOutline
{
    Surface outline;
    Real radius = 0; ///< Of a cylinder in 2-D, of a sphere in 3-D [m]; 0 for other shapes.
};

/// Write the blocks of the walls, of a body with its number, and of the wall of each boundary particle.
void saveSurfaces(State& state, std::vector<Surface> const& surfaces);
void saveOutline(State& state, std::string const& body, int index, BodyOutline const& outline);
void saveWallOf(State& state, Field<int> const& wallOf);

/// Walls in the order of `wallOf`, with their names; empty where the case has none.
std::vector<Surface> loadSurfaces(State const& state);
/// @throw CaseError (InputOutput) where the state has no such body.
BodyOutline loadOutline(State const& state, std::string const& body);
/// @throw CaseError (InputOutput) where its length is not that of the boundary particles or a number is out of range.
Field<int> loadWallOf(State const& state, std::size_t boundaryParticles, std::size_t surfaces);

} // namespace mpsDem
