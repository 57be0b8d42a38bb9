// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/smooth_loops.h"

#include <algorithm>

#include "base/model.h"
#include "base/vec.h"
#include "evidence/probability.h"
#include "loops/smooth_curve/smooth_loop.h"
#include "rimline/find_genetic_loop.h"

namespace rimline {
namespace {

// Normals of the triangles at its edges.
std::vector<Point> normals_along(const Loop& loop, const RimEvidence& e) {
  const Points points = e.samples.points;
  const std::size_t n = loop.points.size();
  std::vector<Point> normals;
  for (std::size_t i = 0; i < n; ++i) {
    const Triangle& t =
        e.set.triangle(selected_triangle(e.set, e.selection, loop.points[i], loop.points[(i + 1) % n]));
    const Point normal = triangle_normal(points, t);
    normals.push_back((1 / std::max(norm(normal), 1e-300)) * normal);
  }
  return normals;
}

}  // namespace

SmoothedLoops smooth_loops(const std::vector<Loop>& loops, const std::vector<float>& probability,
                           const RimEvidence& e, const Run& run) {
  constexpr double most = model::smooth_most_length;
  const NoiseModel& noise = e.sampling.noise;
  SmoothedLoops result{loops, probability};
  if (noise.noise == 0 && noise.irregular == 0) return result;
  const bool moves_loops = noise.noise > 0 && (!e.sampling.is_random() || noise.anisotropic);
  std::vector<std::uint8_t> taken(e.samples.points.size(), 0);
  const auto mark = [&](const std::vector<Index>& ids, std::uint8_t value) {
    for (const Index id : ids) taken[id] = value;
  };
  for (const Loop& loop : loops) mark(loop.points, 1);
  for (Loop& loop : result.loops) {
    const SmoothedLoop drawn = smooth_loop(e.samples.points, e.samples.neighbours, e.samples.spacing,
                                           loop.points, normals_along(loop, e), noise, run);
    if (drawn.loop.empty()) continue;
    const double length = loop_length(e.samples.points, drawn.loop);
    mark(loop.points, 0);
    const bool meets = std::any_of(drawn.loop.begin(), drawn.loop.end(), [&](Index id) { return taken[id]; });
    if (!meets && length <= most * loop.length) {
      for (std::size_t i = 0; i < drawn.near.size(); ++i) {
        result.probability[drawn.near[i]] =
            static_cast<float>(blurred_probability(drawn.depth[i], noise.noise, loop.probability));
      }
      if (moves_loops) {
        loop.points = drawn.loop;
        loop.length = length;
      }
    }
    mark(loop.points, 1);
  }
  return result;
}

}  // namespace rimline
