// SPDX-License-Identifier: GPL-3.0-or-later
// A set of the paper's experiments, its truth where that is known, and how well points cover others.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rimline/neighbours.h"

namespace rimline::bench {

struct PointSet {
  std::vector<Point> points;    // those that take part, in the order of arrange()
  std::vector<double> spacing;  // mean distance to the six nearest
  Neighbours neighbours;        // the nearest `k` that was asked for
  std::vector<Index> rim;       // the points of the true boundary; empty where it is not known
  std::vector<char> asked;      // 0 for points that the truth does not speak of
  std::vector<Index> creases;   // points of edges of the true mesh that fold by more than 30 degrees
};

// `truth` is a mesh with the same vertices, or empty. Throws rimline::Error.
PointSet read_point_set(const std::string& path, const std::string& truth, int k);

// Of each of the points `ids`, 1 where it has one of `others` within its own spacing.
std::vector<char> near(const PointSet& set, std::span<const Index> ids, std::span<const Index> others);

// Share of the points `ids` that have one of `others` within their own spacing, of those that the truth
// speaks of; 0 where either is empty.
double share_near(const PointSet& set, std::span<const Index> ids, std::span<const Index> others);

}  // namespace rimline::bench
