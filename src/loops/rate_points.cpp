// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/rate_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/model.h"
#include "base/vec.h"
#include "evidence/cut_plane.h"
#include "evidence/jaggedness.h"
#include "evidence/probability.h"

namespace rimline {
namespace {

// The probability that a point is on the boundary, by one visit of a rim.
struct Rating {
  Index point;
  double probability;
};

std::vector<float> raised(std::vector<float> probability, const std::vector<Rating>& ratings) {
  for (const auto& [point, p] : ratings)
    probability[point] = std::max(probability[point], static_cast<float>(p));
  return probability;
}

// For the points of a rim, and for those behind its edges, which would be on it if their triangles were
// removed.
std::vector<Rating> rate_rim(const Loop& rim, const RimEvidence& e, const LocalSizes& sizes,
                             const BoundaryScores& scores) {
  constexpr model::FitnessModel weights;
  const auto rate = [&](Index id, bool on_rim, const std::array<Index, 5>& run) {  // [layout]
    const double chi_square = scores.log_score[id];
    if (e.sampling.is_range_image)
      return Rating{id, range_image_point_probability(on_rim, chi_square, rim.probability)};
    const double odds = ear_log_odds(e.set, sizes, weights, run);
    return Rating{id, point_probability(odds, on_rim, chi_square, rim.probability)};
  };
  const auto& ids = rim.points;
  const std::size_t n = ids.size();
  std::vector<Rating> ratings;
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<Index, 5> run{ids[(i + n - 2) % n], ids[(i + n - 1) % n], ids[i],  // [layout]
                                   ids[(i + 1) % n],                                    // [layout]
                                   ids[(i + 2) % n]};
    ratings.push_back(rate(ids[i], true, run));
    const Index inner = e.set.apex(selected_triangle(e.set, e.selection, run[2], run[3]), run[2], run[3]);
    ratings.push_back(rate(inner, false, {run[1], run[2], inner, run[3], run[4]}));
  }
  return ratings;
}

// Points behind a jagged rim would be on it if all its false ears had been found.
std::vector<Rating> rate_behind_jagged(const Loop& rim, const RimEvidence& e, const LocalSizes& sizes,
                                       const CornerHistogram& corners) {
  const auto& ids = rim.points;
  const std::vector<double> jagged = jaggedness(e.samples.points, ids);
  std::vector<Rating> ratings;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (jagged[i] == 0) continue;
    ratings.push_back({ids[i], on_jagged_rim(jagged[i], rim.probability)});
    const Index a = ids[i], b = ids[next_in(i, ids.size())];
    const Index behind = e.set.apex(selected_triangle(e.set, e.selection, a, b), a, b);
    const double odds =
        false_ear_log_odds(measure_false_ear(e.set, sizes, corners, {a, behind, b}, jagged[i]));
    ratings.push_back({behind, jagged_point_probability(odds, jagged[i], rim.probability)});
    for (const Index t : e.set.star(a)) {
      if (!e.selection[t]) continue;
      for (const Index v : e.set.triangle(t))
        ratings.push_back({v, behind_jagged_point(jagged[i], rim.probability)});
    }
  }
  return ratings;
}

}  // namespace

std::vector<float> rate_points(const std::vector<Loop>& rims, const RimEvidence& e, const LocalSizes& sizes,
                               const CornerHistogram& corners, const BoundaryScores& scores) {
  std::vector<float> probability(e.samples.points.size(), static_cast<float>(far_from_rims()));
  for (const Loop& rim : rims) {
    probability = raised(std::move(probability), rate_rim(rim, e, sizes, scores));
    if (!e.sampling.is_range_image)
      probability = raised(std::move(probability), rate_behind_jagged(rim, e, sizes, corners));
  }
  if (!e.sampling.is_range_image) return probability;
  for (Index v = 0; v < e.set.vertices(); ++v) {
    if (e.set.star(v).empty()) probability[v] = range_image_isolated_probability();
  }
  return probability;
}

std::vector<float> raise_at_cuts(std::vector<float> probability, const std::vector<Loop>& boundaries,
                                 const Samples& s) {
  for (const Loop& loop : boundaries) {
    const auto plane = CutPlane::find(s.points, s.neighbours, s.spacing, s.frames, loop.points);
    if (!plane) continue;
    const std::vector<double> jagged = jaggedness(s.points, loop.points);
    std::vector<Rating> ratings;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const double p = at_cut_probability(jagged[i], loop.probability);
      for (const Index v : s.neighbours.of(loop.points[i])) {
        if (probability[v] >= p) continue;
        if (plane->depth(s.points, s.neighbours, s.spacing, s.frames, v) < model::cut_depth)
          ratings.push_back({v, p});
      }
    }
    probability = raised(std::move(probability), ratings);
  }
  return probability;
}

std::vector<Loop> with_fitness(std::vector<Loop> loops, const std::vector<float>& probability,
                               double length_exponent) {
  for (Loop& loop : loops) {
    double sum = 0;
    for (const Index id : loop.points)
      sum -= std::log1p(-std::min(0.999999, double{probability[id]}));  // [guard]
    loop.fitness = sum / std::pow(static_cast<double>(loop.points.size()), length_exponent);
  }
  return loops;
}

}  // namespace rimline
