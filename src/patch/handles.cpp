// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/handles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/union_find.h"
#include "patch/close_gap.h"
#include "patch/short_cycle.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

using Curve = std::vector<Index>;

constexpr std::size_t longest_curve = 8;  // edges: a few spacings
constexpr std::size_t least_budget = 24;  // triangles that a repair may take out of a small component

std::pair<Index, Index> edge_at(const Curve& curve, std::size_t i) {
  return {curve[i], curve[i + 1 < curve.size() ? i + 1 : 0]};
}

// Triangles that went and came, to be undone.
struct Change {
  std::vector<Triangle> removed;
  std::vector<Index> added;  // places
  std::size_t size() const { return removed.size(); }
};

void undo(EditableMesh& mesh, const Change& change) {
  for (const Index t : change.added) mesh.remove(t);
  for (const Triangle& t : change.removed) mesh.add(t);
}

// The triangles at the curve, parted into those that hang together at it without crossing it; of a curve with
// two sides there are two.
std::vector<std::vector<Triangle>> sides_of(const EditableMesh& mesh, const Curve& curve) {
  std::set<Index> around;
  for (const Index v : curve) around.insert(mesh.star(v).begin(), mesh.star(v).end());
  const std::vector<Index> triangles(around.begin(), around.end());
  const auto place = [&](Index t) {
    return static_cast<Index>(std::ranges::lower_bound(triangles, t) - triangles.begin());
  };
  std::set<std::pair<Index, Index>> along;
  for (std::size_t i = 0; i < curve.size(); ++i)
    along.insert(std::minmax(curve[i], edge_at(curve, i).second));
  UnionFind sides(triangles.size());
  for (const Index v : curve) {
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

// The rims that the change opened: none of its vertices was on one before.
std::vector<Curve> opened_rims(const EditableMesh& mesh, const Change& change) {
  std::vector<Index> vertices;
  for (const Triangle& t : change.removed) vertices.insert(vertices.end(), t.begin(), t.end());
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return walk_rims(mesh, vertices);
}

// Whether each vertex of the change has one fan.
bool has_single_fans(const EditableMesh& mesh, const Change& change) {
  return std::ranges::all_of(change.removed, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](Index v) { return mesh.fans(v).size() <= 1; });
  });
}

// Takes the triangles away and closes what opens; nothing, and the mesh as it was, where that makes no
// manifold or changes too much.
std::optional<Change> replace(EditableMesh& mesh, const std::vector<Triangle>& triangles,
                              std::size_t budget) {
  if (triangles.size() > budget) return {};
  Change change{triangles, {}};
  for (const Triangle& t : triangles) {
    const auto star = mesh.star(t[0]);
    mesh.remove(*std::ranges::find_if(star, [&](Index other) { return mesh.triangle(other) == t; }));
  }
  bool closed = has_single_fans(mesh, change);
  if (closed) {
    for (const Curve& rim : opened_rims(mesh, change)) {
      const Index before = mesh.places();
      closed = closed && close_gap(mesh, rim);
      for (Index t = before; t < mesh.places(); ++t) change.added.push_back(t);
    }
  }
  if (closed && has_single_fans(mesh, change)) return change;
  undo(mesh, change);
  return {};
}

// The curve's repair that changes least.
std::optional<Change> cut(EditableMesh& mesh, const Curve& curve, std::size_t budget) {
  std::vector<std::vector<Triangle>> ways = sides_of(mesh, curve);
  if (ways.size() != 2) {  // one-sided, or its sides are in one another's way: all that it passes goes
    for (std::size_t w = 1; w < ways.size(); ++w)
      ways[0].insert(ways[0].end(), ways[w].begin(), ways[w].end());
    ways.resize(1);
  }
  std::optional<std::size_t> best;
  std::size_t least = 0;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const std::optional<Change> change = replace(mesh, ways[w], budget);
    if (!change) continue;
    undo(mesh, *change);
    if (best && change->size() >= least) continue;
    best = w;
    least = change->size();
  }
  return best ? replace(mesh, ways[*best], budget) : std::nullopt;
}

// The rim of each vertex.
std::vector<Index> rims_of_vertices(const EditableMesh& mesh, const std::vector<Curve>& rims) {
  std::vector<Index> rim_of(mesh.vertices(), none);
  for (std::size_t r = 0; r < rims.size(); ++r) {
    for (const Index v : rims[r]) rim_of[v] = static_cast<Index>(r);
  }
  return rim_of;
}

