// SPDX-License-Identifier: GPL-3.0-or-later
// Points on lines that lead away from the surface: tails, trails, wires.
#pragma once

#include <vector>

#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The points, 1 where true, of chains that end in the air: from its end on, each point sees all that is near
// it in a narrow cone. Chains of three points or more count, with up to two that lie on the way to the
// surface. None do that have others to their sides, as the rows of a scan have. `scale`: usual_spacing();
// `left_out`, 1 where true: points that are no neighbours any more.
std::vector<char> lies_on_chain(Points points, const Neighbours& neighbours, const std::vector<double>& scale,
                                const std::vector<char>& left_out, const Run& run);

}  // namespace rimline
