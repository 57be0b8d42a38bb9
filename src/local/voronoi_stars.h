// SPDX-License-Identifier: GPL-3.0-or-later
// Local Voronoi cells: the natural neighbours of a point on the surface, and their weights.
#pragma once

#include <span>
#include <vector>

#include "rimline/neighbours.h"

namespace rimline {

struct StarOptions {
  int normal_k = 10;      // neighbours that tell the tangent plane, before those off it are left out [option]
  double steepest = 0.5;  // least length of a neighbour's projection, over its distance: points behind
                          // the tangent plane lie on another sheet
};

// For each point the neighbours whose bisectors bound its Voronoi cell in the tangent plane, with weight
// (length of the common edge) / (distance): positive, and exact for linear functions where the cell is
// closed and flat. [ours: the paper's reciprocal distances to k neighbours reach across walls and holes]
struct Stars {
  std::vector<Index> offsets = {0};  // n + 1
  std::vector<Index> neighbours;     // in order around the point; `none` where the cell is open
  std::vector<double> weights;
  std::vector<Point> normals;  // unit, of the tangent plane; the sign is arbitrary

  std::span<const Index> of(Index point) const {
    return {neighbours.data() + offsets[point],
            static_cast<std::size_t>(offsets[point + 1] - offsets[point])};
  }
};

// `label` may be empty; else points of different labels are no neighbours.
Stars find_stars(Points points, const Neighbours& neighbours, std::span<const Index> label,
                 const StarOptions& options, const Run& run);

}  // namespace rimline
