// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch/handles.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "patch/short_cycle.h"
#include "patch/surgery.h"
#include "patch/vicinity.h"

namespace rimline {
namespace {

constexpr std::size_t longest_curve = 8;  // edges: a few spacings
constexpr std::size_t narrow_band = 2;    // edges across, from rim to rim
constexpr std::size_t widest_band = 3;    // likewise, where few triangles go with it
constexpr std::size_t least_budget = 24;  // triangles that a repair may take out of a small component

// Curves through one vertex of each handle; short ones are searched again from their own vertices. `left`:
// the remaining number of trees.
std::vector<std::vector<Index>> short_curves(const Capped& surface, const std::vector<Index>& vertices,
                                             std::size_t& left) {
  std::set<std::vector<Index>> found;
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
  for (const Index v : vertices) {
    if (left == 0) break;
    --left;
    look(v);
  }
  std::vector<std::vector<Index>> curves(found.begin(), found.end());
  std::ranges::stable_sort(curves, {}, &std::vector<Index>::size);
  return curves;
}

HandleRepair describe(const EditableMesh& mesh, const Curve& curve, const Change& change) {
  HandleRepair repair;
  repair.points = curve.vertices;
  for (const Index v : curve.vertices)
    repair.place = repair.place + (1.0 / static_cast<double>(curve.vertices.size())) * mesh.points()[v];
  for (std::size_t i = curve.is_closed ? 0 : 1; i < curve.vertices.size(); ++i) {
    const Index before = curve.vertices[i == 0 ? curve.vertices.size() - 1 : i - 1];
    repair.length += distance(mesh.points()[before], mesh.points()[curve.vertices[i]]);
  }
  repair.removed = change.removed.size();
  repair.added = change.added.size();
  return repair;
}

// A component, and the remaining budget of its repair.
struct Budget {
  std::size_t triangles;  // triangles that a repair may remove
  std::size_t
      hundredth;      // of the component's triangles: as many across bands that a strip may have all along
  std::size_t trees;  // remaining trees over the whole component, so that no surface takes long
  std::size_t looks;  // remaining searches of vicinities
  std::size_t steps;  // vertices of rims that all cuts may walk along

