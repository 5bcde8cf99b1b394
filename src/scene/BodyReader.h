#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/State.h"
#include "core/Surface.h"
#include "scene/SurfaceShapes.h"

namespace mpsDem {

/// Shape of a rigid body as the case gives it.
struct BodyShape
{
    std::string name;
    Surface outline;           ///< In space, without displacement; a disc as a polygon, a sphere as triangles.
    Real radius = 0;           ///< Of a cylinder in 2-D, of a sphere in 3-D [m]; 0 for others.
    MassProperties properties; ///< For a density of 1 kg/m3.
    Quaternion orientation;    ///< Of the body axes.
    Location where;
};

/// Reads the shapes of constant/rigidBodyProperties, `bodies { slide { shape { ... } ... } }`, in the order of the file.
///
/// | shape type | key                  | meaning                                | unit | default |
/// |------------|----------------------|----------------------------------------|------|---------|
/// | polygon    | points               | corners in any sense of rotation, in the x-y plane | m | none |
/// |            | zRange               | 3-D: low and high z of the prism over it | m  | none    |
/// | box        | min, max             | opposite corners                       | m    | none    |
/// | cylinder   | centre radius        | 2-D: a disc, its axis along z          | m    | none    |
/// |            | point1 point2 radius | 3-D: ends of the axis                  | m    | none    |
/// | sphere     | centre radius        | 3-D                                    | m    | none    |
/// | triSurfaceMesh | file             | 3-D: closed STL in constant/triSurface | -    | none    |
/// |            | scale, translate     | as for walls                           | -, m | 1, (0 0 0) |
///
/// The shape stands where the body is at the start. @throw CaseError for an unknown type (with the nearest), a polygon that crosses itself
/// or has no area, a box without size.
std::vector<BodyShape> readBodyShapes(Dictionary const& rigidBodyProperties, GeometryContext const& context);

/// The bodies at their start, in the order of the file; refuses keys that nobody knows.
std::vector<std::unique_ptr<RigidBody>> readBodies(Dictionary const& rigidBodyProperties, GeometryContext const& context, Real time);

/// The bodies of a saved state: built from the dictionary, then loaded.
/// @throw CaseError where the state was made with other bodies or another order of them.
std::vector<std::unique_ptr<RigidBody>> readBodies(Dictionary const& rigidBodyProperties, State const& state,
                                                   GeometryContext const& context);

/// The outline in body axes from the centre of mass, R^T (x - centreOfMass). It does not depend on where the body is by now.
Surface outlineInBodyAxes(BodyShape const& shape, RigidBody const& body);

/// Least width of an outline square to one of its sides [m]; of a surface of many triangles, to a hundred of them.
Real leastWidth(Surface const& outline);

} // namespace mpsDem
