// SPDX-License-Identifier: GPL-3.0-or-later
// The Voronoi cell of the origin among points of the plane, cut by one bisector after another.
#pragma once

#include <array>
#include <cmath>

#include "rimline/points.h"

namespace rimline {

class VoronoiCell {
 public:
  // The square of half-width `reach` about the origin, without neighbours.
  void start(double reach) {
    size_ = 4;
    corners_ = &storage_[0];
    corners_[0] = {-reach, -reach, 0, 0, none};
    corners_[1] = {reach, -reach, 0, 0, none};
    corners_[2] = {reach, reach, 0, 0, none};
    corners_[3] = {-reach, reach, 0, 0, none};
    measure();
  }

  // Whether no point at this distance or beyond can cut the cell any more.
  bool settled(double distance) const { return distance * distance > 4 * radius2_; }

  // Keeps what is nearer to the origin than to (x, y).
  void clip(double x, double y, Index id) {
    const double squared = x * x + y * y, limit = squared / 2;
    std::array<double, capacity> excess;
    int outside = 0;
    for (int i = 0; i < size_; ++i) {
      excess[i] = x * corners_[i].x + y * corners_[i].y - limit;
      outside += excess[i] > 0;
    }
    if (outside == 0 || size_ + 1 >= capacity) return;
    Corner* next = corners_ == &storage_[0] ? &storage_[capacity] : &storage_[0];
    int count = 0;
    for (int i = 0; i < size_; ++i) {
      const int j = i + 1 < size_ ? i + 1 : 0;
      const Corner &a = corners_[i], &b = corners_[j];
      if (excess[i] <= 0) next[count++] = a;
      if ((excess[i] > 0) == (excess[j] > 0)) continue;
      const double t = excess[i] / (excess[i] - excess[j]);
      Corner cut = a;  // the edge that follows it is a's own where the cell is entered ...
      cut.x += t * (b.x - a.x);
      cut.y += t * (b.y - a.y);
      if (excess[i] <= 0) {  // ... and the bisector where it is left
        cut.across_x = x;
        cut.across_y = y;
        cut.id = id;
      }
      next[count++] = cut;
    }
    corners_ = next;
    size_ = count;
    measure();
  }

  // Calls edge(id, length / distance) for the sides in counter-clockwise order; an open side has id `none`
  // and weight 0.
  template <class Edge>
  void edges(const Edge& edge) const {
    for (int i = 0; i < size_; ++i) {
      const Corner &a = corners_[i], &b = corners_[i + 1 < size_ ? i + 1 : 0];
      const double length2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      const double across2 = a.across_x * a.across_x + a.across_y * a.across_y;
      edge(a.id, a.id == none ? 0 : std::sqrt(length2 / across2));
    }
  }

  // Whether neighbours close the cell on all sides.
  bool closed() const {
    for (int i = 0; i < size_; ++i) {
      if (corners_[i].id == none) return false;
    }
    return true;
  }

 private:
  static constexpr int capacity = 64;  // corners: more than a cell of 40 neighbours can have [layout]
  struct Corner {
    double x, y;                // where the edge begins
    double across_x, across_y;  // the neighbour beyond that edge
    Index id;
  };

  void measure() {
    radius2_ = 0;
    for (int i = 0; i < size_; ++i) {
      const double r2 = corners_[i].x * corners_[i].x + corners_[i].y * corners_[i].y;
      if (r2 > radius2_) radius2_ = r2;
    }
  }

  std::array<Corner, 2 * capacity> storage_;
  Corner* corners_ = nullptr;
  int size_ = 0;
  double radius2_ = 0;
};

}  // namespace rimline
