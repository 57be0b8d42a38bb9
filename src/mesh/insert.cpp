// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/insert.h"

#include <limits>

namespace rimline {
namespace {

class Inserter {
 public:
  Inserter(Points points, Triangulation& mesh) : points_(points), mesh_(mesh), star_(points.size(), none) {
    for (Index t = 0; t < mesh_.size(); ++t) touch(t);
  }

  bool has(Index vertex) const { return star_[vertex] != none; }

  // Splits the nearest triangle at one of `near`. False where none of them has a triangle.
  bool insert(Index vertex, std::span<const Index> near) {
    Index best = none;
    double least = std::numeric_limits<double>::infinity();
    for (const Index v : near) {
      for_each_triangle(v, [&](Index t) {
        const Triangle& x = mesh_.triangles[t];
        const Point centre = (1.0 / 3) * (points_[x[0]] + points_[x[1]] + points_[x[2]]);
        const double d = squared_distance(centre, points_[vertex]);
        if (d < least) {
          least = d;
          best = t;
        }
      });
    }
    if (best != none) {
      split(mesh_, best, vertex);
      for (const Index t : {best, mesh_.size() - 2, mesh_.size() - 1}) touch(t);
    }
    return best != none;
  }

 private:
  void touch(Index t) {
    for (const Index v : mesh_.triangles[t]) star_[v] = t;
  }

  template <class Visit>
  void for_each_triangle(Index vertex, const Visit& visit) const {
    const Index start = star_[vertex];
    if (start == none) return;
    Index at = start;
    do {
      visit(at);
      at = mesh_.adjacent[at][next(mesh_.corner_of(at, vertex))];
    } while (at != none && at != start);
    if (at == start) return;
    at = mesh_.adjacent[start][previous(mesh_.corner_of(start, vertex))];
    while (at != none) {
      visit(at);
      at = mesh_.adjacent[at][previous(mesh_.corner_of(at, vertex))];
    }
  }

  Points points_;
  Triangulation& mesh_;
  std::vector<Index> star_;  // a triangle of each vertex
};

}  // namespace

std::vector<Index> insert_missing(Points points, const Neighbours& neighbours, Triangulation& mesh) {
  Inserter inserter(points, mesh);
  std::vector<Index> waiting;
  for (Index v = 0; v < static_cast<Index>(points.size()); ++v) {
    if (!inserter.has(v)) waiting.push_back(v);
  }
  while (!waiting.empty()) {
    std::vector<Index> later;
    for (const Index v : waiting) {
      if (!inserter.insert(v, neighbours.of(v, std::min(neighbours.k, 6)))) later.push_back(v);
    }
    if (later.size() == waiting.size()) break;
    waiting = std::move(later);
  }
  std::vector<Index> left;
  for (const Index v : waiting) {
    if (!inserter.insert(v, neighbours.of(v))) left.push_back(v);
  }
  return left;
}

}  // namespace rimline
