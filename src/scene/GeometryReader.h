#pragma once

#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Surface.h"
#include "core/Types.h"
#include "particles/Lattice.h"
#include "scene/SurfaceShapes.h"

namespace mpsDem {

/// A fixed wall of the case: a surface, and how many rows of ghosts stand behind its wall row.
struct WallDefinition
{
    Surface surface; ///< Its name is the wall's.
    int ghostRows = 0;
    Location where; ///< Place in setParticlesDict.
};

/// Reads `geometry` and `walls` of setParticlesDict.
///
/// geometry: a dictionary of surfaces. In 2-D each is a line in the plane z = 0, third components of boxes, plates and axes do not count;
/// in 3-D each is a surface of triangles.
///
/// | type               | key            | meaning                                                       | unit | default |
/// |--------------------|----------------|---------------------------------------------------------------|------|---------|
/// | polyline           | points         | corners in order, in the x-y plane                            | m    | none    |
/// |                    | zRange         | 3-D: low and high z of the strips that stand over it          | m    | none    |
/// |                    | sideWalls      | 3-D: adds the walls at both ends of zRange, closed by the line from the last to the first point; the fluid is inside | - | false |
/// |                    | closed         | joins the last to the first                                   | -    | false   |
/// |                    | fluidSide      | left or right when one walks along the points                 | -    | left    |
/// | searchableBox      | min, max       | opposite corners                                              | m    | none    |
/// |                    | open           | sides left out: left right bottom top, in 3-D also back front | -    | ()      |
/// |                    | fluidSide      | inside or outside                                             | -    | inside  |
/// | searchablePlate    | origin, span   | from origin to origin + span; 3-D: one component of span is 0 | m    | none    |
/// |                    | fluidSide      | left or right when one walks along the span                   | -    | left    |
/// |                    |                | 3-D: positive or negative side of the axis it is normal to    | -    | positive |
/// | searchableCylinder | point1, point2 | ends of the axis (2-D: along z)                               | m    | none    |
/// |                    | radius         |                                                               | m    | none    |
/// |                    | fluidSide      | inside or outside                                             | -    | outside |
/// | searchableSphere   | centre, radius | a sphere; 2-D: a disc                                         | m    | none    |
/// |                    | fluidSide      | inside or outside                                             | -    | outside |
/// | triSurfaceMesh     | file           | 3-D: STL file in constant/triSurface                          | -    | none    |
/// |                    | scale          | metres per unit of the file                                   | -    | 1       |
/// |                    | translate      | moved by, after scaling                                       | m    | (0 0 0) |
/// |                    | fluidSide      | normal or reverse: that of the facets' normals; closed: outside or inside | - | normal, outside |
///
/// | rasterSurface      | file           | 3-D: heights as ESRI ASCII grid in constant/triSurface        | -    | none    |
/// |                    | up, origin, scale, every | see SurfaceFile.h                                   |      |         |
/// |                    | fluidSide      | above or below                                                | -    | above   |
///
/// walls: a list of `{ name; surface; thickness; side; }`. Without `walls` each surface is a wall.
///
/// | key       | meaning                                                            | unit | default         |
/// |-----------|--------------------------------------------------------------------|------|-----------------|
/// | name      | name of the wall in all that follows                               | -    | that of surface |
/// | surface   | an entry of geometry                                               | -    | none            |
/// | thickness | auto, or a length: of the layer of wall and ghost particles        | m    | auto            |
/// | side      | fluidSide, where it shall differ from the surface's                | -    | the surface's   |
///
/// auto means one wall row and ceil(r_e / l0 - 1/2) rows of ghosts for the largest effective radius r_e.
/// @param radius  r_e / l0.
/// @throw CaseError for an unknown type, surface or side (with the nearest), a surface that is no line or shorter than a spacing.
std::vector<WallDefinition> readWalls(Dictionary const& setParticlesDict, GeometryContext const& context, Real radius);

} // namespace mpsDem
