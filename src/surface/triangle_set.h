// SPDX-License-Identifier: GPL-3.0-or-later
// A triangulation of the points that is a surface with boundary, except for pinches, with the triangles at
// each vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "local/frame.h"
#include "local/star.h"
#include "mesh/triangulation.h"
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
  // The range of a vertex's triangles in `at_vertex_`, and its capacity.
  struct Place {
    std::size_t first = 0;
    std::uint32_t count = 0, room = 0;
  };

 public:
  TriangleSet(Points points, const std::vector<Frame>& frames)
      : points_(points), frames_(&frames), stars_(points.size()) {}

  Points points() const { return points_; }
  const std::vector<Frame>& frames() const { return *frames_; }
  // The triangles and their neighbours.
  const Triangulation& mesh() const { return mesh_; }
  Index size() const { return mesh_.size(); }
  Index vertices() const { return static_cast<Index>(stars_.size()); }
  const Triangle& triangle(Index t) const { return mesh_.triangles[t]; }
  const std::vector<Triangle>& triangles() const { return mesh_.triangles; }
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

  // Takes the first triangles, with their circumradii, all at once; the result is the same as adding one
  // after another.
  void start_with(std::vector<Triangle> triangles, std::vector<double> radii, AtVertices at, const Run& run);
  void add(const Triangle& triangle);
  // Removes the triangles marked with zero; the ids of the others move up.
  void keep_only(const std::vector<std::uint8_t>& kept, const Run& run = {});
  // Whether the triangle can be added: no edge gets a third triangle, no fan crosses another or folds back on
  // itself.
  bool can_add(const Triangle& triangle) const;

  // The triangles at edge ab: their number (0 to 2) and ids.
  int edge(Index a, Index b, Index (&found)[2]) const;
  // The other triangle at edge ab of a triangle, or `none`.
  Index across(Index triangle, Index a, Index b) const {
    return mesh_.adjacent[triangle][mesh_.corner_opposite(triangle, a, b)];
  }
  // The same for the edge that leaves its corner i, in {0, 1, 2}.
  Index across(Index triangle, int i) const { return mesh_.adjacent[triangle][previous(i)]; }
  // The same for all three.
  std::array<Index, 3> beside(Index triangle) const {
    const std::array<Index, 3>& adjacent = mesh_.adjacent[triangle];
    return {adjacent[2], adjacent[0], adjacent[1]};
  }
  bool is_at_rim(Index triangle) const {
    const auto& beside = mesh_.adjacent[triangle];
    return (beside[0] == none) | (beside[1] == none) | (beside[2] == none);
  }
  // The vertex of the triangle that is neither a nor b.
  Index apex(Index triangle, Index a, Index b) const {
    return mesh_.triangles[triangle][mesh_.corner_opposite(triangle, a, b)];
  }
  double radius(Index t) const { return radii_[t]; }  // of its circumcircle
  // Flips the orientation of a triangle, without a branch: half of the branches would be mispredicted.
  void flip_if(Index t, bool wanted) {
    Triangle& x = mesh_.triangles[t];
    std::array<Index, 3>& beside = mesh_.adjacent[t];
    x = {x[0], x[1 + wanted], x[2 - wanted]};
    beside = {beside[0], beside[1 + wanted], beside[2 - wanted]};
  }

 private:
  void put_at_vertex(Index vertex, Index triangle);
  void gather_at_vertex(Index vertex);
  void link_at_vertex(Index vertex, Star star);
  bool folds_back(Index a, Index b, Index c, Index d) const;
  bool fits_around(Index vertex, Index a, Index b) const;
  bool closes_beside_others(Index vertex, Index a, Index b) const;
  double direction(Index from, Index to) const;

  Points points_;
  const std::vector<Frame>* frames_;
  Triangulation mesh_;
  std::vector<double> radii_;
  std::vector<Place> stars_;
  std::vector<Index> at_vertex_;
};

}  // namespace rimline
