// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (1): how evenly angles spread over equal sectors.
#pragma once

#include <span>
#include <vector>

#include "rimline/points.h"

namespace rimline {

// The circle in equal slices of [0, 2 pi), the first of which starts at the first axis. A sector holds its
// first edge and not its last; a point at the origin counts as angle 0.
class Sectors {
 public:
  explicit Sectors(int count);

  // The number of points (u[i], v[i]) in each sector. `counts` has one entry a sector.
  void count(std::span<const double> u, std::span<const double> v, std::span<int> counts) const;

  int of(double u, double v) const;

 private:
  // The circle in cells by a stand-in for the angle that costs no arctangent. A cell has at most one edge.
  struct Cell {
    int sector[2] = {0, 0};  // before and after the edge; the same where the cell has none
    UV edge;                 // its direction
  };
  std::vector<Cell> cells_;
};

// Pearson's statistic, eq. (1), of the counts.
double pearson_statistic(std::span<const int> counts);

}  // namespace rimline
