// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/classify.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/model.h"
#include "base/vec.h"
#include "surface/measure_components.h"

namespace rimline {
namespace {

// Score of a loop as the outer one of its component: its extent, times e where the surface lies inside it and
// flat, over e where it lies around it.
double outer_rank(const Loop& loop, const RimEvidence& e) {
  const Points points = e.samples.points;
  const Point origin = points[loop.points[0]];
  Point low = origin, high = origin, area, normal;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Index a = loop.points[i], b = loop.points[next_in(i, loop.points.size())];
    const Point p = points[a];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    area = area + 0.5 * cross(p - origin, points[b] - origin);
    const Triangle& t = e.set.triangle(selected_triangle(e.set, e.selection, a, b));
    const Point n = triangle_normal(points, t);
    normal = normal + (distance(p, points[b]) / std::max(norm(n), 1e-300)) * n;
  }
  // -1 for a flat hole, 1 for a flat outline, 0 where the surface is perpendicular to the loop's plane.
  const double lies = dot(area, normal) / std::max(norm(area) * loop.length, 1e-300);
  return distance(low, high) * std::exp(lies);
}

bool is_boundary(const Loop& loop, const std::vector<SurfaceComponent>& components,
                 const BoundaryLoopOptions& options) {
  return static_cast<int>(loop.points.size()) >= options.min_loop &&
         loop.probability >= options.min_probability && is_surface(components[loop.component]);
}

// Assigns kinds to boundaries.
std::vector<Loop> with_kinds(std::vector<Loop> boundaries, std::size_t components,
                             const RimEvidence& evidence) {
  std::vector<double> best(components, -1);
  std::vector<Loop*> outer(components, nullptr);
  for (Loop& loop : boundaries) {
    loop.kind = LoopKind::Hole;
    const double rank = outer_rank(loop, evidence);
    if (rank <= best[loop.component]) continue;
    best[loop.component] = rank;
    outer[loop.component] = &loop;
  }
  for (Loop* loop : outer) {
    if (loop != nullptr) loop->kind = LoopKind::Outer;
  }
  return boundaries;
}

// The component with most points of those that have a boundary, or none.
Index largest_component(const std::vector<Loop>& boundaries,
                        const std::vector<SurfaceComponent>& components) {
  Index largest = none;
  for (const Loop& loop : boundaries) {
    if (largest == none || components[loop.component].points > components[largest].points)
      largest = loop.component;
  }
  return largest;
}

}  // namespace

std::vector<Loop> doubtful_gaps(const std::vector<Loop>& gaps,
                                const std::vector<SurfaceComponent>& components,
                                const BoundaryLoopOptions& options) {
  BoundaryLoopOptions wider = options;
  wider.min_probability = std::min(model::doubtful_gap, options.min_probability);
  wider.min_loop = std::min(model::doubtful_least, options.min_loop);
  std::vector<Loop> found;
  for (const Loop& gap : gaps) {
    if (!is_boundary(gap, components, options) && is_boundary(gap, components, wider)) found.push_back(gap);
  }
  std::sort(found.begin(), found.end(), [](const Loop& a, const Loop& b) {
    return std::tuple(-a.probability, -a.length, a.points) < std::tuple(-b.probability, -b.length, b.points);
  });
  return found;
}

bool is_closed(const std::vector<Loop>& boundaries, const std::vector<Loop>& doubtful,
               const std::vector<SurfaceComponent>& components, std::size_t points) {
  std::size_t on_surfaces = 0;
  for (const SurfaceComponent& c : components) on_surfaces += is_surface(c) ? c.points : 0;
  return boundaries.empty() && doubtful.empty() && 2 * on_surfaces > points;
}

ClassifiedLoops classify_loops(const std::vector<Loop>& loops,
                               const std::vector<SurfaceComponent>& components, const RimEvidence& evidence,
                               const BoundaryLoopOptions& options) {
  ClassifiedLoops result;
  std::vector<Loop> found;
  for (const Loop& loop : loops)
    (is_boundary(loop, components, options) ? found : result.gaps).push_back(loop);
  const Index largest = largest_component(found, components);
  for (Loop& loop : with_kinds(std::move(found), components.size(), evidence)) {
    const bool is_wanted = options.loop_policy == LoopPolicy::All ||
                           (loop.kind == LoopKind::Outer &&
                            (options.loop_policy != LoopPolicy::Largest || loop.component == largest));
    (is_wanted ? result.boundaries : result.gaps).push_back(std::move(loop));
  }
  std::sort(result.boundaries.begin(), result.boundaries.end(), [](const Loop& a, const Loop& b) {
    return std::tuple(a.component, a.kind == LoopKind::Hole, -a.length, a.points) <
           std::tuple(b.component, b.kind == LoopKind::Hole, -b.length, b.points);
  });
  return result;
}

}  // namespace rimline
