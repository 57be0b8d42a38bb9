// SPDX-License-Identifier: GPL-3.0-or-later
// Range scans: samples that lie on a raster as the scanner saw them.
#pragma once

#include <optional>
#include <vector>

#include "local/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"
#include "surface/triangle_set.h"

namespace rimline {

// How a scan was taken.
struct RangeImage {
  Point view;                       // unit length; its sign is arbitrary
  double step = 0;                  // between neighbours in a row, as seen, in the unit of the points
  std::vector<Triangle> triangles;  // between neighbouring samples
};

// The view under which the set is a raster, if there is one: 95 % of the samples have a nearest neighbour at
// the same distance to 2 %, and 80 % of the triangles between them are half a cell to 15 %. On other
// samplings not a tenth agree so well, from any side. Fewer than 200 points are no scan,
// and a plane has no depth that a view could tell more of.
//
// The triangles are those of the Delaunay triangulation of the view that are no more than half a cell (one
// and a half times the median area and circumradius), and none of whose edges is longer in space than six
// steps: such an edge is seen at less than 10 degrees and is a depth jump, not a slope. [ours: size in space
// can not tell a depth jump from a slope seen at a glancing angle, the raster can]
std::optional<RangeImage> find_range_image(Points points, const Neighbours& neighbours, const Run& run);

// The surface that its triangles are. Where rims touch in a point all fans there but the largest are left
// out, so that they become one rim.
TriangleSet range_image_triangles(Points points, const std::vector<Frame>& frames, const RangeImage& raster);

}  // namespace rimline
