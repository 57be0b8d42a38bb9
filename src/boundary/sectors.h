// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (1): how evenly angles spread over equal sectors.
#pragma once

#include <span>
#include <vector>

#include "base/lanes.h"
#include "rimline/points.h"

namespace rimline {

// The circle in equal slices of [0, 2 pi), the first of which starts at the first axis. A sector holds its
// first edge and not its last; a point at the origin counts as angle 0.
class Sectors {
 public:
  explicit Sectors(int count);

  // The number of points (u[i], v[i]) in each sector, lane by lane, of at least one point. `counts` has one
  // entry a sector.
  void count(std::span<const Lanes> u, std::span<const Lanes> v, std::span<Lanes> counts) const;

 private:
  // The line through the origin along an edge, in the direction above the first axis. Where sectors are even
  // in number both its ends are edges, where they are odd only one. That along the first axis itself is not
  // kept.
  struct Line {
    UV direction;
    int sector = 0, opposite = 0;  // that start at its ends; 0 where there is no edge
  };
  std::vector<Line> lines_;
};

// Pearson's statistic, eq. (1), of the counts.
double pearson_statistic(std::span<const int> counts);

}  // namespace rimline