bool touches_rim(const EditableMesh& mesh, const std::vector<Index>& rim_of, const Curve& curve) {
  return std::ranges::any_of(curve, [&](Index v) {
    return std::ranges::any_of(mesh.star(v), [&](Index t) {
      return std::ranges::any_of(mesh.triangle(t), [&](Index w) { return rim_of[w] != none; });
    });
  });
}

// Curves through one vertex of each handle, short ones looked for from their own vertices again.
// `left`: how many more trees may be grown.
std::vector<Curve> short_curves(const Capped& surface, Index vertex, std::size_t& left) {
  std::set<Curve> found;
  const auto look = [&](Index v) {
    CyclesAt cycles = cycles_at(surface, v);
    for (int again = 0; again < 2 && left > 0 && !cycles.shortest.empty(); ++again, --left) {
      const Index middle = cycles.shortest[cycles.shortest.size() / 2];
      const CyclesAt closer = cycles_at(surface, middle);
      if (closer.shortest.size() >= cycles.shortest.size()) break;
      cycles.shortest = closer.shortest;
    }
    if (!cycles.shortest.empty() && cycles.shortest.size() <= longest_curve) found.insert(cycles.shortest);
  };
  CyclesAt first = cycles_at(surface, vertex);
  if (first.shortest.empty()) return {};
  first.others.push_back(first.shortest.front());
  for (const Index v : first.others) {
    if (left == 0) break;
    --left;
    look(v);
  }
  std::vector<Curve> curves(found.begin(), found.end());
  std::ranges::stable_sort(curves, [](const Curve& a, const Curve& b) { return a.size() < b.size(); });
  return curves;
}

HandleRepair describe(const EditableMesh& mesh, const Curve& curve, const Change& change) {
  HandleRepair repair;
  repair.points = curve;
  for (const Index v : curve)
    repair.place = repair.place + (1.0 / static_cast<double>(curve.size())) * mesh.points()[v];
  repair.length = loop_length(mesh.points(), curve);
  repair.removed = change.removed.size();
  repair.added = change.added.size();
  return repair;
}

// Mends the component of a vertex, as long as short curves are found.
void repair_component(EditableMesh& mesh, const std::vector<Index>& rim_of, Index vertex,
                      std::size_t triangles, std::vector<HandleRepair>& repairs) {
  constexpr int most_rounds = 16;
  constexpr std::size_t work = 300'000;  // triangles looked at, so that no surface takes long
  std::size_t left = std::max<std::size_t>(8, work / triangles);
  const std::size_t budget = std::max(least_budget, triangles / 100);
  for (int round = 0; round < most_rounds; ++round) {
    bool mended = false;
    for (const Curve& curve : short_curves({mesh, rim_of}, vertex, left)) {
      if (touches_rim(mesh, rim_of, curve)) continue;
      const std::optional<Change> change = cut(mesh, curve, budget);
      if (!change) continue;
      repairs.push_back(describe(mesh, curve, *change));
      mended = true;
      break;  // other curves may have gone with it
    }
    if (!mended) return;
  }
}

}  // namespace

std::vector<HandleRepair> repair_handles(EditableMesh& mesh, const std::vector<std::vector<Index>>& rims) {
  const std::vector<Index> rim_of = rims_of_vertices(mesh, rims);
  const std::vector<Index> component = mesh.components();
  struct Count {
    Index vertex = none;
    long long vertices = 0, triangles = 0, rim = 0, rims = 0;
  };
  std::map<Index, Count> counts;
  for (const Index c : component) {
    if (c != none) ++counts[c].triangles;
  }
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (mesh.star(v).empty()) continue;
    Count& count = counts[component[mesh.star(v).front()]];
    ++count.vertices;
    count.rim += rim_of[v] != none;
    if (count.vertex == none) count.vertex = v;
  }
  for (const Curve& rim : rims) ++counts[component[mesh.star(rim.front()).front()]].rims;
  std::vector<HandleRepair> repairs;
  for (const auto& [c, count] : counts) {
    const long long edges = (3 * count.triangles + count.rim) / 2;
    if (count.vertices - edges + count.triangles + count.rims == 2) continue;  // a sphere, once it is capped
    repair_component(mesh, rim_of, count.vertex, static_cast<std::size_t>(count.triangles), repairs);
  }
  return repairs;
}

}  // namespace rimline
