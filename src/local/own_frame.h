// SPDX-License-Identifier: GPL-3.0-or-later
// The cloud's own directions, which turn with it.
#pragma once

#include <array>
#include <vector>

#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// The principal axes of all points about their mean, right-handed, with the signs that make the third moments
// along the first two positive. What depends on directions or on a choice of points goes by these, so that a
// cloud that is turned gives the same result; where two axes are equally long they are any.
struct OwnFrame {
  Point centre;
  std::array<Point, 3> axes{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};  // the longest first
  double extent = 1;  // root of the mean square distance to the centre

  // A vector of the cloud's space in the frame, and back.
  Point in(Point v) const { return {dot(v, axes[0]), dot(v, axes[1]), dot(v, axes[2])}; }
  Point out(Point v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
};

OwnFrame own_frame(Points points, const Run& run);

// About `most` of the points, ascending; all where there are no more. They are strewn over the cloud by where
// they are in its own frame, not by their order.
std::vector<Index> some_of(Points points, const OwnFrame& frame, std::size_t most, const Run& run);

}  // namespace rimline
