// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of a conformal map, computed without the map.
#pragma once

#include <vector>

#include "map/open_mesh.h"
#include "rimline/run.h"

namespace rimline {

// The natural logarithm of the scale, per vertex, of the conformal map that keeps the length of the longest
// loop: L u = -K inside and u = 0 along it, where L is the Laplacian and K the angle that a vertex lacks to 2
// pi (Sawhney & Crane 2017, "Boundary first flattening"; Ben-Chen, Gotsman & Bunin 2008). Holes are taken to
// be closed by flat discs, their rims' turning being their curvature. `turning` gets, per vertex of the
// longest loop in its order, the angle by which the map's outline turns there; the sum is 2 pi. The mesh must
// have a loop and no handle.
std::vector<double> conformal_log_scale(const OpenMesh& open, double residual, std::vector<double>& turning,
                                        const Run& run);

// Mean (Sander's L2) and worst (Linf) stretch of a map, area for area. [1, infinity)
struct Stretch {
  double mean = 1, worst = 1;
};

// The stretch of a map with these logarithms of its scale.
Stretch stretch_of_scale(const OpenMesh& open, const std::vector<double>& log_scale);

// The stretch of a given map, scaled to the area of the surface.
Stretch stretch_of_map(const OpenMesh& open, const std::vector<UV>& uv);

}  // namespace rimline
