// SPDX-License-Identifier: GPL-3.0-or-later
// A set of triangles over the points that is a surface with boundary, but for pinches.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <vector>

#include "exact/frame.h"
#include "rimline/mesh.h"
#include "rimline/points.h"

namespace rimline::exact {

// Radius of the circle through three points in space; infinite where they lie on a line.
double circumradius(Point a, Point b, Point c);

// Each edge has at most two triangles. The triangles of a vertex form fans (in a row around it); more than
// one fan is a pinch. The boundary of any subset of the triangles, taken modulo 2, is closed: it is what the
// rim search relies on.
class Complex {
 public:
  Complex(Points points, const std::vector<Frame>& frames)
      : points_(points), frames_(frames), stars_(points.size()) {}

  Points points() const { return points_; }
  const std::vector<Frame>& frames() const { return frames_; }
  Index size() const { return static_cast<Index>(triangles_.size()); }
  Index vertices() const { return static_cast<Index>(stars_.size()); }
  const Triangle& triangle(Index t) const { return triangles_[t]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  // The ids of the triangles at a vertex, in no particular order.
  const auto& star(Index vertex) const { return stars_[vertex]; }

  void add(const Triangle& triangle);
  // Leaves out the triangles with a zero; the ids of the others move up.
  void keep_only(const std::vector<std::uint8_t>& kept);
  // Whether it can be added: no edge gets a third triangle, no fan crosses another or folds back on itself.
  bool can_add(const Triangle& triangle) const;

  // The triangles at edge ab: their number (0 to 2) and ids.
  int edge(Index a, Index b, Index (&found)[2]) const;
  // The other triangle at edge ab, or `none`.
  Index across(Index triangle, Index a, Index b) const;
  // The vertex of the triangle that is neither a nor b.
  Index apex(Index triangle, Index a, Index b) const;
  double radius(Index t) const { return radii_[t]; }  // of its circumcircle
  void flip(Index t) { std::swap(triangles_[t][1], triangles_[t][2]); }

 private:
  bool folds_back(Index a, Index b, Index c, Index d) const;
  bool fits_around(Index vertex, Index a, Index b) const;
  bool closes_beside_others(Index vertex, Index a, Index b) const;
  double direction(Index from, Index to) const;

  Points points_;
  const std::vector<Frame>& frames_;
  std::vector<Triangle> triangles_;
  std::vector<double> radii_;
  std::vector<boost::container::small_vector<Index, 8>> stars_;
};

}  // namespace rimline::exact
