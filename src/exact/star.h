// SPDX-License-Identifier: GPL-3.0-or-later
// The local Delaunay star of a point: which neighbours surround it, in order.
#pragma once

#include <boost/container/small_vector.hpp>
#include <span>
#include <vector>

#include "exact/frame.h"
#include "rimline/neighbours.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline::exact {

// The neighbours around a point, counter-clockwise in its frame; each two in a row (and the last with the
// first) make a triangle with the point. `none` stands where the point's Voronoi cell is open.
using Star = boost::container::small_vector<Index, 10>;

// One star per point. The point's neighbours, and those that have it as theirs, are laid out in its tangent
// plane at their true distance; its Voronoi cell is cut out of the plane by their bisectors, nearest first,
// and the bisectors that bound the cell name the star. Needs about one microsecond a point; no general
// Delaunay triangulation is built.
//
// Neighbours in lists of each other are needed at density borders: a point on the dense side does not have
// those of the sparse side among its nearest, but they have it.
std::vector<Star> find_stars(Points points, const Neighbours& neighbours, const std::vector<double>& spacing,
                             const std::vector<Frame>& frames, const Run& run);

}  // namespace rimline::exact
