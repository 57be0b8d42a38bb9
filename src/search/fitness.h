// SPDX-License-Identifier: GPL-3.0-or-later
// The fitness of a selection: log odds of its rim.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/fitness_weights.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// The paper sums scores over a path, eq. (3). Here the fitness of a selection is the sum of the log odds of
// the triangles that it leaves out, less a cost of the turning angles of its rim. The cost is piecewise
// linear in the angle (model::FitnessModel).

// The corners of triangles around each vertex, fan by fan, so that the rim there is found quickly for any
// selection.
class FanCorners {
 public:
  // `vertices` must contain each vertex of each candidate triangle once.
  FanCorners(const TriangleSet& set, std::span<const Index> vertices, const Run& run);

  // Turning angles (radians), pinches and isolated points at a vertex, summed over its fans.
  struct Turns {
    double slight = 0, moderate = 0, sharp = 0, pinches = 0, isolated = 0;
  };
  Turns turns(std::size_t slot, const Selection& selected) const;

  // The cost of a vertex, given by its position in `vertices`. `even`: evenness of the rim there, 0 to 1.
  double cost(std::size_t slot, const Selection& selected, const FitnessWeights& weights,
              double even = 0) const;

 private:
  struct Corner {
    Index triangle;
    float from, to;  // directions of its two edges in the vertex's plane, radians
  };
  struct Fan {
    std::uint32_t first, last;
    bool closed;
  };

  FanCorners(const TriangleSet& set, std::span<const Index> vertices);

  void append(const FanCorners& other);
  void add_vertex(const TriangleSet& set, Index vertex);
  void add_fan(const TriangleSet& set, Index vertex, Index t, Index from, bool closed,
               std::vector<Index>& left);

  std::vector<Corner> corners_;
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> first_fan_;
};

}  // namespace rimline
