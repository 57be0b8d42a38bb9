// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/measure_components.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/model.h"
#include "base/parallel.h"

namespace rimline {
namespace {

// Adds to a shared sum: integers give the same sum in any order.
void add(std::size_t& sum, std::size_t count) {
  if (count != 0) std::atomic_ref(sum).fetch_add(count, std::memory_order_relaxed);
}

struct Counts {
  std::vector<std::size_t> triangles, edges_twice;  // per component
};

Counts count_triangles(const TriangleSet& set, const Selection& selection, const Components& components,
                       const Run& run) {
  Counts sum{std::vector<std::size_t>(components.count(), 0),
             std::vector<std::size_t>(components.count(), 0)};
  parallel_slices(set.size(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    std::size_t triangles = 0, edges = 0;
    for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t) {
      if (!selection[t]) continue;
      const Index c = components.of_triangle[t];
      ++triangles;
      for (int k = 0; k < 3; ++k) {
        const Index other = set.across(t, k);
        edges += other != none && selection[other] ? 1 : 2;
      }
      if (static_cast<std::size_t>(t) + 1 < end && components.of_triangle[t + 1] == c) continue;
      add(sum.triangles[c], std::exchange(triangles, 0));
      add(sum.edges_twice[c], std::exchange(edges, 0));
    }
  });
  return sum;
}

// Calls visit(c) for each component that a vertex is on; `here` is room for them.
template <class Visit>
void for_each_component_at(Index v, const TriangleSet& set, const Components& components,
                           std::vector<Index>& here, const Visit& visit) {
  here.clear();
  Index newest = none;  // most triangles are on the same component as the one before
  for (const Index t : set.star(v)) {
    const Index c = components.of_triangle[t];
    if (c == none || c == newest || std::find(here.begin(), here.end(), c) != here.end()) continue;
    newest = c;
    here.push_back(c);
    visit(c);
    if (static_cast<Index>(here.size()) == components.count()) break;  // there are no others
  }
}

std::vector<std::size_t> count_points(const TriangleSet& set, const Components& components, const Run& run) {
  std::vector<std::size_t> sum(components.count(), 0);
  parallel_slices(set.vertices(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> here;
    Index last = none;
    std::size_t points = 0;  // on the last of them
    for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
      for_each_component_at(v, set, components, here, [&](Index c) {
        if (c != last && last != none) add(sum[last], std::exchange(points, 0));
        last = c;
        ++points;
      });
    }
    if (last != none) add(sum[last], points);
  });
  return sum;
}

}  // namespace

bool is_surface(const SurfaceComponent& component) { return component.triangles >= model::surface_least; }

std::vector<SurfaceComponent> measure_components(const TriangleSet& set, const Selection& selection,
                                                 const Components& components, const Run& run) {
  const Counts counts = count_triangles(set, selection, components, run);
  const std::vector<std::size_t> points = count_points(set, components, run);
  std::vector<SurfaceComponent> result(components.count());
  for (Index c = 0; c < components.count(); ++c) {
    result[c].points = points[c];
    result[c].triangles = counts.triangles[c];
    result[c].orientable = components.orientable[c];
    result[c].euler = static_cast<long long>(points[c]) - static_cast<long long>(counts.edges_twice[c] / 2) +
                      static_cast<long long>(counts.triangles[c]);
  }
  return result;
}

std::vector<PointLabel> label_stray_points(const TriangleSet& set, const Components& components,
                                           const std::vector<SurfaceComponent>& measured, const Run& run) {
  std::vector<PointLabel> label(set.vertices());
  parallel_slices(set.vertices(), Stage::Loops, run, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v) {
      const auto star = set.star(v);
      const bool on_surface = std::any_of(star.begin(), star.end(), [&](Index t) {
        const Index c = components.of_triangle[t];
        return c != none && is_surface(measured[c]);
      });
      label[v] = on_surface ? PointLabel::Interior : PointLabel::Stray;
    }
  });
  return label;
}

}  // namespace rimline
