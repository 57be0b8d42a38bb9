// SPDX-License-Identifier: GPL-3.0-or-later
// What a rim is worth: the fitness of the genetic search.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/rims.h"
#include "surface/triangle_set.h"

namespace rimline {

// Log odds that rims are made of, started from a logistic regression on the ears of known boundaries and
// then tuned on what the search finds. The paper sums scores over a path, eq. (3); here the score of a rim is
// the sum of what its ears gain by the size of the triangles that are left out, less what its corners cost
// by their turning.
struct FitnessModel {
  double open = 1.4;       // for each triangle left out ...
  double size = 0.7;       // ... and per log_ratio of it
  double own = 2.4;        // ... and per log ratio to the largest median around its corners
  double even = 1;         // less for one that all corners have on rims known to be even
  double slight = 7.4;     // per radian of turning up to 0.3,
  double moderate = -3.0;  // correction per radian up to 0.7,
  double sharp = 1.5;      // and per radian of all turning: a smooth rim is precious, a jagged one is not
  double contrast = 7;     // per unit that the log ratio of the sizes on both sides of the rim ...
  double least_contrast = 0.4;    // ... falls short of this
  double pinch = 2;               // where fans meet in a point
  double hole_prior = 3;          // of a hole apart from all other rims ...
  double hole_prior_spread = 15;  // ... and per unit of the spread of sizes around it
  double hole_prior_points = 1;   // ... and per e-fold of the points beyond 1,000: chance has more places
  double hole_prior_beyond_spread =
      1;                 // in place of all three where the spread does not bring about such a hole
  double isolated = 12;  // a point that loses all its triangles
};

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

  // The cost of a vertex, given by its position in `vertices`.
  double cost(std::size_t slot, const Selection& selected, const FitnessModel& weights) const;

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
