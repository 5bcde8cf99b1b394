#pragma once

#include <string>
#include <vector>

#include "core/Dictionary.h"
#include "core/Polyline.h"
#include "core/Types.h"
#include "particles/Lattice.h"

namespace mpsDem {

/// A fixed wall of the case: a surface, and how many rows of ghosts stand behind its wall row.
struct WallDefinition
{
    Polyline surface; ///< Its name is the wall's.
    int ghostRows = 0;
    Location where; ///< Place in setParticlesDict.
};

/// Reads `geometry` and `walls` of setParticlesDict.
///
/// geometry: a dictionary of surfaces. In 2-D each is a line in the plane z = 0, third components of boxes, plates and axes do not count.
///
/// | type               | key            | meaning                                                | unit | default |
/// |--------------------|----------------|--------------------------------------------------------|------|---------|
/// | polyline           | points         | corners in order                                       | m    | none    |
/// |                    | closed         | joins the last to the first                            | -    | false   |
/// |                    | fluidSide      | left or right when one walks along the points          | -    | left    |
/// | searchableBox      | min, max       | opposite corners                                       | m    | none    |
/// |                    | open           | sides left out: left right bottom top                  | -    | ()      |
/// |                    | fluidSide      | inside or outside                                      | -    | inside  |
/// | searchablePlate    | origin, span   | from origin to origin + span                           | m    | none    |
/// |                    | fluidSide      | left or right when one walks along the span            | -    | left    |
/// | searchableCylinder | point1, point2 | ends of the axis (along z)                             | m    | none    |
/// |                    | radius         |                                                        | m    | none    |
/// |                    | fluidSide      | inside or outside                                      | -    | outside |
/// | searchableSphere   | centre, radius | a disc                                                 | m    | none    |
/// |                    | fluidSide      | inside or outside                                      | -    | outside |
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
std::vector<WallDefinition> readWalls(Dictionary const& setParticlesDict, Lattice const& lattice, Real radius);

/// Corners of a polygon that stands for a circle: at least 64, so many that it leaves the circle by no more than 0.005 spacings.
std::vector<Vector> circlePoints(Vector const& centre, Real radius, Real spacing);

} // namespace mpsDem
