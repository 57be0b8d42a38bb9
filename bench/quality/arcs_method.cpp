// SPDX-License-Identifier: GPL-3.0-or-later
// Local evidence alone, before the default joins anything: what its later steps are measured against.
#include <chrono>

#include "local/frame.h"
#include "local/star.h"
#include "quality/arcs.h"
#include "quality/method.h"
#include "rimline/arrange.h"
#include "rimline/options.h"
#include "rimline/score_boundary.h"

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

void find_arcs(const Case& c, Outcome& outcome) {
  const Prepared p = prepare(c);
  const auto& points = p.arrangement.points;
  const auto spacing = local_spacing(points, p.neighbours);
  const auto frames = fit_frames(points, p.neighbours, one_thread());
  const auto stars = find_stars(points, p.neighbours, spacing, frames, one_thread());
  take_loops(closed_arcs(mutual_edges(points, stars, spacing)), p.arrangement, outcome);
}

Outcome run_arcs(const Case& c, bool) {
  Outcome outcome;
  outcome.has_loops = true;
  const auto start = std::chrono::steady_clock::now();
  try {
    find_arcs(c, outcome);
  } catch (const Error& error) {
    outcome.error = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

}  // namespace

Method arcs_method() {
  Method method;
  method.id = "arcs";
  method.title = "arcs alone";
  method.finds_boundary = true;
  method.run = run_arcs;
  return method;
}

}  // namespace rimline::bench
