// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/theory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boundary/chi_square.h"
#include "boundary/sectors.h"
#include "local/neighbourhood.h"

namespace rimline::bench {
namespace {

constexpr double pi = std::numbers::pi;

// Calls visit(point, neighbourhoods, axes, lane) for every point of the set.
template <class Visit>
void visit_neighbourhoods(const PointSet& set, int k, const Visit& visit) {
  Neighbourhoods around(k);
  PrincipalAxesLanes axes;
  const auto count = static_cast<Index>(set.points.size());
  for (Index first = 0; first < count; first += lanes) {
    around.gather(set.points, set.neighbours, first, count);
    around.find_axes(axes);
    around.flatten(axes);
    for (Index i = first; i < std::min(first + lanes, count); ++i) visit(i, around, axes, i - first);
  }
}

// The points in each of `sectors` sectors, for one lane.
std::vector<int> counts_of(const Neighbourhoods& around, int sectors, int lane) {
  std::vector<Lanes> lanes_of(sectors);
  Sectors(sectors).count(around.u(), around.v(), lanes_of);
  std::vector<int> counts;
  for (const Lanes& count : lanes_of) counts.push_back(static_cast<int>(count[lane]));
  return counts;
}

// The widest angle at a point in which none of its neighbours lies, seen on its least squares plane.
double widest_gap(const PointSet& set, Index point, int k, const PrincipalAxes& axes) {
  std::vector<double> angles;
  for (const Index q : set.neighbours.of(point, k)) {
    const Point offset = set.points[q] - set.points[point];
    angles.push_back(std::atan2(dot(offset, axes.v[1]), dot(offset, axes.v[2])));
  }
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return gap;
}

}  // namespace

BoundaryScores turned_scores(const PointSet& set, const BoundaryOptions& options) {
  BoundaryScores scores;
  const int k = std::min(options.k, set.neighbours.k);
  visit_neighbourhoods(
      set, k, [&](Index, const Neighbourhoods& around, const PrincipalAxesLanes& axes, int l) {
        const std::vector<int> halves = counts_of(around, 2 * options.sectors, l);
        std::vector<int> counts;
        for (std::size_t i = 1; i < halves.size(); i += 2)
          counts.push_back(halves[i] + halves[(i + 1) % halves.size()]);
        scores.log_score.push_back(negative_log_survival(pearson_statistic(counts), options.sectors - 1));
        scores.candidate.push_back(scores.log_score.back() >= -std::log(options.significance));
        scores.delta.push_back(static_cast<float>(delta(axes.of(l))));
      });
  return scores;
}

nlohmann::ordered_json measure_theory(const PointSet& set, const BoundaryScores& scores,
                                      const BoundaryOptions& options) {
  if (set.rim.empty()) return nullptr;
  std::vector<char> on_rim(set.points.size(), 0);
  for (const Index i : set.rim) on_rim[i] = 1;
  const int k = std::min(options.k, set.neighbours.k);
  double recall = 0, empty = 0, opening = pi;
  visit_neighbourhoods(set, k,
                       [&](Index i, const Neighbourhoods& around, const PrincipalAxesLanes& axes, int l) {
                         if (on_rim[i] == 0) return;
                         recall += scores.candidate[i];
                         const std::vector<int> counts = counts_of(around, options.sectors, l);
                         empty += *std::min_element(counts.begin(), counts.end()) == 0;
                         opening = std::min(opening, widest_gap(set, i, k, axes.of(l)));
                       });
  const auto rim = static_cast<double>(set.rim.size());
  const double least_delta = *std::min_element(scores.delta.begin(), scores.delta.end());
  return {{"rim_points", set.rim.size()},
          {"recall", recall / rim},
          {"empty_sector", empty / rim},
          {"delta", least_delta},
          {"R", opening},
          {"r", 4 * pi / (least_delta * opening)},
          {"candidates", std::count(scores.candidate.begin(), scores.candidate.end(), 1)}};
}

}  // namespace rimline::bench
