// SPDX-License-Identifier: GPL-3.0-or-later
// A set of triangles over the points that is a surface with boundary, but for pinches.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "local/frame.h"
#include "local/star.h"
#include "rimline/mesh.h"
#include "rimline/points.h"
#include "rimline/run.h"

namespace rimline {

// Radius of the circle through three points in space; infinite where they lie on a line.
double circumradius(Point a, Point b, Point c);
// The angle at b between a and c, radians.
double angle_at(Point a, Point b, Point c);

// Each edge has at most two triangles. The triangles of a vertex form fans (in a row around it); more than
// one fan is a pinch. The boundary of any subset of the triangles, taken modulo 2, is closed: it is what the
// rim search relies on.
class TriangleSet {
  // Where the triangles of a vertex are in `at_vertex_`, and the room for them there.
  struct Place {
    std::size_t first = 0;
    std::uint32_t count = 0, room = 0;
  };

 public:
  TriangleSet(Points points, const std::vector<Frame>& frames)
      : points_(points), frames_(&frames), stars_(points.size()) {}

  Points points() const { return points_; }
  const std::vector<Frame>& frames() const { return *frames_; }
  Index size() const { return static_cast<Index>(triangles_.size()); }
  Index vertices() const { return static_cast<Index>(stars_.size()); }
  const Triangle& triangle(Index t) const { return triangles_[t]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  // The ids of the triangles at a vertex, in no particular order.
  std::span<const Index> star(Index vertex) const {
    return {at_vertex_.data() + stars_[vertex].first, stars_[vertex].count};
  }

  // The triangles at each vertex, one for each place of its star at most. The stars must outlive it.
  class AtVertices {
   public:
    AtVertices(const Stars& stars, const Run& run);
    // Calls for different places may run at the same time.
    void put(Index vertex, std::uint32_t place, Index triangle) {
      ids_[places_[vertex].first + place] = triangle;
    }

   private:
    friend class TriangleSet;
    const Stars& stars_;
    std::vector<Place> places_;
    std::vector<Index> ids_;
  };

  // Takes the first triangles, with their circumradii, all at once: the same as adding one after another.
  void start_with(std::vector<Triangle> triangles, std::vector<double> radii, AtVertices at, const Run& run);
  void add(const Triangle& triangle);
  // Leaves out the triangles with a zero; the ids of the others move up.
  void keep_only(const std::vector<std::uint8_t>& kept, const Run& run = {});
  // Whether it can be added: no edge gets a third triangle, no fan crosses another or folds back on itself.
  bool can_add(const Triangle& triangle) const;

  // The triangles at edge ab: their number (0 to 2) and ids.
  int edge(Index a, Index b, Index (&found)[2]) const;
  // The other triangle at edge ab of a triangle, or `none`.
  Index across(Index triangle, Index a, Index b) const { return beside_[triangle][edge_of(triangle, a, b)]; }
  // The same for the edge that leaves its corner i, in {0, 1, 2}.
  Index across(Index triangle, int i) const { return beside_[triangle][i]; }
  // The same for all three.
  const std::array<Index, 3>& beside(Index triangle) const { return beside_[triangle]; }
  bool is_at_rim(Index triangle) const {
    const auto& beside = beside_[triangle];
    return (beside[0] == none) | (beside[1] == none) | (beside[2] == none);
  }
  // The vertex of the triangle that is neither a nor b.
  Index apex(Index triangle, Index a, Index b) const {
    return triangles_[triangle][(edge_of(triangle, a, b) + 2) % 3];
  }
  double radius(Index t) const { return radii_[t]; }  // of its circumcircle
  // Turns a triangle over. Without a branch, which would be guessed wrongly where half of many are flipped.
  void flip_if(Index t, bool wanted) {
    Triangle& x = triangles_[t];
    std::array<Index, 3>& beside = beside_[t];
    x = {x[0], x[1 + wanted], x[2 - wanted]};
    beside = {beside[2 * wanted], beside[1], beside[2 - 2 * wanted]};
  }

 private:
  // The edge of the triangle that joins a and b, named by the corner that it leaves.
  int edge_of(Index triangle, Index a, Index b) const {
    const Triangle& x = triangles_[triangle];
    return x[2] != a && x[2] != b ? 0 : x[0] != a && x[0] != b ? 1 : 2;
  }
  void put_at_vertex(Index vertex, Index triangle);
  void gather_at_vertex(Index vertex);
  void link_at_vertex(Index vertex, Star star);
  bool folds_back(Index a, Index b, Index c, Index d) const;
  bool fits_around(Index vertex, Index a, Index b) const;
  bool closes_beside_others(Index vertex, Index a, Index b) const;
  double direction(Index from, Index to) const;

  Points points_;
  const std::vector<Frame>* frames_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<Index, 3>> beside_;  // across the edge that leaves each corner, or none
  std::vector<double> radii_;
  std::vector<Place> stars_;
  std::vector<Index> at_vertex_;
};

}  // namespace rimline
