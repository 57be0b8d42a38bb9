// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/close_ring.h"

#include <limits>

namespace rimline {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// Least costs of the parts of a ring, each between the ends of one chord.
class RingTable {
 public:
  RingTable(Points points, std::span<const Index> ring, const std::function<bool(Index, Index)>& taken)
      : points_(points), ring_(ring), size_(ring.size()), cost_(size_ * size_, 0), split_(size_ * size_, 0) {
    for (std::size_t length = 2; length < size_; ++length) {
      for (std::size_t i = 0; i + length < size_; ++i) settle(i, i + length, taken);
    }
  }

  bool possible() const { return cost_[size_ - 1] < never; }

  void collect(std::vector<Triangle>& triangles) const {
    std::vector<std::array<std::size_t, 2>> open{{0, size_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j < i + 2) continue;
      const std::size_t m = split_[i * size_ + j];
      triangles.push_back({ring_[i], ring_[m], ring_[j]});
      open.push_back({i, m});
      open.push_back({m, j});
    }
  }

 private:
  void settle(std::size_t i, std::size_t j, const std::function<bool(Index, Index)>& taken) {
    double& least = cost_[i * size_ + j];
    least = never;
    const bool side_of_ring = i == 0 && j + 1 == size_;
    if (!side_of_ring && taken(ring_[i], ring_[j])) return;
    for (std::size_t m = i + 1; m < j; ++m) {
      const double cost = cost_[i * size_ + m] + cost_[m * size_ + j] + cost_of(ring_[i], ring_[m], ring_[j]);
      if (cost >= least) continue;
      least = cost;
      split_[i * size_ + j] = m;
    }
  }

  double cost_of(Index a, Index b, Index c) const {
    constexpr double shorter = 1e-3;  // settles ties; small, so that it never outweighs an overlap
    const Point p = points_[a], q = points_[b], r = points_[c];
    return 0.5 * norm(cross(q - p, r - p)) +
           shorter * (squared_distance(p, q) + squared_distance(q, r) + squared_distance(r, p));
  }

  Points points_;
  std::span<const Index> ring_;
  std::size_t size_;
  std::vector<double> cost_;        // of the part between i and j
  std::vector<std::size_t> split_;  // the third corner of the triangle at chord ij
};

}  // namespace

std::vector<Triangle> close_ring(Points points, std::span<const Index> ring,
                                 const std::function<bool(Index, Index)>& taken) {
  std::vector<Triangle> triangles;
  if (ring.size() < 3) return triangles;
  const RingTable table(points, ring, taken);
  if (table.possible()) table.collect(triangles);
  return triangles;
}

}  // namespace rimline
