// SPDX-License-Identifier: GPL-3.0-or-later
// How far a map is from keeping angles, and whether the disc's map keeps them better.
#pragma once

#include <vector>

#include "map/open_mesh.h"
#include "rimline/run.h"

namespace rimline {

// Mean difference of corners' angles in space and in uv, radians: each corner once, and each by the area of
// its triangle in space.
struct AngleError {
  double corner = 0, area = 0;
};

AngleError angle_error(const OpenMesh& open, const std::vector<UV>& uv);

// Whether one of the errors is above that of the other.
bool is_above(const AngleError& error, const AngleError& other);

// What no map to the disc is below: round an inner point angles in the plane make 2 pi, round one of the
// outline what the polygon on the circle has, so corners there change by what is lacking in space, together.
AngleError least_error_of_disc(const OpenMesh& open);

// That of the disc's map; infinite where there is none.
AngleError error_of_disc(const OpenMesh& open, double residual, const Run& run);

}  // namespace rimline
