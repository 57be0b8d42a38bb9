// SPDX-License-Identifier: GPL-3.0-or-later
// What a rim is worth: the fitness of the genetic search.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/fitness_weights.h"
#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// The paper sums scores over a path, eq. (3). Here the score of a rim is the sum of the log odds of the
// triangles that are left out, less what its corners cost by their turning, piecewise linear
// (model::FitnessModel).

// The corners around a vertex, fan after fan, for quick looks at which are selected.
class FanCorners {
 public:
  // For the given vertices, which must hold each vertex of an ambiguous triangle once.
  FanCorners(const TriangleSet& set, std::span<const Index> vertices, const Run& run);

  // What the rim does at a vertex: sums over its fans.
  struct Turns {
    double slight = 0, moderate = 0, sharp = 0, pinches = 0, isolated = 0;
  };
  Turns turns(std::size_t slot, const Selection& selected) const;

  // The cost of a vertex, given by its position in `vertices`; `even`: how even its rim is known to be, 0
  // to 1.
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
