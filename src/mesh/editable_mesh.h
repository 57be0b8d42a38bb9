// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that come and go, for mending: no orientation is asked for, so that one-sided surfaces fit in.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// The triangles of one vertex that hang together by edges, in a row.
struct Fan {
  std::vector<Index> triangles;
  Index first = none, last = none;  // the far ends of its two open edges; none where it goes all round
};

// Each edge has at most two triangles. The places of removed triangles stay empty.
class EditableMesh {
 public:
  // Of triangles with a repeated corner, that are there twice, or that would be a third at an edge, none but
  // the first are taken.
  EditableMesh(Points points, std::span<const Triangle> triangles);

  Points points() const { return points_; }
  Index vertices() const { return static_cast<Index>(stars_.size()); }
  Index places() const { return static_cast<Index>(triangles_.size()); }
  std::size_t size() const { return size_; }  // triangles that are there
  bool has(Index t) const { return triangles_[t][0] != none; }
  const Triangle& triangle(Index t) const { return triangles_[t]; }
  std::span<const Index> star(Index vertex) const { return stars_[vertex]; }

  bool can_add(const Triangle& t) const;
  Index add(const Triangle& t);  // returns its place
  void remove(Index t);

  int count_at(Index a, Index b) const;            // triangles at edge ab
  Index across(Index t, Index a, Index b) const;   // the other triangle at its edge ab, or none
  Index apex(Index t, Index a, Index b) const;     // the corner that is neither a nor b
  bool runs(Index t, Index from, Index to) const;  // whether it runs along the edge in this direction
  Point normal(Index t) const;                     // twice the area long
  std::vector<Fan> fans(Index vertex) const;
  bool is_at_rim(Index vertex) const;
  std::vector<Index> neighbours(Index vertex) const;  // that share an edge with it, ascending

  // For each place the number of the component that hangs together by edges, from 0 in the order of the first
  // triangles; none where no triangle is.
  std::vector<Index> components() const;
  std::vector<Triangle> all() const;

 private:
  Points points_;
  std::size_t size_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index>> stars_;
};

// The rims, each a closed walk along open edges, as the triangles there run. Each vertex must have one fan.
std::vector<std::vector<Index>> walk_rims(const EditableMesh& mesh);
// Those that pass the vertices given.
std::vector<std::vector<Index>> walk_rims(const EditableMesh& mesh, std::span<const Index> vertices);

}  // namespace rimline
