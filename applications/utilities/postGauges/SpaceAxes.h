#pragma once

#include <ostream>
#include <vector>

#include "postGauges/Camera.h"
#include "postGauges/SpaceImage.h"

namespace mpsDem::postGauges {

/// Edges of the box that do not meet in its nearest corner, thin grey.
void drawBox(SpaceImage& image, Camera const& camera, SpaceBox const& box);

/// Numbers and names at three edges of the box, as gnuplot's labels and arrows in pixels of the picture.
void writeAxes(std::ostream& script, Camera const& camera, SpaceBox const& box, Real pixelsAMetre, Window const& window);

} // namespace mpsDem::postGauges