  bool is_spent(const Rims& rims) const { return looks == 0 || rims.steps >= steps; }
};

// Cuts along the curve, where it is short enough and that can be done.
bool mend(EditableMesh& mesh, const Curve& curve, const Budget& budget, Rims& rims,
          std::vector<HandleRepair>& repairs) {
  const std::size_t edges = curve.vertices.size() - (curve.is_closed ? 0 : 1);
  if (budget.is_spent(rims) || curve.vertices.size() < 2 ||
      edges > (curve.is_closed ? longest_curve : widest_band))
    return false;
  const bool is_wide = !curve.is_closed && edges > narrow_band;
  const auto change = cut(mesh, rims, curve, is_wide ? budget.hundredth : budget.triangles);
  if (change) repairs.push_back(describe(mesh, curve, *change));
  return change.has_value();
}

using Curves = std::vector<std::vector<Index>>;

// Cuts along the first curve for which that succeeds.
bool mend_by_any(EditableMesh& mesh, const Curves& curves, bool are_closed, const Budget& budget, Rims& rims,
                 std::vector<HandleRepair>& repairs) {
  return std::ranges::any_of(curves, [&](const std::vector<Index>& curve) {
    return mend(mesh, {curve, are_closed}, budget, rims, repairs);
  });
}

// Repairs small handles, near the vertices.
bool mend_near(EditableMesh& mesh, const std::vector<Index>& vertices, Budget& budget, Rims& rims,
               std::vector<HandleRepair>& repairs, const Run& run) {
  constexpr int width = 5;  // edges
  bool mended = false;
  for (const Index v : vertices) {
    run.check_cancel();
    for (bool again = true; again && !budget.is_spent(rims) && !mesh.star(v).empty(); --budget.looks) {
      const Vicinity vicinity = vicinity_of(mesh, v, width);
      const std::vector<Index> cycle = short_cycle_in(vicinity);
      again = mend(mesh, {cycle, true}, budget, rims, repairs) ||
              mend_by_any(mesh, arcs_in(vicinity, rims.of), false, budget, rims, repairs) ||
              (!cycle.empty() && mend_by_any(mesh, more_cycles_in(vicinity), true, budget, rims, repairs));
      mended = mended || again;
    }
  }
  return mended;
}

// Repairs one handle that is thin but long.
bool mend_far(EditableMesh& mesh, const std::vector<Index>& part, const std::vector<Index>& vertices,
              Budget& budget, Rims& rims, std::vector<HandleRepair>& repairs) {
  for (const Rim& rim : walk_rims(mesh, part)) {
    if (budget.trees == 0) return false;
    --budget.trees;
    if (mend_by_any(mesh, arcs_at({mesh, rims.of}, rim), false, budget, rims, repairs)) return true;
  }
  return mend_by_any(mesh, short_curves({mesh, rims.of}, vertices, budget.trees), true, budget, rims,
                     repairs);
}

// One vertex on each closed curve that bounds nothing in the component of `vertex`.
std::vector<Index> curve_vertices(const EditableMesh& mesh, const Rims& rims, Index vertex, Budget& budget) {
  if (budget.trees == 0) return {};
  --budget.trees;
  CyclesAt cycles = cycles_at({mesh, rims.of}, vertex);
  if (!cycles.shortest.empty()) cycles.others.push_back(cycles.shortest.front());
  return cycles.others;
}

// A component of the mesh.
struct Part {
  std::vector<Index> vertices;
  std::size_t triangles = 0;
};

std::vector<Part> parts_of(const EditableMesh& mesh) {
  const std::vector<Index> component = mesh.components();
  std::vector<Part> parts;
  for (const Index c : component) {
    if (c == none) continue;
    parts.resize(std::max(parts.size(), static_cast<std::size_t>(c) + 1));
    ++parts[c].triangles;
  }
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (!mesh.star(v).empty()) parts[component[mesh.star(v).front()]].vertices.push_back(v);
  }
  return parts;
}

// 2 less its Euler number, once its rims are capped: 0 for a sphere, 2 for each handle.
std::size_t lack_of_euler(const Part& part, const std::vector<Rim>& rims) {
  std::size_t open = 0;
  for (const Rim& rim : rims) open += rim.size();
  const std::size_t edges = (3 * part.triangles + open) / 2;
  return edges + 2 - (part.vertices.size() + part.triangles + rims.size());
}

// Whether handles are so many, one for fifty points, that repairs of small ones make no surface of it.
bool is_hopeless(const Part& part, std::size_t lack) {
  constexpr std::size_t points_a_handle = 50, few = 32;
  return lack > 2 * few && lack * points_a_handle > 2 * part.vertices.size();
}

// Repairs a component until nothing is found.
void repair_part(EditableMesh& mesh, const Part& part, std::vector<HandleRepair>& repairs, const Run& run) {
  // Bounds for hopeless clouds: a leaf with 28 folds takes 132 vicinities and 17,600 vertices of rims, a
  // shredded frame of 10,000 points would take 2,500 and 10 million.
  constexpr std::size_t work = 2'000'000;                          // triangles looked at
  constexpr std::size_t least_looks = 1000, most_looks = 5000;     // vicinities
  constexpr std::size_t least_steps = 200'000, per_triangle = 10;  // vertices of rims
  const std::vector<Rim> before = walk_rims(mesh, part.vertices);
  const std::size_t lack = lack_of_euler(part, before);
  if (lack == 0 || is_hopeless(part, lack)) return;
  Rims rims(mesh.vertices());
  for (const Rim& rim : before) rims.put(rim);
  Budget budget{std::max(least_budget, part.triangles / 100), part.triangles / 100,
                std::max<std::size_t>(8, work / part.triangles),
                std::clamp(part.triangles / 20, least_looks, most_looks),
                std::max(least_steps, per_triangle * part.triangles)};
  for (std::size_t left = part.triangles; !budget.is_spent(rims);) {
    const auto first = std::ranges::find_if(part.vertices, [&](Index v) { return !mesh.star(v).empty(); });
    if (first == part.vertices.end()) return;
    const std::vector<Index> vertices = curve_vertices(mesh, rims, *first, budget);
    if (vertices.empty() || vertices.size() >= left) return;  // the number must fall in each round
    left = vertices.size();
    if (!mend_near(mesh, vertices, budget, rims, repairs, run) &&
        !mend_far(mesh, part.vertices, vertices, budget, rims, repairs))
      return;
  }
}

}  // namespace

std::vector<HandleRepair> repair_handles(EditableMesh& mesh, const Run& run) {
  std::vector<HandleRepair> repairs;
  for (const Part& part : parts_of(mesh)) repair_part(mesh, part, repairs, run);
  return repairs;
}

}  // namespace rimline
