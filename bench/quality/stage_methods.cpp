// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of the default, by its stages, with the search as it is, without it, and by local evidence alone:
// what each step adds.
#include <chrono>

#include "exact/frame.h"
#include "exact/star.h"
#include "quality/arcs.h"
#include "quality/method.h"
#include "rimline/arrange.h"
#include "rimline/boundary.h"
#include "rimline/exact_loops.h"
#include "rimline/options.h"

namespace rimline::bench {
namespace {

Run one_thread() {
  Run run;
  run.threads = 1;
  return run;
}

// What the stages before the loops give.
struct Prepared {
  Arrangement arrangement;
  Neighbours neighbours;
};

Prepared prepare(const Case& c) {
  const int k = BoundaryOptions{}.k;
  Prepared p{arrange(c.points, one_thread()), {}};
  p.neighbours = find_neighbours(p.arrangement.points, k, one_thread());
  if (leave_out_stray(p.arrangement, p.neighbours)) {
    p.neighbours = find_neighbours(p.arrangement.points, k, one_thread());
  }
  return p;
}

void take_loops(LoopIds loops, const Arrangement& arrangement, Outcome& outcome) {
  for (auto& loop : loops) {
    for (Index& id : loop) id = arrangement.ids[id];
  }
  outcome.loops = std::move(loops);
  outcome.boundary = points_of(outcome.loops);
}

void find_exact(const Case& c, const ExactLoopOptions& options, Outcome& outcome) {
  const Prepared p = prepare(c);
  const auto scores = score_boundary(p.arrangement.points, p.neighbours, {}, one_thread());
  const BoundarySurvey found =
      find_exact_loops(p.arrangement.points, p.neighbours, scores, options, one_thread());
  LoopIds loops;
  for (const Loop& loop : found.loops) loops.push_back(loop.points);
  take_loops(std::move(loops), p.arrangement, outcome);
  outcome.probability.assign(c.points.size(), std::numeric_limits<float>::quiet_NaN());
  outcome.label.assign(c.points.size(), static_cast<std::uint8_t>(PointLabel::Stray));
  for (std::size_t i = 0; i < p.arrangement.ids.size(); ++i) {
    outcome.probability[p.arrangement.ids[i]] = found.probability[i];
    outcome.label[p.arrangement.ids[i]] = static_cast<std::uint8_t>(found.label[i]);
  }
}

void find_arcs(const Case& c, Outcome& outcome) {
  const Prepared p = prepare(c);
  const auto& points = p.arrangement.points;
  const auto spacing = local_spacing(p.neighbours);
  const auto frames = exact::fit_frames(points, p.neighbours, one_thread());
  const auto stars = exact::find_stars(points, p.neighbours, spacing, frames, one_thread());
  take_loops(closed_arcs(mutual_edges(points, stars, spacing)), p.arrangement, outcome);
}

template <class Find>
Method stage(std::string id, std::string title, Find find) {
  Method method;
  method.id = std::move(id);
  method.title = std::move(title);
  method.finds_boundary = true;
  method.run = [find](const Case& c, bool) {
    Outcome outcome;
    outcome.has_loops = true;
    const auto start = std::chrono::steady_clock::now();
    try {
      find(c, outcome);
    } catch (const Error& error) {
      outcome.error = error.what();
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
  };
  return method;
}

}  // namespace

std::vector<Method> stage_methods() {
  ExactLoopOptions without_search;
  without_search.generations = 0;
  std::vector<Method> methods;
  methods.push_back(stage("exact", "exact loops", [](const Case& c, Outcome& o) { find_exact(c, {}, o); }));
  methods.push_back(
      stage("greedy", "greedy join", [=](const Case& c, Outcome& o) { find_exact(c, without_search, o); }));
  methods.push_back(stage("arcs", "arcs alone", find_arcs));
  return methods;
}

}  // namespace rimline::bench
