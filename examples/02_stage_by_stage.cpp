// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's method, one stage a line. Every stage can be called alone, and its result looked at.
#include <rimline/arrange.h>
#include <rimline/delaunay.h>
#include <rimline/find_genetic_loop.h>
#include <rimline/map_to_disc.h>
#include <rimline/neighbours.h>
#include <rimline/sample.h>
#include <rimline/score_boundary.h>

#include <algorithm>
#include <cstdio>

using namespace rimline;

int main() {
  const Run run{.seed = 7};
  const Options options = preset_options(Preset::PaperLog);
  const Sample cap = sample({.shape = Shape::HemisphereCap, .n = 2000}, run);

  const Arrangement arranged = arrange(cap.points, run);  // finite, distinct, in Morton order
  const std::vector<Point>& points = arranged.points;
  const Neighbours neighbours = find_neighbours(points, most_neighbours(options), run);     // Definition 2.1
  const BoundaryScores scores = score_boundary(points, neighbours, options.boundary, run);  // eq. (1)
  const GeneticLoop found = find_genetic_loop(points, neighbours, scores, options.loops, run);  // eq. (3)
  const DiscMap map = map_to_disc(points, neighbours, found.loop.points, options.map, run);     // eq. (4)
  const std::vector<Triangle> triangles = delaunay(map.uv, run);

  const auto candidates = std::count(scores.candidate.begin(), scores.candidate.end(), 1);
  const auto on_rim = std::count_if(found.loop.points.begin(), found.loop.points.end(),
                                    [&](Index i) { return cap.boundary[arranged.ids[i]] == 1; });
  std::printf("%ld candidates of %zu points\n", static_cast<long>(candidates), points.size());
  std::printf("a loop of %zu points, %ld of them on the true rim\n", found.loop.points.size(),
              static_cast<long>(on_rim));
  std::printf("%zu triangles, residual %.1e\n", triangles.size(), map.summary.residual);
  return 2 * on_rim > static_cast<long>(found.loop.points.size()) ? 0 : 1;
}
