// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/smooth_curve/likeliest_path.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "base/model.h"
#include "evidence/probability.h"

namespace rimline {
namespace {

// A candidate state: a point that the rim may visit.
struct State {
  double at;    // along the curve, in mean steps of the rim
  double odds;  // logarithm, by how far out it lies
  std::size_t projection;
  double best = -std::numeric_limits<double>::infinity();  // of all paths to here
  std::size_t before = 0;                                  // the state before on that path
};

// The states from the outermost projection once around and back to it. `line`: separates the first `count`
// projections from the others.
std::vector<State> find_states(const RimCurve& curve, const std::vector<Projection>& projections,
                               std::size_t count, double line, double noise) {
  constexpr double least_odds = model::path_least_odds;
  const std::vector<double> along = curve.running_count();
  const auto around = static_cast<double>(count);
  const auto position = [&](double t) {
    const double x = std::clamp(t / curve.period(), 0.0, 1.0) * static_cast<double>(along.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(x), along.size() - 2);
    const double here = along[i] + (x - static_cast<double>(i)) * (along[i + 1] - along[i]);
    return around * here / along.back();
  };
  const double start = position(projections[0].t);
  std::vector<State> states;
  for (std::size_t i = 1; i < projections.size(); ++i) {
    const double odds = blurred_log_odds(projections[i].out - line, noise);
    if (odds < least_odds) break;
    const double at = position(projections[i].t) - start;
    states.push_back({at < 0 ? at + around : at, odds, i});
  }
  std::sort(states.begin(), states.end(), [](const State& a, const State& b) {
    return std::tie(a.at, a.projection) < std::tie(b.at, b.projection);
  });
  states.insert(states.begin(), {0, 0, 0, 0});
  states.push_back({around, 0, 0});
  return states;
}

}  // namespace

std::vector<RimSample> likeliest_path(const RimCurve& curve, const std::vector<Projection>& projections,
                                      std::size_t count, double noise) {
  constexpr double uneven = model::path_uneven;
  constexpr double usual = model::path_usual_step;
  constexpr std::size_t farthest = 48;                 // states passed over [speed]
  const double variance = uneven + 2 * noise * noise;  // both ends of a step move
  const double line = 0.5 * (projections[count - 1].out + projections[count].out);
  std::vector<State> states = find_states(curve, projections, count, line, noise);
  for (std::size_t j = 1; j < states.size(); ++j) {
    for (std::size_t i = j - std::min(j, farthest); i < j; ++i) {
      const double off = states[j].at - states[i].at - 1;
      const double sum = states[i].best + states[j].odds + usual - off * off / (2 * variance);
      if (sum <= states[j].best) continue;
      states[j].best = sum;
      states[j].before = i;
    }
  }
  std::vector<Projection> path;
  for (std::size_t j = states.back().before;; j = states[j].before) {
    path.push_back(projections[states[j].projection]);
    if (j == 0) break;
  }
  return along_curve(path, path.size());
}

}  // namespace rimline
