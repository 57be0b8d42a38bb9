// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/surgery.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "base/union_find.h"
#include "patch/close_gap.h"

namespace rimline {
namespace {

std::set<std::pair<Index, Index>> edges_of(const Curve& curve) {
  std::set<std::pair<Index, Index>> edges;
  const std::vector<Index>& v = curve.vertices;
  for (std::size_t i = 0; i + 1 < v.size(); ++i) edges.insert(std::minmax(v[i], v[i + 1]));
  if (curve.is_closed) edges.insert(std::minmax(v.back(), v.front()));
  return edges;
}

// The vertices of triangles, once each.
std::vector<Index> vertices_of(const std::vector<Triangle>& triangles) {
  std::vector<Index> vertices;
  for (const Triangle& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Places of the triangles that have one of the vertices, ascending.
std::vector<Index> places_at(const EditableMesh& mesh, const std::vector<Index>& vertices) {
  std::set<Index> around;
  for (const Index v : vertices) around.insert(mesh.star(v).begin(), mesh.star(v).end());
  return {around.begin(), around.end()};
}

std::vector<Triangle> triangles_at(const EditableMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Triangle> triangles;
  for (const Index t : places_at(mesh, vertices)) triangles.push_back(mesh.triangle(t));
  return triangles;
}

// The triangles at the curve, in sets that are connected at it without crossing it; two for a two-sided
// curve.
std::vector<std::vector<Triangle>> sides_of(const EditableMesh& mesh, const Curve& curve) {
  const std::vector<Index> triangles = places_at(mesh, curve.vertices);
  const auto place = [&](Index t) {
    return static_cast<Index>(std::ranges::lower_bound(triangles, t) - triangles.begin());
  };
  const std::set<std::pair<Index, Index>> along = edges_of(curve);
  UnionFind sides(triangles.size());
  for (const Index v : curve.vertices) {
    for (const Index t : mesh.star(v)) {
      for (const Index w : mesh.triangle(t)) {
        if (w == v || along.contains(std::minmax(v, w))) continue;
        const Index other = mesh.across(t, v, w);
        if (other != none) sides.join(place(t), place(other));
      }
    }
  }
  std::map<Index, std::vector<Triangle>> parts;
  for (const Index t : triangles) parts[sides.find(place(t))].push_back(mesh.triangle(t));
  std::vector<std::vector<Triangle>> result;
  for (auto& [root, part] : parts) result.push_back(std::move(part));
  return result;
}

bool has_single_fans(const EditableMesh& mesh, const std::vector<Index>& vertices) {
  return std::ranges::all_of(vertices, [&](Index v) { return mesh.fans(v).size() <= 1; });
}

// Puts the longest remaining rim of each rim that passed the vertices first. None where one is gone, or two
// were merged.
std::optional<std::size_t> put_old_first(std::vector<Rim>& rims, const std::vector<Index>& vertices,
                                         const Rims& before) {
  std::ranges::stable_sort(rims, std::ranges::greater{}, &Rim::size);
  std::set<Index> open;  // numbers of old rims that are still to be found
  for (const Index v : vertices) {
    if (before.of[v] != none) open.insert(before.of[v]);
  }
  std::size_t old = 0;
  for (std::size_t r = 0; r < rims.size(); ++r) {
    std::set<Index> here;
    for (const Index v : rims[r]) {
      if (before.of[v] != none) here.insert(before.of[v]);
    }
    if (here.size() > 1) return {};
    if (here.empty() || open.erase(*here.begin()) == 0) continue;
    std::rotate(rims.begin() + static_cast<std::ptrdiff_t>(old),
                rims.begin() + static_cast<std::ptrdiff_t>(r),
                rims.begin() + static_cast<std::ptrdiff_t>(r) + 1);
    ++old;
  }
  return open.empty() ? std::optional(old) : std::nullopt;
}

// Closes the rims, as far as possible.
bool close_rims(EditableMesh& mesh, std::span<const Rim> rims, std::size_t most, Change& change) {
  return std::ranges::all_of(rims, [&](const Rim& rim) {
    const Index before = mesh.places();
    if (rim.size() > most + 2 || !close_gap(mesh, rim)) return false;
    for (Index t = before; t < mesh.places(); ++t) change.added.push_back(t);
    return true;
  });
}

void undo(EditableMesh& mesh, const Change& change) {
  for (const Index t : change.added) mesh.remove(t);
  for (const Triangle& t : change.removed) mesh.add(t);
}

// Removes the triangles and closes the gaps.
std::optional<Change> replace(EditableMesh& mesh, Rims& rims, const std::vector<Triangle>& triangles,
                              std::size_t most) {
  Change change{triangles, {}};
  for (const Triangle& t : triangles) {
    const auto star = mesh.star(t[0]);
    mesh.remove(*std::ranges::find_if(star, [&](Index other) { return mesh.triangle(other) == t; }));
  }
  const std::vector<Index> vertices = vertices_of(triangles);
  if (has_single_fans(mesh, vertices)) {
    std::vector<Rim> after = walk_rims(mesh, vertices);
    for (const Rim& rim : after) rims.steps += rim.size();
    const auto old = put_old_first(after, vertices, rims);
    if (old && close_rims(mesh, std::span(after).subspan(*old), most, change) &&
        has_single_fans(mesh, vertices)) {
      for (std::size_t r = *old; r < after.size(); ++r) {
        for (const Index v : after[r]) rims.of[v] = none;
      }
      for (const Index v : vertices) rims.of[v] = none;
      for (std::size_t r = 0; r < *old; ++r) rims.put(after[r]);
      return change;
    }
  }
  undo(mesh, change);
  return {};
}

// The sets of triangles that may be removed, the smallest first: one side, or all at the curve.
std::vector<std::vector<Triangle>> ways_to_cut(const EditableMesh& mesh, const Curve& curve) {
  std::vector<std::vector<Triangle>> ways = sides_of(mesh, curve);
  std::ranges::stable_sort(ways, {}, &std::vector<Triangle>::size);
  if (ways.size() != 2) ways.clear();  // one-sided, or its sides overlap
  ways.push_back(triangles_at(mesh, curve.vertices));
  ways.push_back(triangles_at(mesh, vertices_of(ways.back())));
  return ways;
}

}  // namespace

void Rims::put(const Rim& rim) {
  for (const Index v : rim) of[v] = count;
  ++count;
}

std::optional<Change> cut(EditableMesh& mesh, Rims& rims, const Curve& curve, std::size_t most) {
  for (const std::vector<Triangle>& way : ways_to_cut(mesh, curve)) {
    if (way.size() > most) continue;
    if (auto change = replace(mesh, rims, way, most)) return change;
  }
  return {};
}

}  // namespace rimline
