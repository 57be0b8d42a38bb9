// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh to which triangles are added and from which they are removed, for repair. It need not be orientable.
#pragma once

#include <span>
#include <vector>

#include "rimline/mesh.h"

namespace rimline {

// A fan: consecutive triangles of one vertex, connected by edges.
struct Fan {
  std::vector<Index> triangles;
  Index first = none, last = none;  // the far ends of its two open edges; none where the fan is closed
};

// Each edge has at most two triangles. The places of removed triangles stay empty.
class EditableMesh {
 public:
  // Skips triangles with a repeated corner, duplicates, and triangles that would be a third at an edge.
  EditableMesh(Points points, std::span<const Triangle> triangles);

  Points points() const { return points_; }
  Index vertices() const { return static_cast<Index>(stars_.size()); }
  Index places() const { return static_cast<Index>(triangles_.size()); }
  std::size_t size() const { return size_; }  // number of triangles
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

  // The component of each place, numbered by first triangles; none where the place is empty.
  std::vector<Index> components() const;
  std::vector<Triangle> all() const;

 private:
  Points points_;
  std::size_t size_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index>> stars_;
};

// The rims, each a closed walk along open edges in the direction of the triangles there. Each vertex must
// have one fan.
std::vector<std::vector<Index>> walk_rims(const EditableMesh& mesh);
// The rims that pass the given vertices.
std::vector<std::vector<Index>> walk_rims(const EditableMesh& mesh, std::span<const Index> vertices);

}  // namespace rimline
