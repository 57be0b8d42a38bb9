// SPDX-License-Identifier: GPL-3.0-or-later
// The view of a range scanner: the direction along which the samples are a raster.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "local/own_frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Offsets to the nearest neighbours of one sample, in the cloud's own frame.
struct SeenSample {
  std::vector<Point> steps;
  double nearest = 0;  // distance of the nearest
  double strewn = 0;   // strewn() of the sample
};

// A sample from which the view is found: about 5,000 points, all where there are fewer. It can be taken of a
// part of the points, with the neighbours and the own frame of the whole. The sum of samples of disjoint
// parts gives the same view as the sample of the whole, in any order.
struct ViewSample {
  double count = 0;  // of all points of the cloud
  std::vector<SeenSample> seen;

  ViewSample& operator+=(const ViewSample& other);
};

// `part`: the points that are taken, by id.
ViewSample sample_views(Points points, std::span<const Index> part, const Neighbours& neighbours,
                        const OwnFrame& own, const Run& run);

// A direction, in the cloud's own frame, along which the samples are evenly spaced.
struct RangeView {
  Point direction;  // unit length; the sign is arbitrary
  double step;      // between neighbours in a row, as seen, in the unit of the points
};

// The direction in which the cloud extends least, if it is such a view. A nearly flat lattice is a raster
// from many sides; only this one sees it in full.
std::optional<RangeView> view_from_front(const ViewSample& sample);

// The best of all directions, if it is such a view.
std::optional<RangeView> best_view(const ViewSample& sample, const Run& run);

// Two unit vectors across a unit vector.
std::array<Point, 2> axes_across(Point direction);

}  // namespace rimline
