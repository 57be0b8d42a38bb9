// SPDX-License-Identifier: GPL-3.0-or-later
// Points on lines that lead away from the surface: tails, trails, wires.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Marks (1) the points of chains that end in free space: from its end on, each point sees all points nearby
// in a narrow cone. Chains have three points or more, and up to two points on the way to the surface. Chains
// with other points beside them, as the rows of a scan, are not marked. `scale`: usual_spacing(); `left_out`:
// points (1) that do not count as neighbours.
std::vector<char> lies_on_chain(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                                const std::vector<char>& left_out, const Run& run);

}  // namespace rimline
