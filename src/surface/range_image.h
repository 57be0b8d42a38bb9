// SPDX-License-Identifier: GPL-3.0-or-later
// Range images: samples on a raster in the scanner's view.
#pragma once

#include <optional>
#include <vector>

#include "local/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"
#include "surface/range_view.h"
#include "surface/triangle_set.h"

namespace rimline {

// A range image.
struct RangeImage {
  Point view;                       // unit length; its sign is arbitrary. Zero where the scanner's raster told
  double step = 0;                  // between neighbours in a row, as seen, in the unit of the points
  std::vector<Triangle> triangles;  // between neighbouring samples
};

// A triangle of a view's Delaunay triangulation.
struct RangeCell {
  double area, radius;  // in the view; the radius is that of the circumcircle
  double longest;       // edge, in space
};

// Triangles by which a raster is recognized: about 200,000 of the view, all where there are fewer. The sum of
// samples of disjoint parts gives the same answer as the sample of the whole, in any order.
struct CellSample {
  std::vector<RangeCell> cells;

  CellSample& operator+=(const CellSample& other);
};

// `seen`: the points in the plane of the view; `own`: the frame of the whole cloud.
CellSample sample_cells(Points points, const std::vector<Triangle>& triangles, const std::vector<UV>& seen,
                        const OwnFrame& own, const Run& run);

// The upper limits of a cell's triangles; none where the samples are no raster. `step`: RangeView::step.
std::optional<RangeCell> largest_cell(const CellSample& sample, double step);

// Finds the view under which the points are a raster, if there is one: 95 % of the samples have a nearest
// neighbour at the same distance to 2 %, and 80 % of the triangles between them are half a cell to 15 %. On
// other samplings fewer than a tenth agree, from any side. Fewer than 200 points are not tested, nor are
// points in a plane, which have no depth.
//
// The triangles are those of the Delaunay triangulation in the view that are at most half a cell (one and a
// half times the median area and circumradius) with no edge longer in space than six steps: such an edge is
// seen at less than 10 degrees and is a depth jump, not a slope. [ours: size in space can not tell a depth
// jump from a slope seen at a glancing angle, the raster can]
std::optional<RangeImage> find_range_image(Points points, const Neighbours& neighbours, const Run& run);

// The surface of these triangles. Where rims touch in a point all fans there but the largest are removed, so
// that the rims become one.
TriangleSet range_image_triangles(Points points, const std::vector<Frame>& frames, const RangeImage& raster);

}  // namespace rimline
