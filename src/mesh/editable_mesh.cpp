// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/editable_mesh.h"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "mesh/components.h"

namespace rimline {
namespace {

bool names(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

// The other end of the fan at a vertex that begins with the open edge to `from`.
Index beyond(const EditableMesh& mesh, Index vertex, Index from) {
  for (Index t = mesh.across(none, vertex, from); t != none; t = mesh.across(t, vertex, from))
    from = mesh.apex(t, vertex, from);
  return from;
}

}  // namespace

EditableMesh::EditableMesh(Points points, std::span<const Triangle> triangles)
    : points_(points), stars_(points.size()) {
  triangles_.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    if (can_add(t)) add(t);
  }
}

bool EditableMesh::can_add(const Triangle& t) const {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
  for (const Index other : stars_[t[0]]) {
    if (names(triangles_[other], t[1]) && names(triangles_[other], t[2])) return false;
  }
  return count_at(t[0], t[1]) < 2 && count_at(t[1], t[2]) < 2 && count_at(t[2], t[0]) < 2;
}

Index EditableMesh::add(const Triangle& t) {
  const Index place = places();
  triangles_.push_back(t);
  for (const Index v : t) stars_[v].push_back(place);
  ++size_;
  return place;
}

void EditableMesh::remove(Index t) {
  for (const Index v : triangles_[t]) std::erase(stars_[v], t);
  triangles_[t] = {none, none, none};
  --size_;
}

int EditableMesh::count_at(Index a, Index b) const {
  return static_cast<int>(std::ranges::count_if(stars_[a], [&](Index t) { return names(triangles_[t], b); }));
}

Index EditableMesh::across(Index t, Index a, Index b) const {
  for (const Index other : stars_[a]) {
    if (other != t && names(triangles_[other], b)) return other;
  }
  return none;
}

Index EditableMesh::apex(Index t, Index a, Index b) const {
  for (const Index v : triangles_[t]) {
    if (v != a && v != b) return v;
  }
  return none;
}

bool EditableMesh::runs(Index t, Index from, Index to) const {
  const Triangle& x = triangles_[t];
  return (x[0] == from && x[1] == to) || (x[1] == from && x[2] == to) || (x[2] == from && x[0] == to);
}

Point EditableMesh::normal(Index t) const {
  const Triangle& x = triangles_[t];
  return cross(points_[x[1]] - points_[x[0]], points_[x[2]] - points_[x[0]]);
}

std::vector<Fan> EditableMesh::fans(Index vertex) const {
  std::vector<Index> left(stars_[vertex].begin(), stars_[vertex].end());
  const auto open_end = [&](Index t) {
    for (const Index w : triangles_[t]) {
      if (w != vertex && across(t, vertex, w) == none) return w;
    }
    return none;
  };
  std::vector<Fan> fans;
  while (!left.empty()) {
    Fan& fan = fans.emplace_back();
    const auto open = std::ranges::find_if(left, [&](Index t) { return open_end(t) != none; });
    Index at = open == left.end() ? left.front() : *open;
    fan.first = open_end(at);
    // Walks from the open edge; a closed fan ends where it began.
    Index from = fan.first != none ? fan.first : triangles_[at][triangles_[at][0] == vertex ? 1 : 0];
    for (const Index start = at; at != none;) {
      fan.triangles.push_back(at);
      std::erase(left, at);
      const Index to = apex(at, vertex, from);
      const Index beyond = across(at, vertex, to);
      if (beyond == none) fan.last = to;
      from = to;
      at = beyond == start ? none : beyond;
    }
  }
  return fans;
}

bool EditableMesh::is_at_rim(Index vertex) const {
  for (const Index t : stars_[vertex]) {
    for (const Index w : triangles_[t]) {
      if (w != vertex && across(t, vertex, w) == none) return true;
    }
  }
  return false;
}

std::vector<Index> EditableMesh::neighbours(Index vertex) const {
  std::vector<Index> found;
  for (const Index t : stars_[vertex]) {
    for (const Index w : triangles_[t]) {
      if (w != vertex) found.push_back(w);
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<Index> EditableMesh::components() const {
  Triangulation linked{triangles_, {}};
  linked.adjacent.assign(triangles_.size(), {none, none, none});
  std::vector<std::uint8_t> is_there(triangles_.size(), 0);
  for (Index t = 0; t < places(); ++t) {
    is_there[t] = has(t);
    for (int c = 0; has(t) && c < 3; ++c)
      linked.adjacent[t][c] = across(t, triangles_[t][next(c)], triangles_[t][previous(c)]);
  }
  return find_components(linked, is_there).of_triangle;
}

std::vector<Triangle> EditableMesh::all() const {
  std::vector<Triangle> triangles;
  triangles.reserve(size_);
  for (Index t = 0; t < places(); ++t) {
    if (has(t)) triangles.push_back(triangles_[t]);
  }
  return triangles;
}

std::vector<std::vector<Index>> walk_rims(const EditableMesh& mesh) {
  std::vector<Index> all(mesh.vertices());
  std::iota(all.begin(), all.end(), Index{0});
  return walk_rims(mesh, all);
}

std::vector<std::vector<Index>> walk_rims(const EditableMesh& mesh, std::span<const Index> vertices) {
  std::unordered_set<Index> done;
  std::vector<std::vector<Index>> rims;
  for (const Index v : vertices) {
    if (done.contains(v) || mesh.star(v).empty() || !mesh.is_at_rim(v)) continue;
    std::vector<Index>& rim = rims.emplace_back();
    const Fan fan = mesh.fans(v).front();
    Index at = v, to = mesh.runs(fan.triangles.front(), v, fan.first) ? fan.first : fan.last;
    while (done.insert(at).second) {
      rim.push_back(at);
      at = std::exchange(to, beyond(mesh, to, at));
    }
  }
  return rims;
}

}  // namespace rimline
